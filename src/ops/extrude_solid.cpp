// extrude.solid: any closed solid as an extrusion (solid_pattern.h), put on any face with a whole number of its wedges.
#include "dlfl/errors.h"
#include "ops/extrude.h"
#include "ops/registry.h"
#include "ops/solid.h"
#include "ops/solid_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

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

    SolidKernel(const SolidPattern& pattern, const SolidExtrusion& size, Progress& progress)
        : mitred(pattern.mitred), pattern_(pattern), planar_(size.planar), tiling_(pattern.tiling()), progress_(progress)
    {
        const auto tiers = static_cast<std::size_t>(pattern.tiers);
        if (size.heights.size() != 1 && size.heights.size() != tiers)
            throw CommandError(fmt::format("heights={}: expected {}{} number{}, one for each tier", list_text(size.heights, {}), tiers > 1 ? "1 or " : "", tiers,
                                           tiers == 1 ? "" : "s"));
        heights_.assign(tiers, size.heights[0]);
        if (size.heights.size() == tiers) heights_ = size.heights;
        stretched_ = std::ranges::any_of(heights_, [](double h) { return h != 1.0; });
        tilt_ = size.angle ? radians(*size.angle) - pattern.wall_angles[0] : 0.0;
        const double cosine = std::cos(tilt_), sine = std::sin(tilt_);
        const auto tilted = [&](const SolidPattern::Place& p) { return Hung{p.at, p.along, p.out * cosine + p.up * sine, p.up * cosine - p.out * sine}; };
        for (const auto& orbit : pattern.orbits) hung_.push_back(tilted(orbit.place));
        if (pattern.has_apex)
            for (const auto& place : pattern.orbits.back().apex_places) apex_hung_.push_back(tilted(place));
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
            if (n < pattern_.sides && round(n).closes_on_itself)
                throw CommandError(fmt::format("this pattern meets itself on so few edges; {} has {}, the solid's has {}", what, n, pattern_.sides));
            n = tiling_.top_corners(n);
        }
    }

    void place(const BaseFrame& base, Point* out, Vector*) const
    {
        const int n = base.n, m = pattern_.edges, wedges = n / m;
        using Kind = SolidPattern::Place::Kind;
        for (std::size_t i = 0; i < hung_.size(); ++i) {
            const Hung& hung = hung_[i];
            const Kind kind = pattern_.orbits[i].place.kind;
            // Copies of a vertex stand a wedge of the base apart, and a wedge of their tier.
            Point* to = out + tiling_.local({static_cast<int>(i), 0}, 0, n) - n;
            if (kind == Kind::apex) {
                Vector sum(0.0);
                for (int e = 0; e < n; ++e) sum += beside_edge(base, apex_hung_[std::size_t(e % m)], e);
                *to = sum / double(n);
                continue;
            }
            const int step = wedges > 1 ? tiling_.local({static_cast<int>(i), 0}, 1, n) - tiling_.local({static_cast<int>(i), 0}, 0, n) : 0;
            int at = (hung.at % n + n) % n;
            for (int t = 0; t < wedges; ++t, to += step, at += at + m < n ? m : m - n) *to = kind == Kind::edge ? beside_edge(base, hung, at) : over_corner(base, hung, at);
        }
        if (stretched_) stretch(n, base, out);
        if (planar_ != Planar::off) flatten(base, out);
        if (++placed_ % 256 == 0) breathe();
    }

