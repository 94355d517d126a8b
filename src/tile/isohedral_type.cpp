#include "tile/isohedral_type.h"

#include "dlfl/errors.h"
#include "geom/angle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace druse {

namespace {

/// Of lengths at the default corners; they are sums of square roots near 1.
constexpr double same = 1e-9;

/// The direction of edge k of the default tile, in full_turn parts.
int direction_of(const IsohedralType& type, int k)
{
    const Point2 along = corner(type.start, type.symbol.corner(k + 1)) - corner(type.start, k);
    return turns(static_cast<int>(std::lround(std::atan2(along.y, along.x) * full_turn / (2 * pi))));
}

/// The motion that carries the tile to its neighbour across an edge.
CornerMotion motion_of(const IsohedralType& type, const TileCrossing& crossing)
{
    const int k = crossing.edge, j = crossing.partner, there = direction_of(type, k), here = direction_of(type, j);
    if (crossing.direct) return motion_of_corner({turns(there + full_turn / 2 - here), false}, j, type.symbol.corner(k + 1));
    return motion_of_corner({turns(there + here), true}, j, k);
}

CornerMotion motion_of(const IsohedralType& type, const OwnSymmetry& own)
{
    const int k = type.symbol.corner(own.edge(0)), to = type.symbol.corner(own.corner(0));
    const int there = direction_of(type, k), here = direction_of(type, 0);
    if (own.reflects) return motion_of_corner({turns(there + full_turn / 2 + here), true}, 0, to);
    return motion_of_corner({turns(there - here), false}, 0, to);
}

/// That a motion carries one corner to another: two linear conditions.
void add_condition(std::vector<CornerVector>& conditions, const CornerMotion& motion, int from, int to)
{
    const CornerShift gap = plus(motion.shift, motion_of_corner(motion.turning, from, to).shift, -1.0);
    conditions.push_back(gap.x);
    conditions.push_back(gap.y);
}

/// The conditions that all neighbours fit and the symmetries of the tile hold. The default corners obey them.
std::vector<CornerVector> conditions_of(const IsohedralType& type)
{
    std::vector<CornerVector> list;
    const IncidenceSymbol& s = type.symbol;
    for (const TileCrossing& c : crossings(s)) {
        const CornerMotion motion = motion_of(type, c);
        add_condition(list, motion, s.corner(c.partner + 1), c.direct ? c.edge : s.corner(c.edge + 1));
    }
    for (const OwnSymmetry& own : type.own) {
        const CornerMotion motion = motion_of(type, own);
        for (int k = 1; k < s.corners; ++k) add_condition(list, motion, k, s.corner(own.corner(k)));
    }
    for (const CornerVector& condition : list) ASSERT(std::abs(dot(condition, type.start)) < same, "the tile of a net has every type on it");
    return list;
}

/// Paths and preparations: edges that a crossing or symmetry relates share a path, and what leads back to the same edge is a symmetry of it.
void find_paths(IsohedralType& type)
{
    struct Relation {
        int from, to;
        Preparation how;
    };
    std::vector<Relation> relations;
    for (const TileCrossing& c : crossings(type.symbol))
        relations.push_back({c.partner, c.edge, c.direct ? Preparation::half_turn : Preparation::mirror});
    for (const OwnSymmetry& own : type.own)
        for (int k = 0; k < type.corners; ++k)
            relations.push_back({k, type.symbol.corner(own.edge(k)), own.reflects ? Preparation::flip : Preparation::none});

    type.edges.assign(type.corners, {-1, Preparation::none});
    for (int first = 0; first < type.corners; ++first) {
        if (type.edges[first].path >= 0) continue;
        const int path = static_cast<int>(type.shapes.size());
        std::vector<int> members{first};
        type.edges[first].path = path;
        std::array<bool, 4> symmetry{true, false, false, false}; // by preparation
        for (std::size_t m = 0; m < members.size(); ++m)
            for (const Relation& r : relations) {
                if (r.from != members[m]) continue;
                const Preparation how = r.how * type.edges[r.from].preparation;
                if (type.edges[r.to].path < 0) {
                    type.edges[r.to] = {path, how};
                    members.push_back(r.to);
                } else {
                    symmetry[static_cast<int>(how * type.edges[r.to].preparation)] = true;
                }
            }
        const auto has = [&](Preparation p) { return symmetry[static_cast<int>(p)]; };
        const bool straight = has(Preparation::mirror) || (has(Preparation::half_turn) && has(Preparation::flip));
        type.shapes.push_back(straight                           ? PathShape::straight
                              : has(Preparation::half_turn) ? PathShape::half_turn
                              : has(Preparation::flip)      ? PathShape::flip
                                                            : PathShape::free);
        if (straight && (has(Preparation::half_turn) || has(Preparation::flip))) symmetry.fill(true);
        // Of preparations that make the same of the path, the first is written.
        for (const int k : members)
            for (int p = 0; p < 4; ++p)
                if (symmetry[static_cast<int>(static_cast<Preparation>(p) * type.edges[k].preparation)]) {
                    type.edges[k].preparation = static_cast<Preparation>(p);
                    break;
                }
    }
}

/// The translation that keeps its value at the default corners, so that size, place and direction are settled: the shortest; of equal ones that
/// which goes highest, then farthest right. Where nothing turns by less than a half turn, only one that every motion of the group leaves on its line.
CornerShift find_held_translation(const IsohedralType& type)
{
    const bool any = rotation_order(type.full) > 2;
    const CornerShift* best = nullptr;
    Point2 best_value(0.0);
    const auto list = translations(type.full, 4);
    for (const CornerShift& shift : list) {
        const Point2 t = shift.at(type.start);
        const bool stays = std::ranges::all_of(type.full.representatives, [&](const CornerMotion& m) {
            const Point2 moved = m.turning.times(t);
            return glm::length(moved - t) < same || glm::length(moved + t) < same;
        });
        if (!any && !stays) continue;
        const double longer = glm::length(t) - glm::length(best_value), higher = t.y - best_value.y;
        if (!best || longer < -1e-7 || (longer < 1e-7 && (higher > 1e-7 || (higher > -1e-7 && t.x > best_value.x + 1e-7)))) {
            best = &shift;
            best_value = t;
        }
    }
    ASSERT(best != nullptr, "a translation to hold");
    return *best;
}

void find_parameters(IsohedralType& type)
{
    auto conditions = conditions_of(type);
    const int count = 2 * type.corners;
    type.admissible = solutions(conditions, count);

    const CornerShift kept = find_held_translation(type);
    conditions.push_back(kept.x);
    conditions.push_back(kept.y);
    for (const int i : {2 * type.held, 2 * type.held + 1}) conditions.emplace_back()[i] = 1.0;
    type.inside = solutions(conditions, count);

    std::vector<int> order; // from the held corner outwards
    for (int step = 1; step <= type.corners / 2; ++step)
        for (const int k : {type.symbol.corner(type.held + step), type.symbol.corner(type.held - step)})
            for (const int i : {2 * k, 2 * k + 1})
                if (std::ranges::find(order, i) == order.end()) order.push_back(i);
    type.parameters = free_coordinates(type.inside, order);
    type.movements = unit_movements(type.inside, type.parameters);
    if (!type.parameters.empty()) type.held_translation = kept;
}

/// Aspects that are the powers of one rotation onto a neighbour, where there is one that gives all of them.
void prefer_powers(IsohedralType& type)
{
    for (const TileCrossing& c : type.placing) {
        const CornerMotion step = motion_of(type, c);
        if (step.turning.reflects) return;
        std::vector<CornerMotion> powers{CornerMotion{}};
        for (CornerMotion next = step; next.turning != Turning{}; next = next * step) powers.push_back(next);
        if (powers.size() < type.placed.representatives.size()) continue;
        type.placed.representatives = powers;
        return;
    }
}

void find_neighbours(IsohedralType& type)
{
    const PlaneGroup& group = type.placed;
    for (const CornerMotion& aspect : group.representatives) {
        auto& around = type.neighbours.emplace_back();
        for (const TileCrossing& c : type.placing) {
            const CornerMotion there = aspect * motion_of(type, c);
            const int to = group.find(there.turning);
            const Point2 shift = there.shift.at(type.start) - group.representatives[to].shift.at(type.start);
            around.push_back({to, lattice_place(group, type.start, shift), c.partner});
        }
    }
}

void find_corner_orbits(IsohedralType& type)
{
    auto& orbit = type.corner_orbit;
    orbit.resize(type.corners);
    std::iota(orbit.begin(), orbit.end(), 0);
    const auto join = [&](int a, int b) {
        const int from = orbit[type.symbol.corner(a)], to = orbit[type.symbol.corner(b)];
        std::ranges::replace(orbit, std::max(from, to), std::min(from, to));
    };
    for (const auto& [edge, partner, direct] : type.placing) {
        join(partner, direct ? edge + 1 : edge);
        join(partner + 1, direct ? edge : edge + 1);
    }
    std::vector<int> names; // numbered as they are met
    for (int& o : orbit) {
        const auto known = std::ranges::find(names, o);
        const int number = static_cast<int>(known - names.begin());
        if (known == names.end()) names.push_back(o);
        o = number;
    }
}

IsohedralType derive(const TileLine& line)
{
    IsohedralType type;
    type.number = line.number;
    type.net = &tile_nets()[line.net];
    type.symbol = IncidenceSymbol::parse(type.net->valences, line.tile, line.adjacency);
    type.corners = type.symbol.corners;
    type.held = type.net->held;
    std::ranges::copy(type.net->corners, type.start.begin());
    type.own = own_symmetries(type.symbol);
    find_paths(type);

    std::vector<CornerMotion> all, placed;
    for (const TileCrossing& c : crossings(type.symbol)) all.push_back(motion_of(type, c));
    for (const OwnSymmetry& own : type.own) all.push_back(motion_of(type, own));
    type.full = generate(all, type.start);
    find_parameters(type);

    type.placing = parse_placed(type.symbol, line.placed);
    for (const TileCrossing& c : type.placing) placed.push_back(motion_of(type, c));
    type.placed = generate(placed, type.start);
    prefer_powers(type);
    find_neighbours(type);
    find_corner_orbits(type);
    type.colours = colour_tiles(type);
    return type;
}

} // namespace

