#include "ops/solid_pattern.h"

#include "dlfl/errors.h"
#include "dlfl/measures.h"
#include "ops/extrude_frame.h"
#include "ops/solid_symmetry.h"

#include <fmt/format.h>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace druse {

namespace {

/// Elevations and distances that count as equal, in mean edges of the base. Numbers in files are often cut short.
double reach_of(const PatternChoice& choice) { return choice.exact ? 1e-6 : 1e-4; }

/// Reads one solid from one base face. The steps are those of SolidPattern's reading, in order; each uses what the ones before left.
class Reader : StandingSolid {
public:
    Reader(const Mesh& solid, Face base, const PatternChoice& choice)
        : StandingSolid(solid, base, reach_of(choice), choice.mirror), choice_(choice), same_azimuth_(choice.exact ? radians(1e-6) : 1e-4)
    {
    }

    SolidPattern read(int turns)
    {
        pattern_.sides = sides();
        pattern_.turns = turns;
        pattern_.edges = sides() / turns;
        same_azimuth_ = std::min(same_azimuth_, 0.01 * wedge_angle());
        next_ = turned_vertices(turns);
        if (next_.empty()) wraps();
        if (!choice_.exact) average_turns(next_, turns);
        refuse_below_base();
        turn_to_phase();
        find_orbits();
        find_rows();
        for (std::size_t i = 0; i < pattern_.orbits.size(); ++i) hang_over_base(i);
        for (std::size_t i = 0; i < pattern_.orbits.size(); ++i) find_below(i);
        return std::move(pattern_);
    }

private:
    int wedges() const { return pattern_.turns; }
    double wedge_angle() const { return full / pattern_.turns; }

    void refuse_below_base() const
    {
        std::vector<bool> in_base(place_.size(), false);
        for (const std::uint32_t v : foot_) in_base[v] = true;
        for (std::size_t v = 0; v < place_.size(); ++v)
            if (place_[v].z < -same_place_ || (!in_base[v] && place_[v].z <= same_place_)) throw CommandError("the solid reaches below its base face");
    }

    // --- phase ---------------------------------------------------------------------------------------------------------------------

    /// The face over base edge i, from foot i to foot i + 1.
    Face wall(int i) const { return wall_[std::size_t(i % sides())]; }

    void turn_to_phase()
    {
        const int m = pattern_.edges;
        std::vector<int> counts;
        for (int i = 0; i < m; ++i) counts.push_back(solid_.valence(wall(i)));
        int best = 0;
        const auto later_is_larger = [&](int r, int s) {
            for (int i = 0; i < m; ++i)
                if (const int a = counts[std::size_t((r + i) % m)], b = counts[std::size_t((s + i) % m)]; a != b) return b > a;
            return false;
        };
        for (int r = 1; r < m; ++r)
            if (later_is_larger(best, r)) best = r;
        std::rotate(foot_.begin(), foot_.begin() + (best + choice_.phase) % m, foot_.end());
        std::rotate(wall_.begin(), wall_.begin() + (best + choice_.phase) % m, wall_.end());
        const Point& first = place_[foot_[0]];
        const double azimuth = std::atan2(first.y, first.x);
        for (Point& p : place_) p = turned(p, -azimuth);
        for (int i = 0; i < m; ++i) {
            // The wall's outward normal, seen square to its edge: its interior dihedral angle with the base.
            const Point &a = place_[foot_[std::size_t(i)]], &b = place_[foot_[std::size_t((i + 1) % sides())]];
            const Vector along = unit(b - a), out = glm::cross(along, Vector(0, 0, 1));
            Vector newell(0.0);
            for (const Corner c : solid_.corners(wall(i))) newell += glm::cross(place_[solid_.vertex(c).index] - a, place_[solid_.target(c).index] - a);
            if (choice_.mirror) newell = -newell;
            pattern_.wall_angles.push_back(std::atan2(glm::dot(newell, out), glm::dot(newell, Vector(0, 0, 1))));
        }
    }

