#include "graph/strut_ball.h"

#include "dlfl/errors.h"
#include "geom/angle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace druse {

namespace {

constexpr std::uint32_t pole_bit = 1u << 31;   // in a name
constexpr std::uint32_t many = 16;             // edges at a vertex, from which on the order of points matters
constexpr double same_plane = 1e-6;            // distance of unit normals
constexpr double straight = 1e-6;              // sine of a corner that is none

std::uint32_t following(std::uint32_t k) { return k == 2 ? 0 : k + 1; }

/// A fixed order as good as any.
void shuffle(std::vector<std::uint32_t>& list, std::size_t from)
{
    std::minstd_rand random(1);
    for (std::size_t i = list.size(); i > from + 1; --i) std::swap(list[i - 1], list[from + random() % (i - from)]);
}

} // namespace

CoordinateGrid::CoordinateGrid(const Point& p, double reach)
{
    // Below 2^e, numbers that have 1.5 · 2^(e + 1) added to them lose what is less than 2^(e − 51).
    const double largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) + reach;
    int exponent = 0;
    std::frexp(largest, &exponent);
    shift_ = Vector(std::ldexp(1.5, exponent + 1));
}

/// A point over the middle of a polygon, so low that it is in sight of that polygon only. Together with it the hull holds a fan of triangles over
/// each polygon in place of the polygon itself, which rounding makes a little uneven: then nothing depends on how it would be cut.
Point BallMaker::pole(std::uint32_t end, const CoordinateGrid& grid) const
{
    const StrutPlacement::End& place = placement_.ends[end];
    const double reach = placement_.reach[v_], middle = std::cos(pi / shape_.sides); // of a side, in radii
    const double mine = std::asin(std::min(1.0, place.radius / reach));
    // Seen from the vertex, other polygons begin at that angle from the edge; what joins a side to one of them falls off at least as steeply.
    const double others = placer_.nearest_angle(end) * (1 - 0.5 * shape_.gap);
    const double drop = 2 * std::sin(0.5 * (others + mine)) * std::sin(0.5 * (others - mine));
    const double away = (others < 0.5 * pi ? std::sin(others) : 1.0) - middle * std::sin(mine);
    const double height = place.height + 0.5 * middle * place.radius * drop / away;
    const Vector along = placer_.direction(end / 2);
    return grid(graph_.vertices[v_] + (end % 2 == 0 ? height : -height) * along);
}

/// Points of the hull: four that span a solid first, then the other poles, so that no three corners of a polygon ever are a facet.
void BallMaker::gather(std::uint32_t v, const CoordinateGrid& grid)
{
    v_ = v;
    star_ = incidence_.ends(v);
    const auto valence = static_cast<std::uint32_t>(star_.size());
    points_.clear();
    names_.clear();
    const auto corner = [this](std::uint32_t i, std::uint32_t k) { names_.push_back(star_[i] * sides_ + k); };
    names_.push_back(pole_bit);
    corner(0, 0);
    corner(0, 1);
    for (std::uint32_t i = 1; i < valence; ++i) names_.push_back(pole_bit | i);
    const std::size_t corners = names_.size();
    for (std::uint32_t i = 0; i < valence; ++i)
        for (std::uint32_t k = i == 0 ? 2 : 0; k < sides_; ++k) corner(i, k);
    if (valence > many) {
        shuffle(names_, corners);
        std::vector<std::uint32_t> poles(names_.begin() + 4, names_.begin() + static_cast<std::ptrdiff_t>(corners));
        shuffle(poles, 0);
        std::copy(poles.begin(), poles.end(), names_.begin() + 4);
    }
    for (const std::uint32_t name : names_) points_.push_back(name & pole_bit ? pole(star_[name ^ pole_bit], grid) : rims_[name]);
}

std::uint32_t BallMaker::pole_of(const ConvexHull::Facet& f) const
{
    for (std::uint32_t k = 0; k < 3; ++k)
        if (f.corner[k] < names_.size() && (names_[f.corner[k]] & pole_bit)) return k;
    return 3;
}

/// True for a triangle that a pole makes with a side of its own polygon.
bool BallMaker::is_lid(const ConvexHull::Facet& f) const
{
    const std::uint32_t k = pole_of(f), end = star_[names_[f.corner[k]] ^ pole_bit], a = f.corner[following(k)], b = f.corner[following(following(k))];
    if (a >= names_.size() || b >= names_.size()) return false; // the vertex
    const std::uint32_t from = names_[a] - end * sides_, to = names_[b] - end * sides_;
    if (from >= sides_ || to >= sides_) return false;
    return end % 2 == 0 ? to == (from + 1) % sides_ : from == (to + 1) % sides_;
}

bool BallMaker::has_all_sides() const
{
    std::uint32_t lids = 0;
    for (const ConvexHull::Facet& f : hull_.facets()) {
        if (f.corner[0] == ConvexHull::none || pole_of(f) == 3) continue;
        if (!is_lid(f)) return false;
        ++lids;
    }
    return lids == star_.size() * sides_;
}

