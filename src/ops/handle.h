#pragma once

#include "ops/pipe.h"

#include <vector>

namespace druse {

enum class HandleCurve { hermite, line };
enum class HandleSide { automatic, out, in };

struct HandleShape {
    int segments = 8;
    HandleCurve curve = HandleCurve::hermite;
    double weight = 1, weight2 = 1;
    HandleSide side = HandleSide::automatic;
    int twist = 0;
    double scale = 1, middle = 0.5;
};

/// Where a handle runs: stations at equal distances along its curve, with a frame that turns about the curve as little as it can, and the two
/// faces as these frames see them.
/// Source: Srinivasan, Akleman & Chen 2002; Wang, Jüttler, Zheng & Liu 2008, for the frames.
class HandlePath {
public:
    /// @throws CommandError where the faces have the same centre, or no normal that the curve could follow
    HandlePath(const PipeFaces& faces, const HandleShape& shape);

    /// The corners of the two faces in the first and the last frame: two places across the curve, and one along it.
    const std::vector<Point>& from_points() const { return from_; }
    const std::vector<Point>& to_points() const { return to_; }

    /// The points at each station, one for each rung; the first and the last are those of the faces. The band turns, grows and shrinks evenly.
    std::vector<std::vector<Point>> rings(std::span<const Rung> rungs) const;

    int segments() const { return shape_.segments; }
    const Vector& axis(int station) const { return stations_[std::size_t(station)].axis; }

private:
    struct Station {
        Point centre;
        Vector axis, x, y; // along the curve, and across
    };
    void follow(const Point& c0, const Vector& t0, const Point& c1, const Vector& t1);
    void straight(const Point& c0, const Point& c1);
    void carry_frame(const Vector& first_x);

    HandleShape shape_;
    std::vector<Station> stations_;
    std::vector<Point> from_, to_;
};

/// A band of `segments` pipes between two faces: V + k(s − 1), E + k(2s − 1), F + ks − 2 for s segments and k rungs, χ − 2.
/// @return the walls, segment after segment
std::vector<Face> create_handle(Mesh& mesh, const PipeFaces& faces, const HandlePath& path, std::span<const Rung> rungs);

/// Stations at which a ring cuts into the one before: the curve bends more tightly there than the ring is wide.
std::vector<int> tight_stations(const HandlePath& path, const std::vector<std::vector<Point>>& rings);

/// What topology.handle would make, as lines before it is made: its rungs, segment after segment. @throws what topology.handle would throw
std::vector<std::array<Point, 2>> preview_handle(const Mesh& mesh, const PipeEnds& ends, const HandleShape& shape, Progress& progress);

Operator handle_operator();

/// preview_pipe() or preview_handle(), with parameters that `op.make()` made; no lines for other operators.
std::vector<std::array<Point, 2>> preview_band(const Operator& op, const void* parameters, const Mesh& mesh, Progress& progress);

} // namespace druse