    // --- vertices ----------------------------------------------------------------------------------------------------------------

    bool on_axis(const Point& p) const { return std::hypot(p.x, p.y) < same_place_; }
    /// 0 … 360°, where what lies just below 360° counts as 0.
    double azimuth(const Point& p) const
    {
        double a = std::atan2(p.y, p.x);
        if (a < 0.0) a += full;
        return a > full - same_azimuth_ ? 0.0 : a;
    }
    bool in_first_wedge(const Point& p) const { return azimuth(p) < wedge_angle() - same_azimuth_; }

    void find_orbits()
    {
        orbit_of_.assign(place_.size(), none);
        wedge_of_.assign(place_.size(), 0);
        const auto mark = [this](std::uint32_t v, int orbit) {
            for (int j = 0; j < wedges(); ++j, v = next_[v]) {
                orbit_of_[v] = orbit;
                wedge_of_[v] = j;
            }
        };
        for (int a = 0; a < pattern_.edges; ++a) mark(foot_[std::size_t(a)], -1 - a);

        std::vector<std::uint32_t> raised;
        for (std::uint32_t v = 0; v < place_.size(); ++v)
            if (orbit_of_[v] == none) raised.push_back(v);
        std::ranges::sort(raised, {}, [this](std::uint32_t v) { return place_[v].z; });
        int tier = 0;
        double elevation = 0.0;
        std::vector<std::pair<std::uint32_t, int>> first; // representative and tier
        std::optional<std::pair<std::uint32_t, int>> apex;
        for (const std::uint32_t v : raised) {
            if (tier == 0 || place_[v].z > elevation + same_place_) {
                ++tier;
                elevation = place_[v].z;
            }
            if (on_axis(place_[v])) {
                if (apex) wraps();
                apex = {v, tier};
            } else if (wedges() == 1 || in_first_wedge(place_[v])) {
                first.emplace_back(v, tier);
            }
        }
        pattern_.tiers = tier;
        std::ranges::stable_sort(first, [this](const auto& a, const auto& b) {
            return std::pair(a.second, azimuth(place_[a.first])) < std::pair(b.second, azimuth(place_[b.first]));
        });
        for (const auto& [v, t] : first) {
            if (orbit_of_[v] != none) wraps(); // two of one orbit in the first wedge: the symmetry is no turn about this axis
            mark(v, static_cast<int>(representative_.size()));
            representative_.push_back(v);
            pattern_.orbits.push_back({t, {}, {}, {}});
        }
        if (apex) {
            pattern_.has_apex = true;
            orbit_of_[apex->first] = static_cast<int>(representative_.size());
            representative_.push_back(apex->first);
            pattern_.orbits.push_back({apex->second, {SolidPattern::Place::Kind::apex, 0, 0, 0, 0}, {}, {}});
        }
        if (std::ranges::find(orbit_of_, none) != orbit_of_.end()) wraps();
    }

    [[noreturn]] static void wraps() { throw CommandError("the solid wraps round its axis"); }
    bool is_apex(std::uint32_t v) const { return orbit_of_[v] >= 0 && pattern_.orbits[std::size_t(orbit_of_[v])].place.kind == SolidPattern::Place::Kind::apex; }

    // --- faces -------------------------------------------------------------------------------------------------------------------

    struct Walk {
        std::vector<std::uint32_t> vertices; // counter-clockwise from outside
        std::vector<double> lifted;          // azimuths that go on from one vertex to the next
        double around = 0.0;                 // how far the azimuth has come when the walk is back
        bool crosses_axis = false;           // an edge of it does
    };

    static double turn_between(double from, double to)
    {
        double d = std::fmod(to - from, full);
        if (d > pi) d -= full;
        if (d <= -pi) d += full;
        return d;
    }

