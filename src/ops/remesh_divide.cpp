#include "ops/remesh_divide.h"

#include "dlfl/errors.h"

#include <algorithm>
#include <tuple>

namespace druse::remesh {

FaceDivider::FaceDivider(const OldMesh& old, RemeshGroups groups) : old_(old), groups_(groups), side_of_(old.corners())
{
    group_of_.reserve(old.faces());
    for (const Point& p : old.positions()) to_.add_vertex(p);
}

std::uint32_t FaceDivider::add_corner(std::uint32_t vertex)
{
    const std::uint32_t corner = to_.corner_count();
    to_.add_corner(vertex);
    to_.add_to_face(corner);
    return corner;
}

void FaceDivider::end_face(std::uint32_t f, int group)
{
    to_.end_face();
    group_of_.push_back(groups_ == RemeshGroups::absolute ? group : groups_ == RemeshGroups::keep ? old_.group(f) : 0);
}

void FaceDivider::keep(std::uint32_t f, int group)
{
    for (std::uint32_t c = old_.begin(f); c < old_.end(f); ++c) side_of_[c] = add_corner(old_.vertex(c));
    end_face(f, group);
}

void FaceDivider::divide(std::uint32_t f, int group, std::span<const Triangle> triangles, const Point* center)
{
    const std::uint32_t begin = old_.begin(f), n = old_.end(f) - begin, inside = to_.vertex_count();
    if (center) to_.add_vertex(*center);
    inner_.clear();
    for (const Triangle& triangle : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t i = triangle[k], j = triangle[(k + 1) % 3];
            const std::uint32_t corner = add_corner(i < n ? old_.vertex(begin + i) : inside);
            if (i < n && j == (i + 1 < n ? i + 1 : 0)) side_of_[begin + i] = corner;
            else inner_.push_back({std::min(i, j), std::max(i, j), corner});
        }
        end_face(f, group);
    }
    std::ranges::sort(inner_, {}, [](const Inner& s) { return std::tuple(s.low, s.high, s.corner); });
    for (std::size_t i = 0; i < inner_.size(); i += 2) {
        ASSERT(i + 1 < inner_.size() && inner_[i].low == inner_[i + 1].low && inner_[i].high == inner_[i + 1].high, "every inner side belongs to two triangles");
        to_.add_edge(inner_[i].corner, inner_[i + 1].corner);
    }
}

Mesh FaceDivider::build()
{
    for (std::uint32_t side = 0; side < old_.corners(); side += 2) to_.add_edge(side_of_[old_.corner_of_side(side)], side_of_[old_.corner_of_side(side + 1)]);
    Repairs repairs;
    return to_.assemble(group_of_, repairs);
}

} // namespace druse::remesh
