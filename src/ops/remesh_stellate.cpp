// Pyramids on faces: stellation, and star, which stellates twice.
#include "ops/remesh.h"
#include "ops/remesh_divide.h"
#include "ops/remesh_points.h"

#include <optional>
#include <vector>

namespace druse {

namespace {

using namespace remesh;

/// A triangle on each side of each face, to a point over its middle: V + F vertices, 3E edges, 2E faces. Source: Conway's kis.
struct Stellate {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.corner[0] = polygon(1, old_vertex, old_vertex(on), face_point);
        return s;
    }();

    double height = 0;

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        write_old_vertices(old, to.old_vertex);
        for_each_face(old, progress, [&](std::uint32_t f, std::uint32_t, std::uint32_t) { to.face_point[f] = mean(old, f) + height * normal(old, f); });
    }
};

/// Stellation, and then once more into each triangle's middle: V + 2E + F vertices, 9E edges, 6E faces, those on old edges group 1, the
/// inner ones 2. Then the middles of the faces move by `offset` along the normals. Source: TopMod.
struct Star {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.corner[0] = polygon(1, old_vertex, old_vertex(on), corner_point);
        s.corner[1] = polygon(2, old_vertex(on), face_point, corner_point);
        s.corner[2] = polygon(2, old_vertex, corner_point, face_point);
        return s;
    }();

    double offset = 0;

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        write_old_vertices(old, to.old_vertex);
        for_each_face(old, progress, [&](std::uint32_t f, std::uint32_t begin, std::uint32_t end) {
            const Point center = mean(old, f);
            for (std::uint32_t c = begin; c < end; ++c) to.corner_point[c] = (old.position(c) + old.position(old.on(c)) + center) / 3.0;
            to.face_point[f] = center + offset * normal(old, f);
        });
    }
};

struct Stellation : Remeshing<Stellate> {
    std::optional<int> only;
};

/// Only faces with so many sides (their triangles are group 1, the faces left as they are group 2). With N sides, F_N faces of them:
/// V + F_N vertices, E + N·F_N edges, F + (N − 1)·F_N faces.
Mesh stellated_where(const Mesh& mesh, std::uint32_t sides, double height, RemeshGroups groups, Progress& progress)
{
    const OldMesh old(mesh, 2);
    std::vector<FaceDivider::Triangle> fan;
    for (std::uint32_t i = 0; i < sides; ++i) fan.push_back({i, i + 1 < sides ? i + 1 : 0, sides});
    FaceDivider divider(old, groups);
    for_each_face(old, progress, [&](std::uint32_t f, std::uint32_t begin, std::uint32_t end) {
        const Point tip = mean(old, f) + height * normal(old, f);
        if (end - begin == sides) divider.divide(f, 1, fan, &tip);
        else divider.keep(f, 2);
    });
    return divider.build();
}

Mesh stellated_where(const Mesh& mesh, const Stellation& p, Progress& progress)
{
    const auto sides = static_cast<std::uint32_t>(*p.only);
    std::uint64_t found = 0;
    for (const Face f : mesh.faces()) found += std::uint32_t(mesh.valence(f)) == sides ? 1 : 0;
    refuse_too_large_where(mesh.edge_count(), sides, found, p.iterations);
    Mesh result = stellated_where(mesh, sides, p.height, p.groups, progress);
    for (int i = 1; i < p.iterations; ++i) result = stellated_where(result, sides, p.height, p.groups, progress);
    return result;
}

void stellate(Scene& scene, const Stellation& p, Context& context)
{
    scene.mesh.replace_with(p.only ? stellated_where(scene.mesh, p, context.progress)
                                   : remeshed<Stellate>(scene.mesh, p, p.iterations, p.groups, context.progress));
    scene.selection.edit() = Selection();
}

} // namespace

void add_remesh_stellate(Registry& registry)
{
    auto stellation = define<Stellation>("remesh.stellate", "Put a pyramid on each face");
    stellation.param(&Stellation::height, "height", Unit::length, {-1e6, 1e6}, "of the pyramids")
        .param(&Stellation::only, "only", Unit::count, {3, 100}, "faces with so many sides; otherwise all of them")
        .alias("remesh.kis")
        .example("remesh.stellate height=0.2")
        .cites("Conway, Burgiel & Goodman-Strauss 2008, ch. 21");
    add_shared_parameters(stellation);
    registry.add(stellation.keeps_euler().run(stellate).keeps_runs_by(keep_run_of<Stellate, Stellation>));

    auto star = define_remeshing<Star>("remesh.star", "Put a pyramid on each face, and one on each of its sides");
    star.param(&Star::offset, "offset", Unit::length, {-1e6, 1e6}, "how far the middles of the faces rise").example("remesh.star offset=0.3").cites(
        "Akleman, Chen & Srinivasan 2003");
    registry.add(complete(star));
}

} // namespace druse