    Walk walk(Face f) const
    {
        Walk w;
        for (const Corner c : solid_.corners(f)) w.vertices.push_back(solid_.vertex(c).index);
        if (choice_.mirror) std::reverse(w.vertices.begin(), w.vertices.end());
        const std::size_t n = w.vertices.size();
        w.lifted.assign(n, 0.0);
        std::vector<std::size_t> off_axis, straight;
        for (std::size_t i = 0; i < n; ++i)
            if (!on_axis(place_[w.vertices[i]])) off_axis.push_back(i);
        std::vector<double> steps;
        for (std::size_t i = 0; i < off_axis.size(); ++i) {
            const std::size_t a = off_axis[i], b = off_axis[(i + 1) % off_axis.size()];
            steps.push_back(turn_between(azimuth(place_[w.vertices[a]]), azimuth(place_[w.vertices[b]])));
            if (std::abs(std::abs(steps.back()) - pi) < same_azimuth_) {
                w.crosses_axis = w.crosses_axis || b == (a + 1) % n;
                straight.push_back(i);
            }
        }
        double sum = 0.0;
        for (const double d : steps) sum += d;
        // A step of just half a turn may go either way round: take the way that brings the walk back to where it began.
        for (const std::size_t i : straight)
            if (std::abs(sum) > 0.5 * full) {
                sum -= 2.0 * steps[i];
                steps[i] = -steps[i];
            }
        w.around = sum;
        double at = off_axis.empty() ? 0.0 : azimuth(place_[w.vertices[off_axis[0]]]);
        for (std::size_t i = 0; i < off_axis.size(); ++i) {
            w.lifted[off_axis[i]] = at;
            at += steps[i];
        }
        return w;
    }

    Point centre(const std::vector<std::uint32_t>& vertices) const
    {
        Point sum(0.0);
        for (const std::uint32_t v : vertices) sum += place_[v];
        return sum / double(vertices.size());
    }

    void find_rows()
    {
        struct Row {
            double elevation, azimuth;
            std::vector<Tiling::Spot> spots;
            Face face;
        };
        std::vector<Row> rows;
        std::vector<int> crossing; // orbits of an edge through the axis
        Face top;
        for (const Face f : solid_.faces()) {
            if (f == base_) continue;
            Walk w = walk(f);
            if (std::abs(w.around) > 0.5 * full) {
                if (top.valid() || std::abs(std::abs(w.around) - full) > 1e-3 || w.around < 0.0) wraps();
                top = f;
                set_top(std::move(w.vertices));
                continue;
            }
            const Point middle = centre(w.vertices);
            if (w.crosses_axis) {
                for (std::size_t i = 0; i < w.vertices.size(); ++i) {
                    const std::uint32_t a = w.vertices[i], b = w.vertices[(i + 1) % w.vertices.size()];
                    if (!on_axis(place_[a]) && !on_axis(place_[b]) && std::abs(std::abs(turn_between(azimuth(place_[a]), azimuth(place_[b]))) - pi) < same_azimuth_)
                        crossing.push_back(orbit_of_[a]);
                }
            }
            if (wedges() > 1 && (on_axis(middle) || !in_first_wedge(middle))) {
                if (on_axis(middle)) wraps();
                continue;
            }
            // Lift the azimuths to the turn in which the face's own centre lies.
            double mean = 0.0;
            int counted = 0;
            for (std::size_t i = 0; i < w.vertices.size(); ++i)
                if (!on_axis(place_[w.vertices[i]])) {
                    mean += w.lifted[i];
                    ++counted;
                }
            const double shift = counted > 0 && !on_axis(middle) ? full * std::round((azimuth(middle) - mean / counted) / full) : 0.0;
            Row row{std::round(middle.z / same_place_), std::round(azimuth(middle) / same_place_), {}, f};
            std::size_t lowest = 0;
            for (std::size_t i = 0; i < w.vertices.size(); ++i) {
                w.lifted[i] += shift;
                const double z = place_[w.vertices[i]].z, least = place_[w.vertices[lowest]].z;
                if (z < least - same_place_ || (z <= least + same_place_ && w.lifted[i] < w.lifted[lowest] - same_azimuth_)) lowest = i;
            }
            for (std::size_t k = 0; k < w.vertices.size(); ++k) {
                const std::size_t i = (lowest + k) % w.vertices.size();
                row.spots.push_back(spot(w.vertices[i], w.lifted[i]));
            }
            rows.push_back(std::move(row));
        }
        std::ranges::stable_sort(rows, [](const Row& a, const Row& b) { return std::pair(a.elevation, a.azimuth) < std::pair(b.elevation, b.azimuth); });
        for (Row& row : rows) pattern_.rows.push_back(std::move(row.spots));
        find_wall_rows();

        if (!top.valid() && !pattern_.has_apex) {
            if (crossing.empty() || wedges() > 2) {
                if (wedges() > 1) wraps();
            } else if (wedges() == 2) {
                pattern_.top = {crossing[0]};
            }
        }
    }

