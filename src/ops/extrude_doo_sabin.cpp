// TopMod's rounded extrusions: tops that are the Doo–Sabin image of the face they rise from.
#include "geom/cut_corners.h"
#include "ops/extrude.h"

#include <array>

namespace druse {

namespace {

/// The base after one Doo–Sabin step: its corners slid along their edges by `twist` first, the result scaled about its mean.
class DooSabinStep {
public:
    explicit DooSabinStep(double twist) : twist_(twist) {}

    void make(Cycle<const Point> from, double scale, const Vector& lift, Cycle<Point> to)
    {
        const int n = from.size();
        cutter_.cut(
            n, CornerCutter::doo_sabin(n), [&](int i) { return from[i] + twist_ * (from[i + 1] - from[i]); }, [&](int i, const Point& p) { to[i] = p; });
        Vector sum(0.0);
        for (const Point& p : to) sum += p;
        const Point mean = sum / double(n);
        for (Point& p : to) p = mean + scale * (p - mean) + lift;
    }

private:
    double twist_;
    CornerCutter cutter_;
};

/// A prism whose top is a Doo–Sabin step of the base: V + n, E + 2n, F + n.
struct DooSabinExtrusion {
    static constexpr bool mitred = false, has_top = true;
    static constexpr double angle = 90;
    double height = 1, twist = 0, scale = 1;

    Tiling tiling() const
    {
        Tiling tile;
        const auto b = tile.base(), t = tile.tier();
        tile.top({t});
        tile.row({b(0), b(1), t(1), t(0)});
        return tile;
    }
    void place(const BaseFrame& base, Point* t, Vector*) const
    {
        DooSabinStep(twist).make(base.foot, scale, height * base.edge * base.normal, Cycle<Point>(t, base.n));
    }
};

/// Five such steps, lower and lower, and a pyramid on the last: V + 5n + 1, E + 11n, F + 6n − 1, no top.
struct Dome {
    static constexpr bool mitred = false, has_top = false;
    static constexpr double angle = 90;
    double height = 1, twist = 0, scale = 1;

    Tiling tiling() const
    {
        Tiling tile;
        auto below = tile.base();
        for (int k = 0; k < 5; ++k) {
            const auto t = tile.tier();
            tile.row({below(0), below(1), t(1), t(0)});
            below = t;
        }
        const auto apex = tile.apex();
        tile.row({below(0), below(1), apex(0)});
        return tile;
    }
    void place(const BaseFrame& base, Point* tiers, Vector*) const
    {
        constexpr std::array<double, 5> heights{0.3, 0.18, 0.1, 0.05, 0.025}, scales{1.7, 1.6, 1.4, 1.2, 1.1};
        const Vector up = height * base.edge * base.normal;
        DooSabinStep step(twist);
        Cycle<const Point> below = base.foot;
        for (int k = 0; k < 5; ++k) {
            const Cycle<Point> ring(tiers + k * base.n, base.n);
            step.make(below, scale * scales[std::size_t(k)], heights[std::size_t(k)] * up, ring);
            below = {ring.begin(), base.n};
        }
        Vector sum(0.0);
        for (const Point& p : below) sum += p;
        tiers[5 * base.n] = sum / double(base.n) + 0.01 * up;
    }
};

template <class Kernel>
Definition<ExtrusionParameters<Kernel>> rounded(std::string name, std::string help)
{
    using P = ExtrusionParameters<Kernel>;
    return define_untilted_extrusion<Kernel>(std::move(name), std::move(help))
        .param(&P::height, "height", Unit::ratio, nonzero(-100, 100), "of the block, in mean lengths of the base edges")
        .param(&P::twist, "twist", Unit::ratio, {-1, 1}, "how far corners slide along their edges before each step")
        .param(&P::scale, "scale", Unit::ratio, {0.01, 10}, "size of each top about its middle")
        .cites("Akleman, Chen & Srinivasan 2003");
}

} // namespace

Operator extrude_doo_sabin_operator()
{
    using P = ExtrusionParameters<DooSabinExtrusion>;
    return rounded<DooSabinExtrusion>("extrude.doo_sabin", "Raise a block whose top is rounded off as by a Doo–Sabin step")
        .param(&P::iterations, "iterations", Unit::count, {1, 50}, "how often: each time on the tops of the time before")
        .example("extrude.doo_sabin faces=all height=0.5 twist=0.2 iterations=3");
}

Operator extrude_dome_operator()
{
    return rounded<Dome>("extrude.dome", "Raise a dome of five rings on each face").example("extrude.dome faces=all height=0.7");
}

} // namespace druse
