// extrude.solid: any closed solid as an extrusion (solid_pattern.h), put on any face with a whole number of its wedges.
#include "dlfl/errors.h"
#include "ops/extrude.h"
#include "ops/registry.h"
#include "ops/solid.h"
#include "ops/solid_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

namespace druse {

namespace {

/// What makes the faces of the block flat after it has been placed.
enum class Planar { free, walls, off };

/// A solid's name, or the file that holds it: a text with a dot or a slash.
struct SolidName {
    std::string text;
    bool is_file() const { return text.find_first_of("./") != std::string::npos; }
};

/// Which face the solid stands on: the best one with so many sides, or one by its id.
struct SolidBase {
    int sides = 0; // 0: by id
    std::uint32_t face = 0;
};

struct SolidExtrusion : ExtrusionScope {
    SolidName solid;
    std::optional<SolidBase> base;
    std::optional<int> turns;
    int phase = 0;
    bool mirror = false;
    std::optional<double> angle;
    std::vector<double> heights{1.0};
    Planar planar = Planar::free;
    int iterations = 1;
};

/// Places a pattern over a base: the wedge's own profile, turned by the tilt, hung on the edges and corners of the base.
class SolidKernel {
public:
    static constexpr double angle = 90; // of the frame: the walls' own angles are part of the profile
    bool mitred;

    SolidKernel(const SolidPattern& pattern, const SolidExtrusion& size)
        : mitred(pattern.mitred), pattern_(pattern), planar_(size.planar), tiling_(pattern.tiling())
    {
        const auto tiers = static_cast<std::size_t>(pattern.tiers);
        if (size.heights.size() != 1 && size.heights.size() != tiers)
            throw CommandError(fmt::format("heights={}: expected {}{} number{}, one for each tier", list_text(size.heights, {}), tiers > 1 ? "1 or " : "", tiers,
                                           tiers == 1 ? "" : "s"));
        heights_.assign(tiers, size.heights[0]);
        if (size.heights.size() == tiers) heights_ = size.heights;
        stretched_ = std::ranges::any_of(heights_, [](double h) { return h != 1.0; });
        tilt_ = size.angle ? radians(*size.angle) - pattern.wall_angles[0] : 0.0;
        cosine_ = std::cos(tilt_);
        sine_ = std::sin(tilt_);
        for (std::size_t i = 0; i < pattern.orbits.size(); ++i) order_.push_back(i);
        std::ranges::stable_sort(order_, {}, [&](std::size_t i) { return pattern.orbits[i].tier; });
    }

    Tiling tiling() const { return pattern_.tiling(); }

    /// @throws CommandError if the pattern does not go round a face with n sides, as often as asked
    void check(Face face, int n, int iterations) const
    {
        for (int k = 0; k < iterations; ++k) {
            const bool top = k > 0;
            const std::string what = top ? fmt::format("face {}: its top", face.index) : fmt::format("face {}", face.index);
            if (top && n < 3) throw CommandError(fmt::format("{} is no face that could be extruded again (iterations={})", what, iterations));
            if (n < 3) throw CommandError(fmt::format("{}: has {} corner{}", what, n, n == 1 ? "" : "s"));
            if (pattern_.turns == 1 && n != pattern_.sides)
                throw CommandError(fmt::format("this pattern needs exactly {} edges; {} has {}", pattern_.sides, what, n));
            if (n % pattern_.edges != 0) throw CommandError(fmt::format("this pattern repeats every {} edges; {} has {}", pattern_.edges, what, n));
            if (n / pattern_.edges < 2 && pattern_.turns > 1)
                throw CommandError(fmt::format("this pattern needs at least {} edges; {} has {}", 2 * pattern_.edges, what, n));
            n = tiling_.top_corners(n);
        }
    }

    void place(const BaseFrame& base, Point* out, Vector*) const
    {
        const int m = pattern_.edges, wedges = base.n / m;
        const auto at = [&](Tiling::Spot s, int wedge) { return tiling_.local(s, wedge, base.n); };
        const auto position = [&](int local) -> const Point& { return local < base.n ? base.foot[local] : out[local - base.n]; };
        for (const std::size_t i : order_) {
            const auto& orbit = pattern_.orbits[i];
            if (orbit.place.kind == SolidPattern::Place::Kind::apex) {
                Vector sum(0.0);
                for (int e = 0; e < base.n; ++e) sum += beside_edge(base, orbit.apex_places[std::size_t(e % m)], e);
                out[at({static_cast<int>(i), 0}, 0) - base.n] = sum / double(base.n);
            } else {
                for (int t = 0; t < wedges; ++t) out[at({static_cast<int>(i), 0}, t) - base.n] = predicted(base, orbit.place, t);
            }
        }
        if (stretched_) stretch(base, out, at, position);
        if (planar_ != Planar::off) flatten(base, out);
    }

private:
    Point predicted(const BaseFrame& base, const SolidPattern::Place& p, int wedge) const
    {
        const int n = base.n;
        const int i = ((p.at + wedge * pattern_.edges) % n + n) % n;
        if (p.kind == SolidPattern::Place::Kind::edge) return beside_edge(base, p, i);
        const Vector &o = base.outward[i - 1], &o1 = base.outward[i];
        const Vector mitre = (o + o1) * (1.0 / (1.0 + glm::dot(o, o1)));
        const auto [x, z] = turned(p);
        return base.foot[i] + base.edge * (x * mitre + p.along * unit(base.along[i - 1] + base.along[i]) + z * base.normal);
    }
    Point beside_edge(const BaseFrame& base, const SolidPattern::Place& p, int edge) const
    {
        const auto [x, z] = turned(p);
        return (1.0 - p.along) * base.foot[edge] + p.along * base.foot[edge + 1] + base.edge * (x * base.outward[edge] + z * base.normal);
    }
    std::pair<double, double> turned(const SolidPattern::Place& p) const
    {
        return {p.out * cosine_ + p.up * sine_, p.up * cosine_ - p.out * sine_};
    }

