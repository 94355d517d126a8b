// Vertices cut off: truncation, the honeycomb scheme, ambo between them, and bevel, which cuts off edges too.
#include "dlfl/mesh_assembler.h"
#include "geom/cut_corners.h"
#include "ops/remesh.h"
#include "ops/remesh_points.h"

#include <limits>
#include <optional>
#include <vector>

namespace druse {

namespace {

using namespace remesh;

/// Every n-gon becomes a 2n-gon (group 1), every vertex of valence m an m-gon (group 2): 2E vertices, 3E edges, V + F faces, all
/// valences 3. With t = 1/(2 + 2 cos(π/n)) regular n-gons become regular 2n-gons. If all faces are flat and all valences 3, all
/// faces stay flat. Source: Akleman, Edmundson & Özener, *A generalized vertex truncation scheme to construct intriguing polyhedral
/// shapes*; it says in passing that the vertices double from the second step on, but they stay threefold.
struct Truncate {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.face = polygon(1, side_point, side_point(across));
        s.vertex = polygon(2, side_point);
        return s;
    }();

    double t = 0.25;

    void place(const OldMesh& old, const NewPoints& to, Progress&) const { write_side_points(old, t, to.side_point); }
};

/// Every face is turned by half a side and shrinks (group 1), every vertex of valence m becomes a 2m-gon (group 2): 2E vertices, 3E
/// edges, V + F faces, all valences 3. Source: Akleman & Srinivasan, *Honeycomb subdivision* (2002), with TopMod's weights.
struct Honeycomb {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.face = polygon(1, corner_point);
        s.vertex = polygon(2, corner_point, corner_point(back));
        return s;
    }();

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        CornerCutter cutter;
        for_each_face(old, progress, [&](std::uint32_t, std::uint32_t begin, std::uint32_t end) {
            const int n = static_cast<int>(end - begin);
            cutter.cut(n, honeycomb_weight(n), [&](int i) { return along(old, begin + std::uint32_t(i), 0.5); },
                       [&](int i, const Point& p) { to.corner_point[begin + std::uint32_t(i)] = p; });
        });
    }
};

/// The middles of the edges, joined: E vertices, 2E edges, V + F faces, n-gons (group 1) and m-gons (group 2), all valences 4.
struct Ambo {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.face = polygon(1, edge_point);
        s.vertex = polygon(2, edge_point);
        return s;
    }();

    void place(const OldMesh& old, const NewPoints& to, Progress&) const { write_edge_midpoints(old, to.edge_point); }
};

/// Edges and vertices cut off: 4E vertices, 6E edges, V + E + F faces, 2n-gons (group 1), quads on edges (2) and 2m-gons (3). The two
/// points of a side lie at the fraction `t` from its ends, brought nearer to the middle of the face until `s` of the distance is left.
struct Bevel {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.face = polygon(1, corner_point, outer_point);
        s.edge = polygon(2, corner_point, outer_point(across));
        s.vertex = polygon(3, corner_point, outer_point(back));
        return s;
    }();

    double s = 0.666666666666667, t = 0.333333333333333;

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        write_inner_points(old, s, [&](std::uint32_t c) { return along(old, c, t); }, to.corner_point, progress);
        write_inner_points(old, s, [&](std::uint32_t c) { return along(old, old.across(c), t); }, to.outer_point, progress);
    }
};

struct Truncation : Remeshing<Truncate> {
    std::optional<int> only;
};

