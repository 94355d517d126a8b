// Where a place lies in a Triangulation: walks, the grid they start from, and what is near.
#include "dlfl/errors.h"
#include "pane/triangulation.h"

#include <algorithm>
#include <cmath>

namespace druse {

using Index = Triangulation::Index;

namespace {

double distance2(const Point2& p, const Point2& q)
{
    const Point2 d = p - q;
    return d.x * d.x + d.y * d.y;
}

/// From p to the straight piece a b.
double distance2(const Point2& p, const Point2& a, const Point2& b)
{
    const Point2 u = b - a, w = p - a;
    const double length2 = u.x * u.x + u.y * u.y, along = u.x * w.x + u.y * w.y;
    if (along <= 0) return w.x * w.x + w.y * w.y;
    if (along >= length2) return distance2(p, b);
    const double across = u.x * w.y - u.y * w.x;
    return across * (across / length2); // which does not overflow while the squares do not
}

std::uint32_t step(std::uint32_t& random) { return (random = random * 1664525u + 1013904223u) >> 16; }

} // namespace

Triangulation::Place Triangulation::locate(const Point2& p) const { return locate(p, start_near(p)); }

/// A visibility walk: over any edge that has p on its other side. Among constraints it could go round in circles, so that after some steps the
/// edge is chosen at random; after very many, the walk starts again from the nearest of some random vertices.
Triangulation::Place Triangulation::locate(const Point2& p, Index from) const
{
    Index h = from;
    int at_entry = orient(position(origin(h)), position(target(h)), p);
    if (at_entry < 0) {
        h = twin(h) == none ? next(h) : twin(h);
        at_entry = twin(from) == none ? orient(position(origin(h)), position(target(h)), p) : 1;
    }
    const std::size_t limit = 64 + 4 * static_cast<std::size_t>(std::sqrt(double(state_.vertices)));
    bool far = false;
    Index left = none, right = none;
    int at_left = 0, at_right = 0;
    for (std::size_t steps = 0;; ++steps) {
        ASSERT(h != none, "a walk stays in its box");
        left = next(h);
        right = previous(h);
        if (steps > 32 && (step(random_) & 1) != 0) std::swap(left, right);
        if ((at_left = orient(position(origin(left)), position(target(left)), p)) < 0) h = twin(left);
        else if ((at_right = orient(position(origin(right)), position(target(right)), p)) < 0) h = twin(right);
        else break;
        at_entry = 1;
        if (steps == limit && !far) {
            far = true;
            h = far_start(p);
            at_entry = orient(position(origin(h)), position(target(h)), p);
            if (at_entry < 0) {
                h = twin(h) == none ? h : twin(h);
                at_entry = -at_entry;
            }
        }
    }
    for (Index k = face(h); k < (h | 3); ++k) // what an insertion will look at next
        if (twin(k) != none) __builtin_prefetch(&sides_[twin(k)]);
    Place place{h, Place::Kind::face};
    const int zeros = (at_entry == 0) + (at_left == 0) + (at_right == 0);
    if (zeros == 1) place = {at_entry == 0 ? h : at_left == 0 ? left : right, Place::Kind::side};
    if (zeros == 2) { // p is the common end of two sides
        const Index away = at_entry != 0 ? h : at_left != 0 ? left : right;
        place = {previous(away), Place::Kind::vertex};
    }
    remember(p, h);
    return place;
}

// --- where walks start ------------------------------------------------------------------------------------------------------------

std::size_t Triangulation::cell(const Point2& p) const
{
    const double most = double(grid_width_) - 1;
    const double x = std::clamp((p.x - grid_min_.x) * grid_scale_.x, 0.0, most), y = std::clamp((p.y - grid_min_.y) * grid_scale_.y, 0.0, most);
    return static_cast<std::size_t>(y) * grid_width_ + static_cast<std::size_t>(x);
}

/// One cell for each point over the box of all points; a cell names a side seen there last, which may have gone elsewhere since.
void Triangulation::lay_grid() const
{
    grid_points_ = state_.vertices;
    grid_width_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(double(grid_points_))));
    Point2 min(1e300), max(-1e300);
    for (Index h = 0; h < sides_.size(); h += 4)
        if (is_face(h))
            for (Index k = 0; k < 3; ++k)
                if (!is_corner(origin(h + k))) {
                    min = glm::min(min, position(origin(h + k)));
                    max = glm::max(max, position(origin(h + k)));
                }
    grid_min_ = min;
    for (int k = 0; k < 2; ++k) grid_scale_[k] = max[k] > min[k] ? double(grid_width_) / (max[k] - min[k]) : 0;
    grid_.assign(grid_width_ * grid_width_, none);
    for (Index h = 0; h < sides_.size(); h += 4)
        if (is_face(h) && !is_corner(origin(h))) grid_[cell(position(origin(h)))] = h;
    Index known = last_;
    for (Index& h : grid_) {
        if (h == none) h = known;
        known = h;
    }
}