    /// Scales each tier's step from the tiers below it. What was predicted stays known while lower tiers move.
    template <class At, class Position>
    void stretch(const BaseFrame& base, Point* out, At&& at, Position&& position) const
    {
        const std::vector<Point> ideal(out, out + tiling_.new_vertices(base.n));
        const auto predicted_at = [&](int local) -> const Point& { return local < base.n ? base.foot[local] : ideal[std::size_t(local - base.n)]; };
        const int wedges = base.n / pattern_.edges;
        for (const std::size_t i : order_) {
            const auto& orbit = pattern_.orbits[i];
            const bool apex = orbit.place.kind == SolidPattern::Place::Kind::apex;
            for (int t = 0; t < (apex ? 1 : wedges); ++t) {
                Vector now(0.0), ideally(0.0);
                int count = 0;
                for (const Tiling::Spot s : orbit.below)
                    for (int round = 0; round < (apex ? wedges : 1); ++round, ++count) {
                        const int local = at(s, t + round);
                        now += position(local);
                        ideally += predicted_at(local);
                    }
                const int own = at({static_cast<int>(i), 0}, t);
                out[own - base.n] = now / double(count) + heights_[std::size_t(orbit.tier - 1)] * (predicted_at(own) - ideally / double(count));
            }
        }
    }

    /// Moves the new vertices until every new face is flat: each to the mean of its projections on the planes of its faces.
    void flatten(const BaseFrame& base, Point* out) const
    {
        const int n = base.n, made = tiling_.new_vertices(n);
        auto& polygons = polygons_[n];
        if (polygons.empty()) polygons = tiling_.polygons(n);
        const int wedges = n / pattern_.edges, first_row = tiling_.has_top(n) ? 1 : 0;
        const auto position = [&](int local) -> const Point& { return local < n ? base.foot[local] : out[local - n]; };
        // The wall over each base edge, by its place among the polygons.
        std::vector<int> wall_of(polygons.size(), -1);
        if (planar_ == Planar::walls)
            for (int a = 0; a < pattern_.edges; ++a)
                for (int t = 0; t < wedges; ++t) wall_of[std::size_t(first_row + pattern_.wall_rows[std::size_t(a)] * wedges + t)] = t * pattern_.edges + a;

        std::vector<Vector> sum;
        std::vector<int> count;
        for (int sweep = 0; sweep < 1000; ++sweep) {
            sum.assign(std::size_t(made), Vector(0.0));
            count.assign(std::size_t(made), 0);
            double farthest = 0.0;
            for (std::size_t f = 0; f < polygons.size(); ++f) {
                const auto& polygon = polygons[f];
                if (polygon.size() < 4 && wall_of[f] < 0) continue;
                Point on(0.0);
                Vector normal(0.0);
                for (const int v : polygon) on += position(v);
                on /= double(polygon.size());
                if (const int edge = wall_of[f]; edge >= 0) {
                    const double theta = pattern_.wall_angles[std::size_t(edge % pattern_.edges)] + tilt_;
                    normal = std::sin(theta) * base.outward[edge] + std::cos(theta) * glm::cross(base.outward[edge], base.along[edge]);
                    on = base.middle(edge);
                } else {
                    for (std::size_t i = 0; i < polygon.size(); ++i)
                        normal += glm::cross(position(polygon[i]) - on, position(polygon[(i + 1) % polygon.size()]) - on);
                    normal = unit(normal);
                }
                for (const int v : polygon) {
                    const double off = glm::dot(position(v) - on, normal);
                    farthest = std::max(farthest, std::abs(off));
                    if (v < n) continue;
                    sum[std::size_t(v - n)] += position(v) - off * normal;
                    ++count[std::size_t(v - n)];
                }
            }
            if (!(farthest > 1e-9 * base.edge)) return;
            for (int v = 0; v < made; ++v)
                if (count[std::size_t(v)] > 0) out[v] = sum[std::size_t(v)] / double(count[std::size_t(v)]);
        }
    }

