// Vertices and faces that change places: the dual, and join, the dual of ambo.
#include "ops/remesh.h"
#include "ops/remesh_points.h"

#include <fmt/format.h>

#include <cmath>

namespace druse {

namespace {

using namespace remesh;

/// A vertex in each face, a face on each vertex: F vertices, E edges, V faces. The dual of the dual is connected as the model was.
///
/// Vertices are the means of the faces' corners; `polar`, the poles of the faces' planes on a sphere about the mean of all vertices,
/// through the middles of the edges on average. Then the new faces of a convex model are flat. Source: Hart, *Conway notation*.
struct Dual {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.vertex = polygon(1, face_point);
        return s;
    }();

    bool polar = false;

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        write_face_means(old, to.face_point, progress);
        if (!polar) return;
        Vector sum(0.0);
        for (const Point& p : old.positions()) sum += p;
        const Point center = sum / double(old.vertices());
        double radius = 0.0;
        for (std::uint32_t e = 0; e < old.edges(); ++e) radius += glm::distance(along(old, old.corner_of_side(2 * e), 0.5), center) / old.edges();
        for_each_face(old, progress, [&](std::uint32_t f, std::uint32_t, std::uint32_t) {
            const Vector n = normal(old, f);
            const double distance = glm::dot(to.face_point[f] - center, n);
            if (!(std::abs(distance) >= 1e-9 * radius && distance != 0.0)) throw CommandError(fmt::format("face {} passes through the centre", f));
            to.face_point[f] = center + radius * (radius / distance) * n;
        });
    }
};

/// A quad over each edge, between its ends and a point in each of its faces: V + F vertices, 2E edges, E faces. It is stellation with
/// the old edges taken away. Source: Conway; the points are the means of the faces' corners.
struct Join {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.edge = polygon(1, old_vertex, face_point(across));
        return s;
    }();

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        write_old_vertices(old, to.old_vertex);
        write_face_means(old, to.face_point, progress);
    }
};

} // namespace

void add_remesh_dual(Registry& registry)
{
    auto dual = define_remeshing<Dual>("remesh.dual", "Make a vertex of every face and a face of every vertex");
    dual.param(&Dual::polar, "polar", "put the vertices where the faces of a convex model become flat")
        .example("remesh.dual polar=true")
        .cites("Conway, Burgiel & Goodman-Strauss 2008, ch. 21; Hart 1998");
    registry.add(complete(dual));

    auto join = define_remeshing<Join>("remesh.join", "Put a quad in place of every edge, between its ends and its faces' middles");
    join.example("remesh.join").cites("Conway, Burgiel & Goodman-Strauss 2008, ch. 21");
    registry.add(complete(join));
}

} // namespace druse