Point2 TileFrame::world(const Point2& p) const
{
    const Point2 turned(std::cos(rotation), std::sin(rotation));
    return origin + size * Point2(turned.x * p.x - turned.y * p.y, turned.y * p.x + turned.x * p.y);
}

Point2 TileFrame::canonical(const Point2& world) const
{
    const Point2 p = world - origin, turned(std::cos(rotation), std::sin(rotation));
    return Point2(turned.x * p.x + turned.y * p.y, turned.x * p.y - turned.y * p.x) / size;
}

std::string IsohedralType::name() const { return fmt::format("IH{:02}", number); }

std::string IsohedralType::own_name() const
{
    const auto rotations = std::ranges::count(own, false, &OwnSymmetry::reflects);
    return fmt::format("{}{}", rotations < std::ssize(own) ? 'D' : 'C', rotations);
}

std::string IsohedralType::parameter_name(int p) const { return fmt::format("{}{}", parameters[p] % 2 == 0 ? 'x' : 'y', parameters[p] / 2); }

std::string IsohedralType::edge_text() const
{
    std::string text;
    for (const TileEdge& e : edges) text += fmt::format("{}{}{}", text.empty() ? "" : " ", static_cast<char>('a' + e.path), letter(e.preparation));
    return text;
}

std::string IsohedralType::shape_text() const
{
    std::string text;
    for (const PathShape s : shapes) text += letter(s);
    return text;
}