bool BallMaker::leaves_out(const Point& p, double least) const
{
    for (const ConvexHull::Facet& f : hull_.facets())
        if (f.corner[0] != ConvexHull::none && glm::dot(f.normal, p - hull_.point(f.corner[0])) > least * glm::length(f.normal)) return true;
    return false;
}

void BallMaker::make(std::uint32_t v, BallFaces& out)
{
    const CoordinateGrid grid(graph_.vertices[v], placement_.reach[v]);
    gather(v, grid);
    bool good = hull_.build(points_, &progress_) && has_all_sides();
    if (const Point middle = grid(graph_.vertices[v]); good && leaves_out(middle, 1e-6 * placement_.reach[v]) && hull_.add(middle)) {
        good = has_all_sides();
        out.apexes.push_back(middle);
    }
    if (!good) throw CommandError(fmt::format("{}: its struts are too thin for coordinates of that size", placer_.vertex_name(v)));
    if (shape_.merge && !shape_.triangulate) put_merged(out);
    else put_triangles(out);
    out.ball_ends.push_back(static_cast<std::uint32_t>(out.ends.size()));
}

std::uint32_t BallMaker::vertex(std::uint32_t point, const BallFaces& out) const
{
    return point < names_.size() ? names_[point] : BallFaces::apex | static_cast<std::uint32_t>(out.apexes.size() - 1);
}

void BallMaker::put_triangles(BallFaces& out)
{
    for (const ConvexHull::Facet& f : hull_.facets()) {
        if (f.corner[0] == ConvexHull::none || pole_of(f) < 3) continue;
        for (const std::uint32_t p : f.corner) out.corners.push_back(vertex(p, out));
        out.ends.push_back(static_cast<std::uint32_t>(out.corners.size()));
    }
}

/// Triangles that lie in a plane with a neighbour, and it with one of its own, are a region; if that is a strictly convex polygon it becomes one.
void BallMaker::put_merged(BallFaces& out)
{
    const auto facets = hull_.facets();
    const auto n = static_cast<std::uint32_t>(facets.size());
    constexpr std::uint32_t none = ConvexHull::none, dropped = none - 1;
    normals_.resize(n);
    region_of_.assign(n, none);
    for (std::uint32_t f = 0; f < n; ++f) {
        if (facets[f].corner[0] == none || pole_of(facets[f]) < 3) region_of_[f] = dropped;
        else normals_[f] = unit(facets[f].normal);
    }
    for (std::uint32_t f = 0; f < n; ++f) {
        if (region_of_[f] != none) continue;
        region_.assign(1, f);
        region_of_[f] = f;
        for (std::size_t i = 0; i < region_.size(); ++i)
            for (const std::uint32_t g : facets[region_[i]].neighbour) {
                if (region_of_[g] != none) continue;
                const Vector d = normals_[region_[i]] - normals_[g];
                if (!(glm::dot(d, d) < same_plane * same_plane)) continue;
                region_of_[g] = f;
                region_.push_back(g);
            }
        if (region_.size() > 1 && put_polygon(out)) continue;
        for (const std::uint32_t g : region_) {
            for (const std::uint32_t p : facets[g].corner) out.corners.push_back(vertex(p, out));
            out.ends.push_back(static_cast<std::uint32_t>(out.corners.size()));
        }
    }
}

/// The boundary of the region at hand as a face. False if it has more than one loop, a point within, or a corner that is not convex.
bool BallMaker::put_polygon(BallFaces& out)
{
    const auto facets = hull_.facets();
    const std::uint32_t mark = region_of_[region_[0]];
    const std::size_t points = names_.size() + 1;
    next_.resize(points);
    if (stamps_.size() < points) stamps_.resize(points, stamp_);
    ++stamp_;
    std::uint32_t sides = 0, first = 0;
    for (const std::uint32_t f : region_)
        for (std::uint32_t k = 0; k < 3; ++k) {
            if (region_of_[facets[f].neighbour[k]] == mark) continue;
            const std::uint32_t from = facets[f].corner[k];
            if (stamps_[from] == stamp_) return false; // it touches itself in a point
            stamps_[from] = stamp_;
            next_[from] = facets[f].corner[following(k)];
            if (sides++ == 0) first = from;
        }
    if (sides != region_.size() + 2) return false; // of a disc without a point within
    const Vector& up = normals_[region_[0]];
    std::uint32_t a = first, steps = 0;
    do {
        const std::uint32_t b = next_[a], c = next_[b];
        const Vector in = hull_.point(b) - hull_.point(a), on = hull_.point(c) - hull_.point(b);
        if (!(glm::dot(glm::cross(in, on), up) > straight * glm::length(in) * glm::length(on))) return false;
        a = b;
        ++steps;
    } while (a != first);
    if (steps != sides) return false;
    do {
        out.corners.push_back(vertex(a, out));
        a = next_[a];
    } while (a != first);
    out.ends.push_back(static_cast<std::uint32_t>(out.corners.size()));
    return true;
}

} // namespace druse