    void set_top(std::vector<std::uint32_t> corners)
    {
        const auto by_azimuth = [this](std::uint32_t v) { return azimuth(place_[v]); };
        std::ranges::rotate(corners, std::ranges::min_element(corners, {}, by_azimuth));
        if (!std::ranges::is_sorted(corners, {}, by_azimuth)) wraps(); // it turns back on its way round
        std::erase_if(corners, [this](std::uint32_t v) { return wedges() > 1 && !in_first_wedge(place_[v]); });
        for (const std::uint32_t v : corners) pattern_.top.push_back(orbit_of_[v]);
    }

    /// A vertex in the copy of the wedge in which its lifted azimuth lies.
    Tiling::Spot spot(std::uint32_t v, double lifted) const
    {
        if (is_apex(v)) return {orbit_of_[v], 0};
        const double own = azimuth(place_[orbit_of_[v] >= 0 ? representative_[std::size_t(orbit_of_[v])] : foot_[std::size_t(-1 - orbit_of_[v])]]);
        return {orbit_of_[v], static_cast<int>(std::lround((lifted - own) / wedge_angle()))};
    }

    void find_wall_rows()
    {
        const int m = pattern_.edges;
        pattern_.wall_rows.assign(std::size_t(m), SolidPattern::top_row);
        for (std::size_t r = 0; r < pattern_.rows.size(); ++r) {
            const auto& row = pattern_.rows[r];
            for (std::size_t i = 0; i < row.size(); ++i) {
                const Tiling::Spot &from = row[i], &to = row[(i + 1) % row.size()];
                const int a = -1 - from.orbit;
                const bool last = a == m - 1; // its edge ends in the next wedge
                if (a < 0 || to.orbit != (last ? -1 : from.orbit - 1) || to.wedge - from.wedge != (last ? 1 : 0)) continue;
                pattern_.wall_rows[std::size_t(a)] = static_cast<int>(r);
            }
        }
        // Where nothing is turned, the axis may leave the solid through a wall, which then is the top.
        if (std::ranges::count(pattern_.wall_rows, SolidPattern::top_row) > (wedges() == 1 && !pattern_.top.empty() ? 1 : 0)) wraps();
    }

    // --- where vertices hang -------------------------------------------------------------------------------------------------------

    Point foot(int i) const { return place_[foot_[std::size_t(((i % sides()) + sides()) % sides())]]; }
    Vector edge_direction(int e) const { return unit(foot(e + 1) - foot(e)); }
    static Vector outward(const Vector& along) { return glm::cross(along, Vector(0, 0, 1)); }
    /// The edge or corner `i` as one counts it from the wedge of a vertex at azimuth `own`: its number goes on with the azimuth.
    int lifted(int i, const Point& at, double own) const
    {
        const double there = azimuth(at), turns = std::round((own - there) / full);
        return i + sides() * static_cast<int>(turns);
    }