    const SolidPattern& pattern_;
    Planar planar_;
    Tiling tiling_;
    std::vector<double> heights_; // of each tier
    bool stretched_ = false;
    double tilt_ = 0.0, cosine_ = 1.0, sine_ = 0.0;
    std::vector<std::size_t> order_; // orbits, lower tiers first
    mutable std::map<int, std::vector<std::vector<int>>> polygons_;
};

PatternChoice choice_of(const SolidExtrusion& p)
{
    PatternChoice choice;
    if (p.base && p.base->sides > 0) choice.sides = p.base->sides;
    else if (p.base) choice.base = Face(p.base->face);
    choice.turns = p.turns;
    choice.phase = p.phase;
    choice.mirror = p.mirror;
    choice.exact = !p.solid.is_file();
    return choice;
}

/// The pattern of a built-in solid is read once and kept; a file may change, and is read every time.
std::shared_ptr<const SolidPattern> pattern_for(const SolidExtrusion& p, const Context& context)
{
    const PatternChoice choice = choice_of(p);
    if (p.solid.is_file()) {
        ASSERT(context.read_mesh, "a way to read mesh files");
        return std::make_shared<const SolidPattern>(read_pattern(context.read_mesh(p.solid.text), choice));
    }
    static std::mutex mutex;
    static std::map<std::string, std::shared_ptr<const SolidPattern>> kept;
    const std::string key = fmt::format("{} {} {} {} {} {}", p.solid.text, choice.sides.value_or(-1), choice.base ? choice.base->index : Face::none,
                                        choice.turns.value_or(0), choice.phase, choice.mirror);
    const std::lock_guard lock(mutex);
    std::shared_ptr<const SolidPattern>& pattern = kept[key];
    if (!pattern) pattern = std::make_shared<const SolidPattern>(read_pattern(make_solid(p.solid.text, 1.0), choice));
    return pattern;
}

void extrude_solid(Scene& scene, const SolidExtrusion& p, Context& context)
{
    const auto pattern = pattern_for(p, context);
    const SolidKernel kernel(*pattern, p);
    std::vector<Face> faces = collect_faces(scene, p);
    for (const Face f : faces) kernel.check(f, scene.mesh.valence(f), p.iterations);
    scene.selection.edit().faces = extrude_faces(scene.mesh, std::move(faces), kernel, p.groups, p.iterations, false, context.progress);
}

} // namespace

template <>
struct ParameterType<SolidName> {
    static constexpr auto type = Parameter::Type::name_or_file;
    static SolidName parse(std::string_view t, const Domain&)
    {
        if (t.empty()) throw CommandError("expected the name of a solid or a mesh file");
        return {std::string(t)};
    }
    static std::string text(const SolidName& x, const Domain&) { return x.text; }
};
template <>
struct ParameterType<SolidBase> {
    static constexpr auto type = Parameter::Type::text;
    static SolidBase parse(std::string_view t, const Domain&)
    {
        try {
            if (t.starts_with("face:")) return {0, parse_id(t.substr(5))};
            if (const std::uint32_t sides = parse_id(t); sides >= 3 && sides <= 1'000'000) return {static_cast<int>(sides), 0};
        } catch (const CommandError&) {
        }
        throw CommandError("expected a number of sides (3 or more) or face:ID");
    }
    static std::string text(const SolidBase& x, const Domain&) { return x.sides > 0 ? std::to_string(x.sides) : fmt::format("face:{}", x.face); }
};

Operator extrude_solid_operator()
{
    using P = SolidExtrusion;
    return define<P>("extrude.solid", "Raise any solid, re-tiled around each face")
        .param(&P::solid, "solid", "a built-in solid, or a closed mesh file (a text with a dot or a slash)")
        .required()
        .param(&P::base, "base", "the face it stands on: a number of sides, or face:ID of the solid; unset: the one with the largest turn")
        .param(&P::turns, "turns", Unit::count, {1, 1'000'000}, "into how many equal wedges the solid is cut; unset: as many as it has; 1: not re-tiled")
        .param(&P::phase, "phase", Unit::count, {0, 1'000'000}, "which base edge of the wedge lies after the start corner")
        .param(&P::mirror, "mirror", "use the mirror image of the solid")
        .param(&P::angle, "angle", Unit::degrees, {1, 179}, "interior dihedral angle of the wall after the start corner; all walls turn by the same; unset: as in the solid")
        .param(&P::heights, "heights", Unit::ratio, nonzero(-100, 100), {1, 100'000}, "multipliers of the tiers' own heights: one for all, or one each")
        .param(&P::planar, "planar", words({"free", "walls", "off"}), "make faces flat: moving all new vertices, keeping the walls' angles, or not at all")
        .param(&P::faces, "faces", "faces to extrude")
        .param(&P::grouped, "grouped", "extrude all faces of the groups of these faces with them")
        .param(&P::groups, "groups", new_group_words(), "group ids of the new faces: one each, one a row, the old one, or none")
        .param(&P::iterations, "iterations", Unit::count, {1, 50}, "how often: each time on the tops of the time before")
        .keeps_euler()
        .example("extrude.solid solid=truncated_cube faces=all angle=80")
        .cites("Landreneau 2005, III and VI")
        .run(&extrude_solid);
}

} // namespace druse
