#include "ops/remesh_loop.h"

#include "geom/turn.h"
#include "ops/remesh.h"
#include "ops/remesh_points.h"

namespace druse {

namespace {

using namespace remesh;

double weight_of_loop_neighbours(int m)
{
    const double x = 0.375 + 0.25 * turn(1, m).x;
    return 0.625 - x * x;
}

struct Subdivide : Loop {
    Subdivide() : Loop{false} {}
};

} // namespace

void Loop::place(const OldMesh& old, const NewPoints& to, Progress& progress) const
{
    if (!smooth) {
        write_edge_midpoints(old, to.edge_point);
        write_old_vertices(old, to.old_vertex);
        return;
    }
    // Each side adds 3/8 of its start and 1/8 of what lies opposite in its face.
    std::fill_n(to.edge_point, old.edges(), Point(0.0));
    for_each_face(old, progress, [&](std::uint32_t, std::uint32_t begin, std::uint32_t end) {
        const std::uint32_t n = end - begin;
        if (n == 3) {
            for (std::uint32_t c = begin; c < end; ++c) to.edge_point[old.edge(c)] += 0.375 * old.position(c) + 0.125 * old.position(old.back(c));
            return;
        }
        Vector sum(0.0);
        for (std::uint32_t c = begin; c < end; ++c) sum += old.position(c);
        for (std::uint32_t c = begin; c < end; ++c)
            to.edge_point[old.edge(c)] += 0.375 * old.position(c) + (0.125 / double(n - 2)) * (sum - old.position(c) - old.position(old.on(c)));
    });
    write_relaxed_vertices(old, weight_of_loop_neighbours, to.old_vertex);
}

void add_remesh_loop(Registry& registry)
{
    auto loop = define_remeshing<Loop>("remesh.loop", "Divide each face at the middles of its sides, and smooth");
    loop.param(&Loop::smooth, "smooth", "move the old vertices and edge points; otherwise edges are halved").example("remesh.loop iterations=2").cites("Loop 1987");
    registry.add(complete(loop));

    auto subdivide = define_remeshing<Subdivide>("remesh.subdivide", "Divide each face at the middles of its sides, and leave the shape as it is");
    subdivide.example("remesh.subdivide iterations=2").cites("Conway, Burgiel & Goodman-Strauss 2008, ch. 21");
    registry.add(complete(subdivide));
}

} // namespace druse