    SolidPattern::Place beside_edge(int e, const Point& p) const
    {
        const Point a = foot(e), b = foot(e + 1);
        const Vector side = b - a;
        return {SolidPattern::Place::Kind::edge, e, glm::dot(p - a, side) / glm::dot(side, side), glm::dot(p - a, outward(unit(side))), p.z};
    }
    SolidPattern::Place over_corner(int c, const Point& p) const
    {
        const Vector before = edge_direction(c - 1), after = edge_direction(c), d = p - foot(c);
        return {SolidPattern::Place::Kind::corner, c, glm::dot(d, unit(before + after)), 0.5 * glm::dot(d, outward(before) + outward(after)), p.z};
    }

    void hang_over_base(std::size_t i)
    {
        SolidPattern::Orbit& orbit = pattern_.orbits[i];
        const Point& p = place_[representative_[i]];
        if (orbit.place.kind == SolidPattern::Place::Kind::apex) {
            for (int e = 0; e < pattern_.edges; ++e) orbit.apex_places.push_back(beside_edge(e, p));
            return;
        }
        const auto middle = [this](int e) { return 0.5 * (foot(e) + foot(e + 1)); };
        int nearest = 0;
        for (int e = 1; e < sides(); ++e)
            if (glm::distance(p, middle(e)) < glm::distance(p, middle(nearest)) - same_place_) nearest = e;
        const double least = glm::distance(p, middle(nearest));
        const auto ties = [&](int e) { return std::abs(glm::distance(p, middle(e)) - least) <= same_place_; };
        int corner = -1;
        if (ties(nearest + 1)) corner = nearest + 1;
        else if (ties(nearest - 1)) corner = nearest;
        SolidPattern::Place place;
        const double own = azimuth(p);
        if (corner < 0) {
            place = beside_edge(nearest, p);
            if (place.along < -same_place_) corner = nearest;
            if (place.along > 1.0 + same_place_) corner = nearest + 1;
        }
        if (corner >= 0) {
            place = over_corner(corner, p);
            place.at = lifted(((corner % sides()) + sides()) % sides(), foot(corner), own);
            pattern_.mitred = true;
        } else {
            place.at = lifted(nearest, middle(nearest), own);
        }
        orbit.place = place;
    }

    void find_below(std::size_t i)
    {
        SolidPattern::Orbit& orbit = pattern_.orbits[i];
        const std::uint32_t v = representative_[i];
        const auto tier_of = [this](std::uint32_t w) { return orbit_of_[w] < 0 ? 0 : pattern_.orbits[std::size_t(orbit_of_[w])].tier; };
        // Counted from the vertex's own azimuth, so that a neighbour across 0° is in wedge −1.
        const auto spot_near = [&](std::uint32_t w) {
            if (is_apex(w) || is_apex(v)) return Tiling::Spot{orbit_of_[w], wedge_of_[w]};
            return spot(w, azimuth(place_[v]) + turn_between(azimuth(place_[v]), azimuth(place_[w])));
        };
        for (const Corner c : solid_.around(Vertex(v)))
            if (const std::uint32_t w = solid_.target(c).index; tier_of(w) < orbit.tier) orbit.below.push_back(spot_near(w));
        if (orbit.below.empty()) {
            std::uint32_t nearest = foot_[0];
            for (std::uint32_t w = 0; w < place_.size(); ++w)
                if (tier_of(w) < orbit.tier && glm::distance(place_[w], place_[v]) < glm::distance(place_[nearest], place_[v]) - same_place_) nearest = w;
            orbit.below.push_back(spot_near(nearest));
        }
        // The apex has the neighbours of one wedge in every wedge.
        if (is_apex(v)) {
            std::ranges::sort(orbit.below, {}, &Tiling::Spot::orbit);
            orbit.below.erase(std::unique(orbit.below.begin(), orbit.below.end(), [](auto a, auto b) { return a.orbit == b.orbit; }), orbit.below.end());
        }
    }