private:
    /// A place of the pattern with its profile turned by the tilt.
    struct Hung {
        int at;
        double along, out, up;
    };
    /// What the faces around a base with n corners are, found when it is first met.
    struct Round {
        std::vector<int> corners, ends; // polygon after polygon, by the numbers of a Tiling
        std::vector<int> over;          // the base edge under each polygon, where its wall keeps its angle; else −1
        bool closes_on_itself = false;  // two of its edges join the same vertices
    };

    static Point beside_edge(const BaseFrame& base, const Hung& p, int edge)
    {
        return (1.0 - p.along) * base.foot[edge] + p.along * base.foot[edge + 1] + base.edge * (p.out * base.outward[edge] + p.up * base.normal);
    }
    static Point over_corner(const BaseFrame& base, const Hung& p, int i)
    {
        const Vector &o = base.outward[i - 1], &o1 = base.outward[i];
        const Vector mitre = (o + o1) * (1.0 / (1.0 + glm::dot(o, o1)));
        const Point on = base.foot[i] + base.edge * (p.out * mitre + p.up * base.normal);
        return p.along == 0.0 ? on : on + base.edge * p.along * unit(base.along[i - 1] + base.along[i]);
    }

    const Round& round(int n) const
    {
        if (n == last_n_) return *last_;
        std::unique_ptr<Round>& found = rounds_[n];
        if (!found) found = std::make_unique<Round>(make_round(n));
        last_n_ = n;
        last_ = found.get();
        return *last_;
    }
    Round make_round(int n) const
    {
        Round round;
        std::vector<std::pair<int, int>> sides;
        for (const auto& polygon : tiling_.polygons(n)) {
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                round.corners.push_back(polygon[i]);
                sides.emplace_back(polygon[i], polygon[(i + 1) % polygon.size()]);
            }
            round.ends.push_back(static_cast<int>(round.corners.size()));
        }
        std::ranges::sort(sides);
        round.closes_on_itself = std::ranges::adjacent_find(sides) != sides.end() || std::ranges::any_of(sides, [](const auto& s) { return s.first == s.second; });
        const int wedges = n / pattern_.edges, first_row = tiling_.has_top(n) ? 1 : 0;
        round.over.assign(round.ends.size(), -1);
        if (planar_ == Planar::walls)
            for (int a = 0; a < pattern_.edges; ++a) {
                const int row = pattern_.wall_rows[std::size_t(a)];
                for (int t = 0; t < wedges; ++t) round.over[std::size_t(row == SolidPattern::top_row ? 0 : first_row + row * wedges + t)] = t * pattern_.edges + a;
            }
        return round;
    }

    /// Scales each tier's step from the tiers below it. What was predicted stays known while lower tiers move.
    void stretch(int n, const BaseFrame& base, Point* out) const
    {
        ideal_.assign(out, out + tiling_.new_vertices(n));
        const auto now = [&](int local) -> const Point& { return local < n ? base.foot[local] : out[local - n]; };
        const auto ideally = [&](int local) -> const Point& { return local < n ? base.foot[local] : ideal_[std::size_t(local - n)]; };
        const int wedges = n / pattern_.edges;
        for (const std::size_t i : order_) {
            const auto& orbit = pattern_.orbits[i];
            const bool apex = orbit.place.kind == SolidPattern::Place::Kind::apex;
            for (int t = 0; t < (apex ? 1 : wedges); ++t) {
                Vector below(0.0), below_ideally(0.0);
                int count = 0;
                for (const Tiling::Spot s : orbit.below)
                    for (int around = 0; around < (apex ? wedges : 1); ++around, ++count) {
                        const int local = tiling_.local(s, t + around, n);
                        below += now(local);
                        below_ideally += ideally(local);
                    }
                const int own = tiling_.local({static_cast<int>(i), 0}, t, n);
                out[own - n] = below / double(count) + heights_[std::size_t(orbit.tier - 1)] * (ideally(own) - below_ideally / double(count));
            }
        }
    }

    /// Moves the new vertices until every new face is flat: each to the mean of its projections on the planes of its faces.
    void flatten(const BaseFrame& base, Point* out) const
    {
        const Round& round = this->round(base.n);
        const auto n = static_cast<std::size_t>(base.n), made = static_cast<std::size_t>(tiling_.new_vertices(base.n));
        const double enough = 1e-9 * base.edge;
        positions_.assign(base.foot.begin(), base.foot.end());
        positions_.insert(positions_.end(), out, out + made);
        for (int sweep = 0; sweep < 1000; ++sweep) {
            // Most faces of most models are flat as they are placed, so nothing is written before one is found that is not.
            bool flat = true;
            std::size_t begin = 0;
            for (std::size_t f = 0; f < round.ends.size(); ++f) {
                const auto end = static_cast<std::size_t>(round.ends[f]);
                const int* polygon = round.corners.data() + begin;
                const std::size_t size = end - begin;
                begin = end;
                if (size < 4 && round.over[f] < 0) continue;
                Point on;
                Vector normal;
                plane(base, polygon, size, round.over[f], on, normal);
                if (flat) {
                    double farthest = 0.0;
                    for (std::size_t i = 0; i < size; ++i) farthest = std::max(farthest, std::abs(glm::dot(positions_[std::size_t(polygon[i])] - on, normal)));
                    if (!(farthest > enough)) continue;
                    flat = false;
                    sums_.assign(n + made, {Vector(0.0), 0});
                    project_earlier(base, round, f);
                }
                project(polygon, size, on, normal);
            }
            if (flat) break;
            for (std::size_t v = n; v < n + made; ++v)
                if (sums_[v].count > 0) positions_[v] = sums_[v].sum / double(sums_[v].count);
            if (sweep % 16 == 15) breathe();
        }
        std::copy(positions_.begin() + base.n, positions_.end(), out);
    }
    /// The faces before face `end` of a sweep, which were found flat.
    void project_earlier(const BaseFrame& base, const Round& round, std::size_t end) const
    {
        std::size_t begin = 0;
        for (std::size_t f = 0; f < end; ++f) {
            const int* polygon = round.corners.data() + begin;
            const std::size_t size = static_cast<std::size_t>(round.ends[f]) - begin;
            begin += size;
            if (size < 4 && round.over[f] < 0) continue;
            Point on;
            Vector normal;
            plane(base, polygon, size, round.over[f], on, normal);
            project(polygon, size, on, normal);
        }
    }
    void plane(const BaseFrame& base, const int* polygon, std::size_t size, int over, Point& on, Vector& normal) const
    {
        if (over >= 0) {
            const double theta = pattern_.wall_angles[std::size_t(over % pattern_.edges)] + tilt_;
            normal = std::sin(theta) * base.outward[over] + std::cos(theta) * glm::cross(base.outward[over], base.along[over]);
            on = base.middle(over);
            return;
        }
        on = Point(0.0);
        for (std::size_t i = 0; i < size; ++i) on += positions_[std::size_t(polygon[i])];
        on /= double(size);
        normal = Vector(0.0);
        Vector spoke = positions_[std::size_t(polygon[size - 1])] - on;
        for (std::size_t i = 0; i < size; ++i) {
            const Vector next = positions_[std::size_t(polygon[i])] - on;
            normal += glm::cross(spoke, next);
            spoke = next;
        }
        normal = unit(normal);
    }
    void project(const int* polygon, std::size_t size, const Point& on, const Vector& normal) const
    {
        for (std::size_t i = 0; i < size; ++i) {
            const Point& p = positions_[std::size_t(polygon[i])];
            Sum& sum = sums_[std::size_t(polygon[i])];
            sum.sum += p - glm::dot(p - on, normal) * normal;
            ++sum.count;
        }
    }
    void breathe() const { progress_.step(progress_.fraction()); }

    const SolidPattern& pattern_;
    Planar planar_;
    Tiling tiling_;
    Progress& progress_;
    std::vector<double> heights_; // of each tier
    bool stretched_ = false;
    double tilt_ = 0.0;
    std::vector<Hung> hung_;         // of each orbit
    std::vector<Hung> apex_hung_;    // of the apex: beside each edge of a wedge
    std::vector<std::size_t> order_; // orbits, lower tiers first

    // Memory from one face to the next.
    struct Sum {
        Vector sum;
        int count;
    };
    mutable std::map<int, std::unique_ptr<Round>> rounds_;
    mutable int last_n_ = 0;
    mutable const Round* last_ = nullptr;
    mutable std::vector<Point> ideal_, positions_;
    mutable std::vector<Sum> sums_; // of the projections of each vertex
    mutable std::size_t placed_ = 0;
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

