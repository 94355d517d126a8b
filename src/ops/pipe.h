#pragma once

#include "ops/operator.h"
#include "ops/pipe_pairing.h"

#include <array>
#include <span>
#include <vector>

namespace druse {

/// The corner of an edge that starts at one of its two ends, which differ.
Corner corner_from(const Mesh& mesh, Edge e, Vertex v);

/// Puts a vertex into the side that starts at `out`: V + 1, E + 1. The faces beside it keep ids, groups and start corners.
/// Preconditions: not on an open boundary, not a loop, two different faces beside it, no holes. @return the corner of the new vertex in the face of `out`,
/// which still starts at its vertex
Corner split_side(Mesh& mesh, Corner out, const Point& p);

/// Takes two faces away and joins their boundaries by a band of walls: MeshTables::join_faces. Keeps scratch memory from call to call.
class PipeMaker {
public:
    explicit PipeMaker(Mesh& mesh) : mesh_(mesh) {}

    /// Joins the faces of `from` and `to`, corners counted from there on. The rungs are as pair_corners() makes them. Adds the walls in order.
    /// Cost: O(sides).
    void create(Corner from, Corner to, std::span<const Rung> rungs, std::vector<Face>& walls);

    /// The same for faces with n corners each: corner i meets corner −i.
    void create_facing(Corner from, Corner to, std::vector<Face>& walls);

private:
    void read(Corner from, Corner to);

    Mesh& mesh_;
    std::vector<Corner> from_, to_;
    std::vector<Rung> facing_;
};

/// Two faces can be joined by a band. @throws CommandError that names what is in the way
void require_pipe_end(const Mesh& mesh, Face f);                        // three corners or more, no vertex twice
void require_apart(const Mesh& mesh, Face from, Face to);               // different faces without a common vertex

/// New side walls become all that is selected, and one group: first_new_group() from before the faces went that they take the place of.
void select_walls(Scene& scene, std::vector<Face> walls, int group);

// --- as commands say it -------------------------------------------------------------------------------------------------------

enum class Unequal { mix, split, error };

/// What topology.pipe and topology.handle have in common.
struct PipeEnds {
    FaceId from, to;
    OrWord<std::array<int, 2>> corners = "auto";
    int shift = 0;
    Unequal unequal = Unequal::mix;

};

struct PipeParameters : PipeEnds {
    int segments = 1;
};

/// The two faces that a command is going to join, checked and measured; `unequal=split` has its vertices among the points.
class PipeFaces {
public:
    /// @throws CommandError where they cannot be joined; a common vertex does no harm yet
    PipeFaces(const Mesh& mesh, const PipeEnds& ends);

    Face from, to;
    std::vector<Point> from_points, to_points; // in face order, from the start corners
    Pairing pairing;

    /// Makes the vertices of `unequal=split`.
    void split(Mesh& mesh) const;

private:
    std::vector<int> splits_; // sides of the face with fewer, one after the other, counted with the vertices that came before
};

/// The rungs that topology.pipe would make, as lines, before it is made.
/// @throws what topology.pipe would throw
std::vector<std::array<Point, 2>> preview_pipe(const Mesh& mesh, const PipeEnds& ends, Progress& progress);

Operator pipe_operator();

/// Adds the parameters of PipeEnds.
template <class P>
void add_pipe_ends(Definition<P>& definition)
{
    definition.param(&P::from, "from", "the face where it begins")
        .required()
        .param(&P::to, "to", "the face where it ends")
        .required()
        .param(&P::corners, "corners", Unit::count, at_least(0), words({"auto"}),
               "the corner of each face that the first rung joins, from 0 at the start corner; auto: the least twist")
        .param(&P::shift, "shift", Unit::count, {-2147483647, 2147483647}, "turn the band on by so many corners; for faces with equally many")
        .param(&P::unequal, "unequal", words({"mix", "split", "error"}),
               "faces with different numbers of sides: quads and triangles, or more vertices on the longest sides, or refuse");
}

} // namespace druse
