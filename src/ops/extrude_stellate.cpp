// TopMod's pyramids: an apex straight over the middle of the face, at an absolute direction instead of an angle.
#include "ops/extrude.h"

namespace druse {

namespace {

Point vertex_mean(const BaseFrame& base)
{
    Vector sum(0.0);
    for (const Point& p : base.foot) sum += p;
    return sum / double(base.n);
}

/// One apex over the vertex mean, along the normal: V + 1, E + n, F + n − 1, no top.
struct Stellate {
    static constexpr bool mitred = false, has_top = false;
    static constexpr double angle = 90;
    double height = 1;

    Tiling tiling() const
    {
        Tiling tile;
        const auto b = tile.base(), apex = tile.apex();
        tile.row({b(0), b(1), apex(0)});
        return tile;
    }
    void place(const BaseFrame& base, Point* tiers, Vector*) const { tiers[0] = vertex_mean(base) + height * base.edge * base.normal; }
};

/// The same, and each of the flat face's triangles stellated at its own middle first: V + n + 1, E + 4n, F + 3n − 1, no top.
struct DoubleStellate {
    static constexpr bool mitred = false, has_top = false;
    static constexpr double angle = 90;
    double height = 1;

    Tiling tiling() const
    {
        Tiling tile;
        const auto b = tile.base(), s = tile.tier(), apex = tile.apex();
        tile.row({b(0), b(1), s(0)});
        tile.row({b(1), apex(0), s(0)});
        tile.row({apex(0), b(0), s(0)});
        return tile;
    }
    void place(const BaseFrame& base, Point* tiers, Vector*) const
    {
        const Point middle = vertex_mean(base);
        for (int i = 0; i < base.n; ++i) tiers[i] = (base.foot[i] + base.foot[i + 1] + middle) / 3.0;
        tiers[base.n] = middle + height * base.edge * base.normal;
    }
};

template <class Kernel>
Operator stellation(std::string name, std::string help)
{
    using P = ExtrusionParameters<Kernel>;
    return define_untilted_extrusion<Kernel>(name, std::move(help))
        .param(&P::height, "height", Unit::ratio, nonzero(-100, 100), "of the apex over the face, in mean lengths of the base edges")
        .example(name + " faces=all height=0.5")
        .cites("Akleman, Chen & Srinivasan 2003");
}

} // namespace

Operator extrude_stellate_operator() { return stellation<Stellate>("extrude.stellate", "Raise a pyramid straight over the middle of each face"); }

Operator extrude_double_stellate_operator()
{
    return stellation<DoubleStellate>("extrude.double_stellate", "Raise a pyramid of folded triangles over the middle of each face");
}

} // namespace druse