/// What a pattern is kept under. A file counts as the same while its size and time do not change.
std::string key_of(const SolidExtrusion& p, const PatternChoice& choice, const Context& context)
{
    std::string of = p.solid.text;
    if (p.solid.is_file()) {
        namespace fs = std::filesystem;
        const fs::path file = fs::absolute(context.folder / p.solid.text);
        std::error_code failed;
        const std::uintmax_t size = fs::file_size(file, failed);
        const auto time = fs::last_write_time(file, failed).time_since_epoch().count();
        if (failed) return {};
        of = fmt::format("{}\n{} {}", file.string(), size, time);
    }
    return fmt::format("{} {} {} {} {} {}", of, choice.sides.value_or(-1), choice.base ? choice.base->index : Face::none, choice.turns.value_or(0), choice.phase,
                       choice.mirror);
}

/// Reads a pattern, or finds it among those read last, so that a slider does not read a file for every step it moves.
std::shared_ptr<const SolidPattern> pattern_for(const SolidExtrusion& p, const Context& context)
{
    struct Kept {
        std::string key;
        std::shared_ptr<const SolidPattern> pattern;
    };
    static std::mutex mutex;
    static std::deque<Kept> kept; // the last one used first
    constexpr std::size_t most_kept = 64;

    const PatternChoice choice = choice_of(p);
    const std::string key = key_of(p, choice, context);
    {
        const std::lock_guard lock(mutex);
        if (const auto found = std::ranges::find(kept, key, &Kept::key); found != kept.end() && !key.empty()) {
            std::rotate(kept.begin(), found, found + 1);
            return kept.front().pattern;
        }
    }
    ASSERT(!p.solid.is_file() || context.read_mesh, "a way to read mesh files");
    const Mesh solid = p.solid.is_file() ? context.read_mesh(p.solid.text) : make_solid(p.solid.text, 1.0);
    auto pattern = std::make_shared<const SolidPattern>(read_pattern(solid, choice));
    const std::lock_guard lock(mutex);
    if (!key.empty()) kept.push_front({key, pattern});
    if (kept.size() > most_kept) kept.pop_back();
    return pattern;
}

