#pragma once

#include "dlfl/triangulate.h"
#include "io/coincident_edges.h"
#include "io/model.h"
#include "io/output_files.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace druse {

/// A mesh for a format of triangles between numbered points: the vertices keep their numbers, behind them come the points that divide edges upon each
/// other. Triangles go by group, those of a group in the order of the faces.
class IndexedTriangles {
public:
    using Triangle = std::array<std::uint32_t, 3>;

    /// Notes what does not go into the file. `format` is what notes call it.
    /// @throws InputError if there is no triangle
    IndexedTriangles(const ModelView& model, OutputFiles& out, std::string format);

    /// The ids of groups, ascending; empty where nobody grouped: then all triangles are of one part.
    const std::vector<int>& groups() const { return groups_; }
    std::size_t part_count() const { return ends_.size(); }
    std::uint64_t begin(std::size_t part) const { return part == 0 ? 0 : ends_[part - 1]; }
    std::uint64_t end(std::size_t part) const { return ends_[part]; }
    std::uint64_t count() const { return ends_.back(); }

    std::uint32_t point_count() const { return mesh_.vertex_count() + static_cast<std::uint32_t>(added_.size()); }
    const Point& point(std::uint32_t p) const { return p < mesh_.vertex_count() ? mesh_.position(Vertex(p)) : added_[p - mesh_.vertex_count()]; }
    /// In single precision.
    /// @throws InputError where the point is too far for that
    std::array<float, 3> place(std::uint32_t p) const;

    /// Writes all of them in their order, three numbers of 32 bits each, as they lie in memory. Cost: O(faces).
    void put(unsigned char* to);

private:
    std::size_t part_of(Face f) const;
    std::uint64_t divide(Face f);
    std::uint32_t number(Face f, const Point& p);

    const Mesh& mesh_;
    OutputFiles& out_;
    std::string format_;
    std::vector<int> groups_;
    CoincidentEdges coincident_;
    Triangulator triangulator_;
    std::vector<Triangle> divided_;         // of faces that these concern, one after the other,
    std::vector<std::size_t> divided_ends_; // and where those of each end
    std::vector<Point> added_;              // to the vertices, for those
    std::map<std::array<float, 3>, std::uint32_t> number_; // of an added point
    std::vector<std::uint64_t> ends_;       // by part
};

} // namespace druse
