#include "ops/remesh_catmull_clark.h"

#include "ops/remesh.h"
#include "ops/remesh_points.h"

namespace druse {

void CatmullClark::place(const remesh::OldMesh& old, const remesh::NewPoints& to, Progress& progress) const
{
    if (!smooth) {
        write_face_means(old, to.face_point, progress);
        write_edge_midpoints(old, to.edge_point);
        write_old_vertices(old, to.old_vertex);
        return;
    }
    const std::span<const Point> from = old.positions();
    // m²·(Q + 2R)/m is the sum, over the corners, of the face point and both ends of the side that starts there.
    std::fill_n(to.old_vertex, old.vertices(), Point(0.0));
    for_each_face(old, progress, [&](std::uint32_t f, std::uint32_t begin, std::uint32_t end) {
        const Point middle = to.face_point[f] = mean(old, f);
        for (std::uint32_t c = begin; c < end; ++c) to.old_vertex[old.vertex(c)] += middle + old.position(old.on(c)) + old.position(c);
    });
    for (std::uint32_t e = 0; e < old.edges(); ++e) {
        const std::uint32_t a = old.corner_of_side(2 * e), b = old.corner_of_side(2 * e + 1);
        to.edge_point[e] = 0.25 * ((from[old.vertex(a)] + from[old.vertex(b)]) + (to.face_point[old.face(a)] + to.face_point[old.face(b)]));
    }
    for (std::uint32_t v = 0; v < old.vertices(); ++v) {
        const double m = old.valence(v);
        to.old_vertex[v] = to.old_vertex[v] / (m * m) + ((m - 3.0) / m) * from[v];
    }
}

namespace {

struct Linear : CatmullClark {
    Linear() : CatmullClark{false} {}
};

} // namespace

void add_remesh_catmull_clark(Registry& registry)
{
    auto smooth = define_remeshing<CatmullClark>("remesh.catmull_clark", "Make a quad in each corner, and smooth");
    smooth.param(&CatmullClark::smooth, "smooth", "move the old vertices and edge points; otherwise edges are halved")
        .example("remesh.catmull_clark iterations=2")
        .cites("Catmull & Clark 1978");
    registry.add(complete(smooth));

    auto linear = define_remeshing<Linear>("remesh.linear", "Make a quad in each corner, and leave the shape as it is");
    linear.alias("remesh.ortho").example("remesh.linear iterations=2").cites("Conway, Burgiel & Goodman-Strauss 2008, ch. 21");
    registry.add(complete(linear));
}

} // namespace druse
