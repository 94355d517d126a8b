#include "ops/remesh_checkerboard.h"

#include "ops/remesh.h"
#include "ops/remesh_points.h"

namespace druse {

void Checkerboard::place(const remesh::OldMesh& old, const remesh::NewPoints& to, Progress& progress) const
{
    remesh::write_old_vertices(old, to.old_vertex);
    remesh::for_each_face(old, progress, [&](std::uint32_t, std::uint32_t begin, std::uint32_t end) {
        const Point origin = old.position(begin);
        Vector normal(0.0); // Newell's, about the first corner
        for (std::uint32_t c = begin + 1; c + 1 < end; ++c) normal += glm::cross(old.position(c) - origin, old.position(c + 1) - origin);
        for (std::uint32_t c = begin; c < end; ++c) {
            const Point v = old.position(c);
            const Vector before = old.position(old.back(c)) - v, after = old.position(old.on(c)) - v;
            to.side_point[old.side(c)] = v + t * after;
            // A straight corner counts as convex, whatever the last digits say.
            const double turning = glm::dot(glm::cross(-before, after), normal);
            const double least = -1e-12 * glm::length(before) * glm::length(after) * glm::length(normal);
            to.corner_point[c] = v + (turning < least ? -t : t) * (before + after);
        }
    });
}

void add_remesh_checkerboard(Registry& registry)
{
    auto definition = define_remeshing<Checkerboard>("remesh.checkerboard", "Make a smaller face in a frame of quads of every face");
    definition.param(&Checkerboard::t, "t", Unit::ratio, between(0, 0.5), "where edges are cut, as a fraction of their length from each end")
        .example("remesh.checkerboard t=0.25")
        .cites("Landreneau 2005, III.5, fig. 18");
    registry.add(complete(definition));
}

} // namespace druse