bool IsohedralType::has_mirrored_aspects() const
{
    return std::ranges::any_of(placed.representatives, [](const CornerMotion& m) { return m.turning.reflects; });
}

std::vector<double> IsohedralType::default_parameters() const
{
    std::vector<double> values;
    for (const int i : parameters) values.push_back(start[i]);
    return values;
}

CornerVector IsohedralType::corners_of(std::span<const double> values) const
{
    if (values.size() != parameters.size()) {
        std::string names;
        for (std::size_t p = 0; p < parameters.size(); ++p) names += fmt::format("{}{}", p > 0 ? " " : "", parameter_name(static_cast<int>(p)));
        throw CommandError(parameters.empty() ? fmt::format("{} has no parameters", name())
                                              : fmt::format("{} has {} parameter{}: {}", name(), parameters.size(), parameters.size() == 1 ? "" : "s", names));
    }
    CornerVector result = start;
    for (std::size_t p = 0; p < values.size(); ++p) result = plus(result, movements[p], values[p] - start[parameters[p]]);
    return result;
}

MovedTile drag_corner(const IsohedralType& type, std::span<const double> parameters, int k, const Point2& target)
{
    if (type.parameters.empty()) throw CommandError(fmt::format("corners of {} are fixed", type.name()));
    const CornerVector corners = type.corners_of(parameters);
    const Point2 by = target - corner(corners, k);
    if (type.inside.freedom(k) == 0) return nearest_tile(type, plus(corners, type.admissible.drag(k, by)));
    const CornerVector moved = plus(corners, type.inside.drag(k, by));
    MovedTile result;
    for (const int i : type.parameters) result.parameters.push_back(moved[i]);
    return result;
}

MovedTile nearest_tile(const IsohedralType& type, const CornerVector& corners)
{
    const CornerVector near = type.admissible.project(corners);
    MovedTile result;
    result.frame.origin = corner(near, type.held);
    // Where nothing is free within the frame, any edge tells size and direction.
    const int next = type.symbol.corner(type.held + 1);
    const auto measure = [&](const CornerVector& v) { return type.held_translation ? type.held_translation->at(v) : corner(v, next) - corner(v, type.held); };
    const Point2 was = measure(type.start), is = measure(near);
    result.frame.size = glm::length(is) / glm::length(was);
    result.frame.rotation = std::atan2(was.x * is.y - was.y * is.x, glm::dot(was, is));
    for (const int i : type.parameters) {
        const Point2 p = result.frame.canonical(corner(near, i / 2));
        result.parameters.push_back(i % 2 == 0 ? p.x : p.y);
    }
    return result;
}

const std::vector<IsohedralType>& isohedral_types()
{
    static const std::vector<IsohedralType> types = [] {
        std::vector<IsohedralType> list;
        for (const TileLine& line : tile_lines()) list.push_back(derive(line));
        return list;
    }();
    return types;
}

const IsohedralType& isohedral_type(int number)
{
    const auto found = std::ranges::find(isohedral_types(), number, &IsohedralType::number);
    if (found != isohedral_types().end()) return *found;
    if (number < 1 || number > 93) throw CommandError(fmt::format("there is no type IH{:02}: they are IH01 to IH93", number));
    throw CommandError(fmt::format("IH{:02} needs marked tiles: without marks they have more symmetry than the type", number));
}

} // namespace druse
