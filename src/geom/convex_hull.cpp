#include "geom/convex_hull.h"

#include "geom/predicates.h"

#include <algorithm>
#include <utility>

namespace druse {

namespace {

/// On one line, exactly: in the three coordinate planes.
bool are_collinear(const Point& a, const Point& b, const Point& c)
{
    const auto flat = [](double x, double y) { return Point2(x, y); };
    return orient(flat(a.x, a.y), flat(b.x, b.y), flat(c.x, c.y)) == 0 && orient(flat(a.y, a.z), flat(b.y, b.z), flat(c.y, c.z)) == 0 &&
           orient(flat(a.z, a.x), flat(b.z, b.x), flat(c.z, c.x)) == 0;
}

} // namespace

/// The normal of a facet times a difference of points is off by 46 rounding errors of the cube of the largest difference, at most.
void ConvexHull::bound_errors()
{
    Box box;
    for (const Point& p : points_) box.add(p);
    const Vector size = box.size();
    const double reach = std::max({size.x, size.y, size.z});
    certain_ = reach > 1e-90 && reach < 1e90 ? 100 * filter::epsilon * reach * reach * reach : std::numeric_limits<double>::infinity();
}

inline bool ConvexHull::sees(const Facet& f, const Point& p) const
{
    const Point& a = points_[f.corner[0]];
    const double height = glm::dot(f.normal, p - a);
    if (height > certain_) return true;
    if (height < -certain_) return false;
    return orient(a, points_[f.corner[1]], points_[f.corner[2]], p) > 0;
}

std::uint32_t ConvexHull::make(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    std::uint32_t f = static_cast<std::uint32_t>(facets_.size());
    if (free_.empty()) {
        facets_.emplace_back();
    } else {
        f = free_.back();
        free_.pop_back();
    }
    Facet& facet = facets_[f];
    facet.corner = {a, b, c};
    facet.normal = glm::cross(points_[b] - points_[a], points_[c] - points_[a]);
    facet.waiting = facet.seen_by = none;
    return f;
}

bool ConvexHull::find_solid(std::array<std::uint32_t, 4>& corners) const
{
    const auto n = static_cast<std::uint32_t>(points_.size());
    auto& [a, b, c, d] = corners;
    a = 0;
    for (b = 1; b < n && points_[b] == points_[a];) ++b;
    for (c = b + 1; c < n && are_collinear(points_[a], points_[b], points_[c]);) ++c;
    int side = 0;
    for (d = c + 1; d < n; ++d)
        if ((side = orient(points_[a], points_[b], points_[c], points_[d])) != 0) break;
    if (side > 0) std::swap(b, c);
    return side != 0;
}

void ConvexHull::begin_with(const std::array<std::uint32_t, 4>& corners)
{
    const auto& [a, b, c, d] = corners; // d is below a, b, c
    facets_.clear();
    free_.clear();
    make(a, b, c);
    make(b, a, d);
    make(c, b, d);
    make(a, c, d);
    facets_[0].neighbour = {1, 2, 3};
    facets_[1].neighbour = {0, 3, 2};
    facets_[2].neighbour = {0, 1, 3};
    facets_[3].neighbour = {0, 2, 1};
}

bool ConvexHull::build(std::span<const Point> points, const Progress* progress)
{
    const auto n = static_cast<std::uint32_t>(points.size());
    points_.assign(points.begin(), points.end());
    facets_.clear();
    std::array<std::uint32_t, 4> first;
    if (n < 4 || !find_solid(first)) return false;
    bound_errors();
    begin_with(first);
    sees_.assign(n, none);
    after_.resize(n);
    at_.resize(n);
    for (std::uint32_t p = n; p-- > 0;)
        for (std::uint32_t f = 0; f < 4; ++f)
            if (sees(facets_[f], points_[p])) {
                sees_[p] = f;
                after_[p] = std::exchange(facets_[f].waiting, p);
                break;
            }
    for (std::uint32_t p = 0; p < n; ++p) {
        if (p % 256 == 0 && progress && progress->cancelled()) throw Cancelled();
        if (sees_[p] != none) insert(p, sees_[p]);
    }
    return true;
}

bool ConvexHull::add(const Point& p)
{
    const auto n = static_cast<std::uint32_t>(points_.size());
    points_.push_back(p);
    bound_errors();
    for (std::uint32_t f = 0; f < facets_.size(); ++f)
        if (facets_[f].corner[0] != none && sees(facets_[f], p)) {
            sees_.push_back(f);
            after_.push_back(none);
            at_.push_back(none);
            insert(n, f);
            return true;
        }
    points_.pop_back();
    return false;
}

/// Puts a cone from p in place of the facets that it sees, of which `seen` is one.
void ConvexHull::insert(std::uint32_t p, std::uint32_t seen)
{
    const Point& place = points_[p];
    const auto look = [&](std::uint32_t f, bool sure) {
        facets_[f].seen_by = p;
        facets_[f].visible = sure || sees(facets_[f], place);
        if (facets_[f].visible) visible_.push_back(f);
    };
    visible_.clear();
    look(seen, true);
    for (std::size_t i = 0; i < visible_.size(); ++i)
        for (const std::uint32_t g : facets_[visible_[i]].neighbour)
            if (facets_[g].seen_by != p) look(g, false);

    // What is seen is a disc, each corner of its rim has one side that starts there.
    made_.clear();
    for (const std::uint32_t f : visible_)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t g = facets_[f].neighbour[k];
            if (facets_[g].visible && facets_[g].seen_by == p) continue;
            const std::uint32_t a = facets_[f].corner[k], b = facets_[f].corner[k == 2 ? 0 : k + 1], n = make(a, b, p);
            facets_[n].neighbour[0] = g;
            Facet& outer = facets_[g];
            outer.neighbour[outer.corner[0] == b ? 0 : outer.corner[1] == b ? 1 : 2] = n;
            at_[a] = n;
            made_.push_back(n);
        }
    for (const std::uint32_t n : made_) {
        const std::uint32_t next = at_[facets_[n].corner[1]];
        facets_[n].neighbour[1] = next;
        facets_[next].neighbour[2] = n;
    }

    // A point that saw what has gone sees one of the new facets, or lies inside: if it sees one that was there before, then also a new one
    // beside it, for around each side of the rim the new plane lies between the two old ones.
    for (const std::uint32_t f : visible_) {
        for (std::uint32_t q = facets_[f].waiting; q != none;) {
            const std::uint32_t rest = after_[q];
            sees_[q] = none;
            if (q != p)
                for (const std::uint32_t n : made_)
                    if (sees(facets_[n], points_[q])) {
                        sees_[q] = n;
                        after_[q] = std::exchange(facets_[n].waiting, q);
                        break;
                    }
            q = rest;
        }
        facets_[f].corner[0] = none;
        free_.push_back(f);
    }
}

} // namespace druse
