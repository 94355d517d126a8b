// Schemes named after how much finer they are: root 3, with needle, which is the same without smoothing, and root 4, with chamfer.
#include "geom/cut_corners.h"
#include "geom/turn.h"
#include "ops/remesh.h"
#include "ops/remesh_points.h"

namespace druse {

namespace {

using namespace remesh;

double weight_of_root_neighbours(int m) { return (4.0 - 2.0 * turn(1, m).x) / 9.0; }

/// Two triangles over each edge, each between one of its ends and points in both its faces: V + F vertices, 3E edges, 2E faces.
/// Smoothing moves a vertex of valence m the fraction (4 − 2 cos(2π/m))/9 of the way to the mean of its neighbours; without it this is
/// TopMod's root 3 and Conway's needle. Source: Kobbelt, *√3-subdivision* (2000), there for triangles.
struct Root3 {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.side[0] = polygon(1, old_vertex, face_point(across), face_point);
        return s;
    }();

    bool smooth = true;

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        write_face_means(old, to.face_point, progress);
        if (smooth) write_relaxed_vertices(old, weight_of_root_neighbours, to.old_vertex);
        else write_old_vertices(old, to.old_vertex);
    }
};
struct Needle : Root3 {
    Needle() : Root3{false} {}
};

/// Every face shrinks (group 1), every edge opens to a hexagon that keeps its ends (group 2): V + 2E vertices, 4E edges, E + F faces.
/// The inner points are means of the points at the fraction `twist` of the sides; old vertices go the fraction `weight` of the way to
/// the mean of the inner points around them. Source: TopMod, which calls it dual loop style.
struct Root4 {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.face = polygon(1, corner_point);
        s.edge = polygon(2, old_vertex, corner_point(across, on), corner_point(across));
        return s;
    }();

    double weight = 0, twist = 0;

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        CornerCutter cutter;
        std::fill_n(to.old_vertex, old.vertices(), Point(0.0));
        for_each_face(old, progress, [&](std::uint32_t, std::uint32_t begin, std::uint32_t end) {
            const int n = static_cast<int>(end - begin);
            cutter.cut(n, honeycomb_weight(n), [&](int i) { return along(old, begin + std::uint32_t(i), twist); },
                       [&](int i, const Point& p) { to.corner_point[begin + std::uint32_t(i)] = p; });
            for (std::uint32_t c = begin; c < end; ++c) to.old_vertex[old.vertex(c)] += to.corner_point[c];
        });
        for (std::uint32_t v = 0; v < old.vertices(); ++v) {
            const Point& at = old.positions()[v];
            to.old_vertex[v] = at + weight * (to.old_vertex[v] / double(old.valence(v)) - at);
        }
    }
};
/// The same with faces that keep their shape and shrink to the fraction `s`. Source: Conway, Hart.
struct Chamfer {
    static constexpr const Scheme& scheme = Root4::scheme;

    double s = 0.5;

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        write_old_vertices(old, to.old_vertex);
        write_inner_points(old, s, [&](std::uint32_t c) { return old.position(c); }, to.corner_point, progress);
    }
};

} // namespace

void add_remesh_root(Registry& registry)
{
    auto root3 = define_remeshing<Root3>("remesh.sqrt3", "Put two triangles across every edge, and smooth");
    root3.param(&Root3::smooth, "smooth", "move the old vertices").example("remesh.sqrt3 iterations=2").cites("Kobbelt 2000");
    registry.add(complete(root3));

    auto needle = define_remeshing<Needle>("remesh.needle", "Put two triangles across every edge");
    needle.example("remesh.needle").cites("Conway, Burgiel & Goodman-Strauss 2008, ch. 21");
    registry.add(complete(needle));

    auto root4 = define_remeshing<Root4>("remesh.root4", "Shrink and round the faces, and open every edge to a hexagon");
    root4.param(&Root4::weight, "weight", Unit::ratio, {0, 1}, "how far the old vertices move inwards")
        .param(&Root4::twist, "twist", Unit::ratio, {0, 1}, "how far the faces turn, in sides")
        .example("remesh.root4 weight=0.5")
        .cites("Akleman & Srinivasan 2002");
    registry.add(complete(root4));

    auto chamfer = define_remeshing<Chamfer>("remesh.chamfer", "Shrink the faces and open every edge to a hexagon");
    chamfer.param(&Chamfer::s, "s", Unit::ratio, between(0, 1), "size of the old faces, as a fraction")
        .example("remesh.chamfer s=0.6")
        .cites("Hart 1998");
    registry.add(complete(chamfer));
}

} // namespace druse