void extrude_solid(Scene& scene, const SolidExtrusion& p, Context& context)
{
    const auto pattern = pattern_for(p, context);
    const SolidKernel kernel(*pattern, p, context.progress);
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
        SolidName solid{std::string(t)};
        if (!solid.is_file()) check_solid_name(t);
        return solid;
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

namespace {

/// Every kind of face of the Platonic and Archimedean solids that turns, by the solid and the number of its sides.
void add_regular_presets(Definition<SolidExtrusion>& definition)
{
    const std::vector<std::pair<std::string, std::vector<int>>> solids{
        {"tetrahedron", {3}},
        {"cube", {4}},
        {"octahedron", {3}},
        {"dodecahedron", {5}},
        {"icosahedron", {3}},
        {"truncated_tetrahedron", {3, 6}},
        {"cuboctahedron", {3, 4}},
        {"truncated_cube", {3, 8}},
        {"truncated_octahedron", {4, 6}},
        {"rhombicuboctahedron", {3, 4}},
        {"truncated_cuboctahedron", {4, 6, 8}},
        {"snub_cube", {3, 4}},
        {"icosidodecahedron", {3, 5}},
        {"truncated_dodecahedron", {3, 10}},
        {"truncated_icosahedron", {5, 6}},
        {"rhombicosidodecahedron", {3, 4, 5}},
        {"truncated_icosidodecahedron", {4, 6, 10}},
        {"snub_dodecahedron", {3, 5}},
    };
    for (const auto& [solid, bases] : solids)
        for (const int sides : bases)
            definition.preset(bases.size() == 1 ? solid : fmt::format("{}_{}", solid, sides), fmt::format("solid={} base={} heights=1 iterations=1", solid, sides));
    // Its squares are of two kinds; those between two triangles turn half round only.
    definition.preset("rhombicuboctahedron_4_side", "solid=rhombicuboctahedron base=face:1 heights=1 iterations=1");
}

} // namespace

Operator extrude_solid_operator()
{
    using P = SolidExtrusion;
    auto definition = define<P>("extrude.solid", "Raise any solid, re-tiled around each face");
    definition.param(&P::solid, "solid", "a built-in solid, or a closed mesh file (a text with a dot or a slash)")
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
    add_regular_presets(definition);
    return definition;
}

} // namespace druse
