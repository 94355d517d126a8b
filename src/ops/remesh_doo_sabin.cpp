#include "ops/remesh_doo_sabin.h"

#include "geom/cut_corners.h"
#include "ops/remesh.h"
#include "ops/remesh_points.h"

namespace druse {

namespace {

using namespace remesh;

/// Each corner of a face becomes Σ_j W(n, i, j; alpha(n)) v_j.
template <class Alpha>
void cut_corners(const OldMesh& old, Alpha&& alpha, Point* to, Progress& progress)
{
    CornerCutter cutter;
    for_each_face(old, progress, [&](std::uint32_t, std::uint32_t begin, std::uint32_t end) {
        const int n = static_cast<int>(end - begin);
        cutter.cut(n, alpha(n), [&](int i) { return old.position(begin + std::uint32_t(i)); }, [&](int i, const Point& p) { to[begin + std::uint32_t(i)] = p; });
    });
}

/// The faces of Doo and Sabin with a weight of choice for the own corner. Source: TopMod.
struct CornerCutting : DooSabin {
    double alpha = 0.5625;

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        cut_corners(old, [this](int) { return alpha; }, to.corner_point, progress);
    }
};

/// The same faces; the old ones keep their shape and shrink to the fraction `s`. For some s the edge quads of a Platonic solid become
/// squares: √2 − 1 for the cube, 1/4 for the tetrahedron.
struct Expand : DooSabin {
    double s = 0.5;

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        write_inner_points(old, s, [&](std::uint32_t c) { return old.position(c); }, to.corner_point, progress);
    }
};

} // namespace

void DooSabin::place(const OldMesh& old, const NewPoints& to, Progress& progress) const
{
    cut_corners(old, CornerCutter::doo_sabin, to.corner_point, progress);
}

void add_remesh_doo_sabin(Registry& registry)
{
    auto doo_sabin = define_remeshing<DooSabin>("remesh.doo_sabin", "Shrink the faces and open a face on every edge and vertex");
    doo_sabin.example("remesh.doo_sabin iterations=2").cites("Doo & Sabin 1978");
    registry.add(complete(doo_sabin));

    auto cutting = define_remeshing<CornerCutting>("remesh.corner_cutting", "Cut corners as Doo and Sabin do, by an amount of choice");
    cutting.param(&CornerCutting::alpha, "alpha", Unit::ratio, {1.0 / 3.0, 0.999}, "weight of a corner in its new place; the others share the rest")
        .example("remesh.corner_cutting alpha=0.7")
        .cites("Doo & Sabin 1978");
    registry.add(complete(cutting));

    auto expand = define_remeshing<Expand>("remesh.expand", "Shrink the faces towards their middles and open a face on every edge and vertex");
    expand.param(&Expand::s, "s", Unit::ratio, between(0, 1), "size of the old faces, as a fraction")
        .example("remesh.expand s=0.414213562373095")
        .cites("Conway, Burgiel & Goodman-Strauss 2008, ch. 21");
    registry.add(complete(expand));
}

} // namespace druse