    static constexpr int none = 1 << 30;

    const PatternChoice& choice_;
    double same_azimuth_; // radians
    SolidPattern pattern_;
    std::vector<std::uint32_t> next_;           // image under the turn by one wedge
    std::vector<int> orbit_of_, wedge_of_;      // base orbits are −1, −2, …
    std::vector<std::uint32_t> representative_; // of each orbit
};

/// What the reading relies on: faces with three different vertices or more, and one edge at most between two vertices.
void refuse_degenerate(const Mesh& solid)
{
    std::vector<std::uint32_t> met(solid.vertex_limit(), Face::none);
    for (const Face f : solid.faces()) {
        if (solid.valence(f) < 3) throw CommandError(fmt::format("face {} of the solid has {} corner{}", f.index, solid.valence(f), solid.valence(f) == 1 ? "" : "s"));
        for (const Corner c : solid.corners(f))
            if (std::exchange(met[solid.vertex(c).index], f.index) == f.index)
                throw CommandError(fmt::format("face {} of the solid passes vertex {} twice", f.index, solid.vertex(c).index));
    }
    std::ranges::fill(met, Vertex::none);
    for (const Vertex v : solid.vertices())
        for (const Corner c : solid.around(v))
            if (std::exchange(met[solid.target(c).index], v.index) == v.index)
                throw CommandError(fmt::format("two edges of the solid join vertices {} and {}", v.index, solid.target(c).index));
}

} // namespace

Tiling SolidPattern::tiling() const
{
    Tiling tile(edges);
    std::vector<int> in_tier(std::size_t(tiers) + 1, 0);
    for (const Orbit& o : orbits)
        if (o.place.kind != Place::Kind::apex) ++in_tier[std::size_t(o.tier)];
    for (const int count : in_tier)
        if (count > 0) tile.tier(count);
    if (has_apex) tile.apex();
    std::vector<Tiling::Orbit> around;
    for (const int orbit : top) around.push_back({orbit});
    tile.top(std::move(around));
    for (const auto& row : rows) tile.row(row);
    return tile;
}

SolidPattern read_pattern(const Mesh& solid, const PatternChoice& choice)
{
    if (solid.boundary_count() > 0) throw CommandError("the solid is open");
    if (const Components parts = components(solid); parts.parts.size() != 1 || parts.parts[0].euler != 2)
        throw CommandError("the solid must be closed, in one piece and without holes through it");
    refuse_degenerate(solid);
    const TurnFinder turn(solid, reach_of(choice), choice.mirror);
    Face base;
    int turns = 0;
    if (choice.base) {
        base = *choice.base;
        if (base.index >= solid.face_limit()) throw CommandError(fmt::format("the solid has no face {}", base.index));
        turns = turn.largest(base);
    } else {
        int sides = 0;
        for (const Face f : solid.faces()) {
            const int n = solid.valence(f);
            if (choice.sides && n != *choice.sides) continue;
            // To beat the best face so far it must turn more often, or as often with more sides.
            const int least = n > sides ? turns : turns + 1;
            const int k = n < least ? 1 : turn.largest(f, least);
            if (k < least) continue;
            base = f;
            turns = k;
            sides = n;
        }
        if (!base.valid()) throw CommandError(choice.sides ? fmt::format("the solid has no face with {} sides", *choice.sides) : "the solid has no face to stand on");
    }
    if (choice.turns) {
        if (turns % *choice.turns != 0) throw CommandError(fmt::format("turns={}: expected a divisor of {}", *choice.turns, turns));
        turns = *choice.turns;
    }
    const int edges = solid.valence(base) / turns;
    if (choice.phase < 0 || choice.phase >= edges) throw CommandError(fmt::format("phase={}: expected 0 to {}", choice.phase, edges - 1));
    return Reader(solid, base, choice).read(turns);
}

} // namespace druse
