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
    // Each side adds 3/8 of its start and 1/8 of what lies opposite in its face to its edge, and its end to the neighbours of its start.
    std::fill_n(to.edge_point, old.edges(), Point(0.0));
    std::fill_n(to.old_vertex, old.vertices(), Point(0.0));
    for_each_face(old, progress, [&](std::uint32_t, std::uint32_t begin, std::uint32_t end) {
        const std::uint32_t n = end - begin;
        if (n == 3) {
            const Point &a = old.position(begin), &b = old.position(begin + 1), &c = old.position(begin + 2);
            to.edge_point[old.edge(begin)] += 0.375 * a + 0.125 * c;
            to.edge_point[old.edge(begin + 1)] += 0.375 * b + 0.125 * a;
            to.edge_point[old.edge(begin + 2)] += 0.375 * c + 0.125 * b;
            to.old_vertex[old.vertex(begin)] += b;
            to.old_vertex[old.vertex(begin + 1)] += c;
            to.old_vertex[old.vertex(begin + 2)] += a;
            return;
        }
        Vector sum(0.0);
        for (std::uint32_t c = begin; c < end; ++c) sum += old.position(c);
        for (std::uint32_t c = begin; c < end; ++c) {
            const Point &start = old.position(c), &after = old.position(old.on(c));
            to.edge_point[old.edge(c)] += 0.375 * start + (0.125 / double(n - 2)) * (sum - start - after);
            to.old_vertex[old.vertex(c)] += after;
        }
    });
    relax_from_sums(old, weight_of_loop_neighbours, to.old_vertex);
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