Index Triangulation::start_near(const Point2& p) const
{
    if (last_ >= sides_.size() || !is_face(last_)) {
        last_ = 0;
        while (!is_face(last_)) last_ += 4;
    }
    if (state_.vertices < 32) return last_;
    if (state_.vertices > 2 * grid_points_ || grid_.empty()) lay_grid();
    const auto cells_away = [&](const Point2& q) {
        const Point2 apart = (p - q) * grid_scale_;
        return std::abs(apart.x) + std::abs(apart.y);
    };
    double least = cells_away(last_place_);
    if (least < 2) return last_;
    // A side may have gone elsewhere since it was noted down: then one of the cells beside knows better.
    Index best = last_;
    const std::size_t here = cell(p), end = grid_.size();
    for (const std::size_t i : {here, here + 1, here - 1, here + grid_width_, here - grid_width_}) {
        if (i >= end || grid_[i] >= sides_.size() || !is_face(grid_[i])) continue;
        const double away = cells_away(position(origin(grid_[i])));
        if (away < least) {
            least = away;
            best = grid_[i];
        }
        if (least < 6) break;
    }
    return best;
}

void Triangulation::remember(const Point2& p, Index h) const
{
    last_ = face(h);
    last_place_ = p;
    if (!grid_.empty()) grid_[cell(p)] = last_;
}

Index Triangulation::far_start(const Point2& p) const
{
    Index best = last_;
    double least = 1e300;
    const auto tries = 16 + static_cast<std::size_t>(std::cbrt(double(state_.vertices)));
    for (std::size_t i = 0; i < tries; ++i) {
        const std::uint64_t number = (std::uint64_t(step(random_)) << 16) | step(random_);
        const auto h = static_cast<Index>(number * (sides_.size() / 4) >> 32) * 4;
        if (!is_face(h)) continue;
        const double d = distance2(p, position(origin(h)));
        if (d < least) {
            least = d;
            best = h;
        }
    }
    return best;
}

// --- what is near -----------------------------------------------------------------------------------------------------------------

/// Looks at all faces that a circle about p meets: from the one that holds p, over every edge within reach.
Triangulation::Nearby Triangulation::look_around(const Point2& p, const Place& at, double reach, Index ignored) const
{
    Nearby found;
    if (at.kind == Place::Kind::face && !is_near_a_side(p, at.side, reach)) return found;
    const double reach2 = reach * reach;
    const auto nearer = [&](Index& best, double& least, Index candidate, double d2) {
        if (d2 > reach2 || (best != none && d2 > least)) return;
        if (best != none && d2 == least && !is_before(position(origin(candidate)), position(origin(best)))) return;
        best = candidate;
        least = d2;
    };
    if (seen_.size() < sides_.size() / 4) seen_.resize(sides_.size() / 4, 0);
    if (++seen_now_ == 0) {
        std::fill(seen_.begin(), seen_.end(), 0);
        seen_now_ = 1;
    }
    std::vector<Index>& waiting = waiting_;
    waiting.assign(1, face(at.side));
    Index vertex_side = none;
    seen_[waiting[0] >> 2] = seen_now_;
    while (!waiting.empty()) {
        const Index t = waiting.back();
        waiting.pop_back();
        for (Index h = t; h < t + 3; ++h) {
            const Index v = origin(h), w = target(h);
            if (v != ignored && !is_corner(v)) nearer(vertex_side, found.vertex_distance2, h, distance2(p, position(v)));
            const double d2 = distance2(p, position(v), position(w));
            if (d2 > reach2) continue;
            if (v != ignored && w != ignored && (bits(h) & hull_bit) == 0) {
                // One side stands for both, the one that starts first, so that the answer is that of the edge.
                const Index named = is_before(position(v), position(w)) ? h : twin(h);
                if (is_fixed(h)) nearer(found.fixed, found.fixed_distance2, named, d2);
                else nearer(found.free, found.free_distance2, named, d2);
            }
            const Index o = twin(h);
            if (o != none && seen_[o >> 2] != seen_now_) {
                seen_[o >> 2] = seen_now_;
                waiting.push_back(face(o));
            }
        }
    }
    if (vertex_side != none) found.vertex = origin(vertex_side);
    return found;
}

/// False only if all of the face's sides, and so all else, are farther away than reach.
bool Triangulation::is_near_a_side(const Point2& p, Index of_face, double reach) const
{
    bool near = false;
    for (Index h = face(of_face); h < (of_face | 3); ++h) {
        const Point2 &a = position(origin(h)), &b = position(target(h));
        const Point2 u = b - a, w = p - a;
        near |= std::abs(u.x * w.y - u.y * w.x) <= reach * (std::abs(u.x) + std::abs(u.y));
    }
    return near;
}

} // namespace druse