/// Only vertices of that valence are cut off. New vertices: the others, then the cuts, by side.
Mesh truncated_where(const Mesh& mesh, std::uint32_t valence, double t, RemeshGroups groups, Progress& progress)
{
    OldMesh old(mesh, 2);
    old.order_around();
    const auto is_cut = [&](std::uint32_t c) { return old.valence(old.vertex(c)) == valence; };
    const auto group = [&](std::uint32_t f, int absolute) { return groups == RemeshGroups::absolute ? absolute : groups == RemeshGroups::keep ? old.group(f) : 0; };

    MeshAssembler to;
    std::vector<std::uint32_t> kept(old.vertices()), cut(old.corners()); // new vertices, by old vertex and by side
    for (std::uint32_t v = 0; v < old.vertices(); ++v) {
        if (old.valence(v) == valence) continue;
        kept[v] = to.vertex_count();
        to.add_vertex(old.positions()[v]);
    }
    for (std::uint32_t side = 0; side < old.corners(); ++side) {
        const std::uint32_t c = old.corner_of_side(side);
        if (!is_cut(c)) continue;
        cut[side] = to.vertex_count();
        to.add_vertex(along(old, c, t));
    }

    const auto add_corner = [&](std::uint32_t vertex) {
        const std::uint32_t corner = to.corner_count();
        to.add_corner(vertex);
        to.add_to_face(corner);
        return corner;
    };
    std::vector<std::int32_t> group_of;
    std::vector<std::uint32_t> along_side(old.corners()), along_cut(old.corners()); // new corners, by old corner
    for_each_face(old, progress, [&](std::uint32_t f, std::uint32_t begin, std::uint32_t end) {
        // From the first corner's cut on its own side; the one on the side before comes last.
        for (std::uint32_t c = begin; c < end; ++c) {
            if (c > begin && is_cut(c)) along_cut[c] = add_corner(cut[old.side(old.around(c))]);
            along_side[c] = add_corner(is_cut(c) ? cut[old.side(c)] : kept[old.vertex(c)]);
        }
        if (is_cut(begin)) along_cut[begin] = add_corner(cut[old.side(old.around(begin))]);
        to.end_face();
        group_of.push_back(group(f, 1));
    });
    for (std::uint32_t at = 0, v = 0; v < old.vertices(); ++v) {
        const std::uint32_t end = at + old.valence(v);
        std::uint32_t face = std::numeric_limits<std::uint32_t>::max();
        for (; at < end; ++at) {
            const std::uint32_t c = old.corner_around(at);
            face = std::min(face, old.face(c));
            if (is_cut(c)) to.add_edge(along_cut[c], add_corner(cut[old.side(c)]));
        }
        if (old.valence(v) != valence) continue;
        to.end_face();
        group_of.push_back(group(face, 2));
    }
    for (std::uint32_t side = 0; side < old.corners(); side += 2) to.add_edge(along_side[old.corner_of_side(side)], along_side[old.corner_of_side(side + 1)]);
    Repairs repairs;
    return to.assemble(group_of, repairs);
}

Mesh truncated_where(const Mesh& mesh, const Truncation& p, Progress& progress)
{
    const auto valence = static_cast<std::uint32_t>(*p.only);
    std::uint64_t found = 0;
    for (const Vertex v : mesh.vertices()) found += std::uint32_t(mesh.valence(v)) == valence ? 1 : 0;
    refuse_too_large_where(mesh.edge_count(), valence, found, p.iterations);
    Mesh result = truncated_where(mesh, valence, p.t, p.groups, progress);
    for (int i = 1; i < p.iterations; ++i) result = truncated_where(result, valence, p.t, p.groups, progress);
    return result;
}

void truncate(Scene& scene, const Truncation& p, Context& context)
{
    scene.mesh.replace_with(p.only ? truncated_where(scene.mesh, p, context.progress)
                                   : remeshed<Truncate>(scene.mesh, p, p.iterations, p.groups, context.progress));
    scene.selection.edit() = Selection();
}

} // namespace

void add_remesh_truncate(Registry& registry)
{
    auto truncation = define<Truncation>("remesh.truncate", "Cut off the vertices");
    truncation.param(&Truncation::t, "t", Unit::ratio, between(0, 0.5), "where edges are cut, as a fraction of their length from each end")
        .param(&Truncation::only, "only", Unit::count, {3, 100}, "cut off vertices of this valence; otherwise all of them")
        .example("remesh.truncate t=0.333333333333333")
        .cites("Akleman, Edmundson & Özener 2005");
    add_shared_parameters(truncation);
    registry.add(truncation.keeps_euler().run(truncate).keeps_runs_by(keep_run_of<Truncate, Truncation>));

    auto honeycomb = define_remeshing<Honeycomb>("remesh.honeycomb", "Turn and shrink the faces, and put one with twice as many sides as it has edges on every vertex");
    honeycomb.alias("remesh.zip").example("remesh.honeycomb").cites("Akleman & Srinivasan 2002");
    registry.add(complete(honeycomb));

    auto ambo = define_remeshing<Ambo>("remesh.ambo", "Cut off the vertices as far as the middles of the edges");
    ambo.example("remesh.ambo").cites("Conway, Burgiel & Goodman-Strauss 2008, ch. 21");
    registry.add(complete(ambo));

    auto bevel = define_remeshing<Bevel>("remesh.bevel", "Cut off the edges and the vertices");
    bevel.param(&Bevel::s, "s", Unit::ratio, between(0, 1), "size of the old faces, as a fraction")
        .param(&Bevel::t, "t", Unit::ratio, between(0, 0.5), "where their sides are cut, as a fraction of the length from each end")
        .example("remesh.bevel s=0.8 t=0.3")
        .cites("Conway, Burgiel & Goodman-Strauss 2008, ch. 21");
    registry.add(complete(bevel));
}

} // namespace druse
