#include "tile/tile_outline.h"

#include "geom/predicates.h"
#include "geom/segments.h"
#include "tile/tile_refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace druse {

namespace {

/// Whether the places of points on straight edges with the same path can differ from edge to edge at all: going from edge to edge, the path
/// must not come back the other way round.
bool comes_back_reversed(const IsohedralType& type, int path)
{
    struct Relation {
        int from, to;
        bool reverses; // places along the edges
    };
    std::vector<Relation> relations;
    for (const TileCrossing& c : crossings(type.symbol)) relations.push_back({c.partner, c.edge, c.direct});
    for (const OwnSymmetry& own : type.own)
        for (int k = 0; k < type.corners; ++k) relations.push_back({k, type.symbol.corner(own.edge(k)), own.reflects});
    return std::ranges::any_of(relations, [&](const Relation& r) {
        const TileEdge &a = type.edges[r.from], &b = type.edges[r.to];
        return a.path == path && r.reverses != (runs_backwards(a.preparation) != runs_backwards(b.preparation));
    });
}

/// Numbers of sets of 0 … n − 1 that are joined pair by pair.
class Sets {
public:
    explicit Sets(int n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
    int find(int i)
    {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(int a, int b)
    {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<int> parent_;
};

/// Numbers orbits in the order in which the outline meets them.
void find_orbits(const IsohedralType& type, TileOutline& outline)
{
    const int n = outline.size();
    Sets sets(n);
    for (const auto& [edge, partner, direct] : type.placing) {
        const int from = outline.corner[edge], count = outline.corner[edge + 1] - from;
        const int there = outline.corner[partner];
        for (int s = 0; s <= count; ++s) sets.join((from + s) % n, (there + (direct ? count - s : s)) % n);
    }
    std::vector<int> number(n, -1);
    for (int i = 0; i < n; ++i) {
        int& set = number[sets.find(i)];
        if (set < 0) set = outline.orbits++;
        outline.points[i].orbit = set;
    }
}

} // namespace

std::vector<Point2> TileOutline::positions() const
{
    std::vector<Point2> list;
    list.reserve(points.size());
    for (const OutlinePoint& p : points) list.push_back(p.position);
    return list;
}

int TileOutline::find(const IsohedralType& type, const PointName& name) const
{
    if (name.kind == PointName::Kind::corner) return name.index < type.corners ? corner[name.index] : -1;
    if (!name.is_of_path() || name.edge >= type.corners) return -1;
    int edge = name.edge;
    if (edge < 0) edge = static_cast<int>(std::ranges::find(type.edges, name.path, &TileEdge::path) - type.edges.begin());
    if (edge >= type.corners || type.edges[edge].path != name.path) return -1;
    for (int i = corner[edge] + 1; i < corner[edge + 1]; ++i) {
        const PointName& other = points[i].name;
        if (other.kind == name.kind && (name.kind == PointName::Kind::middle || other.index == name.index)) return i;
    }
    return -1;
}

bool is_half_stored(const IsohedralType& type, int path)
{
    const PathShape shape = type.shapes[path];
    return shape == PathShape::half_turn || shape == PathShape::flip || (shape == PathShape::straight && comes_back_reversed(type, path));
}

void check_path(const IsohedralType& type, int path, std::span<const Point2> points)
{
    const char shape = letter(type.shapes[path]);
    for (const Point2& p : points) {
        if (!(std::abs(p.x) <= 1e100 && std::abs(p.y) <= 1e100)) throw CommandError(fmt::format("path point {},{}: numbers go to 1e100", p.x, p.y));
        if (type.shapes[path] == PathShape::straight && p.y != 0)
            throw TileRefusal(TileRefusal::Reason::half_path, fmt::format("path {} of {} is straight ({}): its points have v = 0", path, type.name(), shape));
        if (!is_half_stored(type, path)) continue;
        const bool last = &p == &points.back() && type.shapes[path] != PathShape::half_turn;
        if (!(p.x < 0.5 || (last && p.x == 0.5)))
            throw TileRefusal(TileRefusal::Reason::half_path,
                              fmt::format("path {} of {} is the same backwards ({}): its points lie in the first half, u {} 0.5", path, type.name(), shape,
                                          type.shapes[path] == PathShape::half_turn ? "below" : "up to"));
    }
}

std::vector<PathPoint> whole_path(const IsohedralType& type, int path, std::span<const Point2> stored)
{
    using Kind = PointName::Kind;
    std::vector<PathPoint> points;
    const int count = static_cast<int>(stored.size());
    for (int i = 0; i < count; ++i) points.push_back({Kind::path, i, stored[i]});
    if (!is_half_stored(type, path)) return points;
    const bool turns = type.shapes[path] == PathShape::half_turn;
    if (turns) points.push_back({Kind::middle, 0, {0.5, 0.0}});
    for (int i = count; i-- > 0;) {
        if (!turns && stored[i].x == 0.5) continue; // its own mirror image
        points.push_back({Kind::mirrored, i, {1.0 - stored[i].x, turns ? -stored[i].y : stored[i].y}});
    }
    return points;
}

TileOutline make_outline(const IsohedralType& type, const CornerVector& corners, double size, std::span<const std::vector<Point2>> paths)
{
    std::vector<std::vector<PathPoint>> whole;
    for (std::size_t p = 0; p < paths.size(); ++p) whole.push_back(whole_path(type, static_cast<int>(p), paths[p]));

    TileOutline outline;
    std::array<bool, most_corners> met{};
    for (int k = 0; k < type.corners; ++k) {
        const Point2 from = size * corner(corners, k), to = size * corner(corners, type.symbol.corner(k + 1));
        const auto [path, preparation] = type.edges[k];
        outline.corner.push_back(outline.size());
        outline.points.push_back({PointName::corner(k), from, k, 0, 0});
        std::vector<Point2> places;
        for (const PathPoint& p : whole[path]) places.push_back(p.at);
        places = prepared(places, preparation);
        const int count = static_cast<int>(places.size());
        for (int i = 0; i < count; ++i) {
            const PathPoint& p = whole[path][runs_backwards(preparation) ? count - 1 - i : i];
            outline.points.push_back({{p.kind, path, p.index, met[path] ? k : -1}, on_edge(places[i], from, to), k, i + 1, 0});
        }
        met[path] = true;
    }
    outline.corner.push_back(outline.size());
    find_orbits(type, outline);
    return outline;
}

Point2 prepared_point(const Point2& p, Preparation preparation)
{
    const bool turns_over = preparation == Preparation::half_turn || preparation == Preparation::mirror;
    return {runs_backwards(preparation) ? 1.0 - p.x : p.x, turns_over ? -p.y : p.y};
}

Point2 off_edge(const Point2& p, const Point2& from, const Point2& to)
{
    const Point2 along = to - from, q = p - from;
    return Point2(glm::dot(q, along), along.x * q.y - along.y * q.x) / glm::dot(along, along);
}

bool contains(std::span<const Point2> polygon, const Point2& p)
{
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Point2 &a = polygon[i], &b = polygon[j];
        if ((a.y > p.y) != (b.y > p.y) && (orient(a, b, p) > 0) == (a.y < b.y)) inside = !inside;
    }
    return inside;
}

NearestSide nearest_side(std::span<const Point2> polygon, const Point2& p)
{
    NearestSide best{0, 1e300};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2 &a = polygon[i], &b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
        const double distance = distance_to_segment(Point(p, 0.0), Point(a, 0.0), Point(b, 0.0));
        if (distance < best.distance) best = {static_cast<int>(i), distance};
    }
    return best;
}

double twice_area(std::span<const Point2> polygon)
{
    // Seen from one of its points, so that places far from the origin lose nothing.
    double twice = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const Point2 p = polygon[i - 1] - polygon[0], q = polygon[i] - polygon[0];
        twice += p.x * q.y - p.y * q.x;
    }
    return twice;
}

} // namespace druse
