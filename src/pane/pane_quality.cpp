// Better triangles in a Pane: points that make small angles larger, and points moved apart.
#include "pane/pane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numbers>

namespace druse {

using Index = Pane::Index;

namespace {

constexpr double surely_met = 20.7; // degrees up to which refinement is known to end

// Faces that are looked through for the centre of one triangle, and for all of them: so many at the start, and for each point that is made. They are few as a rule, but not in
// fans of very many triangles, most of which have their centres too near to a wall; what is in the way of the last of these is not looked for.
constexpr std::size_t usual_faces = 256, most_faces = 4'000'000, faces_for_point = 64;

// What is made in turn follows the places of points, never the numbers of faces and vertices: those differ between a pane and the same one read from a
// file.

/// The side of a face that begins at the first of its corners by x, then y.
Index first_side(const Triangulation& t, Index face)
{
    Index first = Triangulation::face(face);
    for (Index h = first + 1; h < (face | 3); ++h)
        if (is_before(t.position(t.origin(h)), t.position(t.origin(first)))) first = h;
    return first;
}

/// Of the sides that leave a vertex, the one whose end is the first by x, then y.
Index first_out(const Triangulation& t, Index v)
{
    Index first = t.out(v);
    for (Index h = t.turn(first); h != t.out(v); h = t.turn(h))
        if (is_before(t.position(t.target(h)), t.position(t.target(first)))) first = h;
    return first;
}

} // namespace

/// One refinement of a pane. Edges that a point lies too near to (within the circle on them) are halved first; then bad triangles get a point at the centre
/// of their circle, unless that would come too near to such an edge: then that is halved instead. Edges that may not be split are walls. What is too large
/// beside one gets a point as near to that centre as the wall allows, once nothing else is left to do.
///
/// Ends: a centre is at least as far from all that it sees as the shortest side of a bad triangle is long, and farther than 0.87 √max_area where that is too
/// large; points before walls are never nearer than `weld`, and there is a number that all stop at.
class Refiner {
public:
    Refiner(Pane& pane, const Pane::Refinement& asked, Progress* progress)
        : pane_(pane), t_(pane.triangulation_), asked_(asked), progress_(progress), sine_(std::sin(asked.min_angle * (std::numbers::pi / 180)))
    {
        doubled_most_ = asked.max_area ? 2 * *asked.max_area : std::numeric_limits<double>::infinity();
        double doubled = 0; // the area of the pane
        for (Index h = 0; h < t_.side_end(); h += 4)
            if (t_.is_face(h) && t_.is_inside(h)) doubled += doubled_area(h);
        const double pieces = doubled / doubled_most_; // that the largest triangles allowed would be
        if (const double least = (pieces - double(pane.triangle_count())) / 2; !(least <= double(Pane::most_refined)))
            pane.refuse(Pane::Reason::range, fmt::format("max_area={}: it takes {:.3g} points and more, and {} are the most; expected well above {:.3g}", *asked.max_area, least,
                                                         Pane::most_refined, doubled / 2 / (2 * double(Pane::most_refined) + double(pane.triangle_count()))));
        const std::size_t tried = 50 * pane.state_.points + static_cast<std::size_t>(8 * pieces);
        most_ = asked.min_angle <= surely_met ? Pane::most_refined : std::min(Pane::most_refined, tried);
    }

    Pane::Refined run()
    {
        for (Index v = 0; v < t_.vertex_end(); ++v)
            if (pane_.points_[v].refined) pane_.points_.change(v).refined = false;
        std::vector<Index> faces;
        for (Index h = 0; h < t_.side_end(); h += 4)
            if (t_.is_face(h) && t_.is_inside(h)) faces.push_back(first_side(t_, h));
        std::sort(faces.begin(), faces.end(), [&](Index f, Index g) {
            const Point2 &p = at(t_.origin(f)), &q = at(t_.origin(g));
            return p != q ? is_before(p, q) : is_before(at(t_.target(f)), at(t_.target(g))); // two faces at a corner have other next ones
        });
        for (const Index h : faces) look_at(h);
        for (std::size_t steps = 0; result_.complete; ++steps) {
            if (!edges_.empty()) {
                const auto [u, v] = edges_.front();
                edges_.pop_front();
                const Index h = t_.find_side(u, v);
                if (h != Pane::none && is_crowded(h)) halve(h);
            } else if (!triangles_.empty()) {
                take(triangles_, false);
            } else if (!walled_.empty()) {
                take(walled_, true);
            } else {
                break;
            }
            if (result_.made >= most_) result_.complete = edges_.empty() && triangles_.empty() && walled_.empty();
            if (progress_ && steps % 256 == 0) progress_->step(double(steps) / double(steps + edges_.size() + triangles_.size() + walled_.size()));
        }
        pane_.settle();
        for (Index h = 0; h < t_.side_end(); h += 4) {
            if (!t_.is_face(h) || !t_.is_inside(h) || falls_short(h) == Pane::none) continue;
            ++result_.falling_short;
            result_.too_large += is_large(h);
        }
        return result_;
    }

private:
    using Corners = std::array<Index, 3>; // of a triangle, from its first side on

    const Point2& at(Index v) const { return t_.position(v); }
    static double square(const Point2& d) { return glm::dot(d, d); }
    static double cross(const Point2& u, const Point2& w) { return u.x * w.y - u.y * w.x; }
    /// Of the triangle of a side and a place to its left.
    double doubled_area(Index h, const Point2& p) const { return cross(at(t_.target(h)) - at(t_.origin(h)), p - at(t_.origin(h))); }
    double doubled_area(Index face) const { return doubled_area(face, at(t_.apex(face))); }
    bool is_large(Index face) const { return doubled_area(face) > doubled_most_; }

    /// May the edge be split at all?
    bool is_splittable(Index h) const
    {
        const std::uint32_t bits = t_.bits(h);
        return bits != 0 && ((bits & Triangulation::loop_bit) == 0 || asked_.split_boundary) &&
               square(at(t_.origin(h)) - at(t_.target(h))) > 64 * pane_.state_.weld * pane_.state_.weld;
    }

    bool sees_within_circle(Index h, const Point2& p) const { return glm::dot(at(t_.origin(h)) - p, at(t_.target(h)) - p) < 0; }

    /// Does a point of the pane that the edge sees lie within the circle on it?
    bool is_crowded(Index h) const
    {
        if (!is_splittable(h)) return false;
        for (const Index side : {h, t_.twin(h)})
            if (t_.is_inside(side) && sees_within_circle(side, at(t_.apex(side)))) return true;
        return false;
    }

    /// Would a point there leave an edge that may not be split with an angle too small, and with no way to mend it? For the sake of area, only one so near
    /// that another does more.
    bool is_too_near_wall(Index h, const Point2& p, bool large) const
    {
        if (!sees_within_circle(h, p)) return false;
        const double doubled = doubled_area(h, p);
        if (large) return doubled < doubled_most_ / 4;
        const Point2 &a = at(t_.origin(h)), &b = at(t_.target(h));
        return doubled < sine_ * glm::length(b - a) * std::max(glm::length(p - a), glm::length(p - b));
    }

    /// The shortest side, if the angle opposite to it is too small or the area too large; else none.
    Index falls_short(Index face) const
    {
        Index h = first_side(t_, face), least = h;
        std::array<double, 3> lengths;
        std::size_t shortest = 0;
        for (std::size_t i = 0; i < 3; ++i, h = Triangulation::next(h)) {
            lengths[i] = glm::length(at(t_.origin(h)) - at(t_.target(h)));
            if (lengths[i] >= lengths[shortest]) continue;
            shortest = i;
            least = h;
        }
        // The sine of the smallest angle is twice the area by the two longer sides.
        const double doubled = doubled_area(least);
        const bool small_angle = doubled / lengths[(shortest + 1) % 3] / lengths[(shortest + 2) % 3] < sine_;
        return small_angle || doubled > doubled_most_ ? least : Pane::none;
    }

    /// An angle between two lines of the pane stays as it is, and so does what the halving of both at one distance from it makes.
    bool is_bad(Index face) const
    {
        const Index least = falls_short(face);
        if (least == Pane::none || !t_.is_inside(face)) return false;
        if (is_large(least)) return true;
        if (t_.is_fixed(Triangulation::next(least)) && t_.is_fixed(Triangulation::previous(least))) return false;
        const Index a = t_.origin(least), b = t_.target(least);
        return !(a < corner_of_.size() && b < corner_of_.size() && corner_of_[a] != Pane::none && corner_of_[a] == corner_of_[b]);
    }

    void look_at(Index face)
    {
        const Index first = first_side(t_, face);
        for (const Index h : {first, Triangulation::next(first), Triangulation::previous(first)})
            if (t_.is_fixed(h) && is_crowded(h)) edges_.emplace_back(t_.origin(h), t_.target(h));
        if (is_bad(face)) triangles_.push_back({t_.origin(first), t_.target(first), t_.apex(first)});
    }

    /// Mends the first triangle of a queue, if it is there still.
    void take(std::deque<Corners>& queue, bool before_wall)
    {
        const Corners corners = queue.front();
        queue.pop_front();
        const Index h = t_.find_side(corners[0], corners[1]);
        if (h != Pane::none && t_.apex(h) == corners[2] && is_bad(h)) mend(h, before_wall);
    }

    void made(Index v)
    {
        ++result_.made;
        pane_.points_.change(v).refined = true;
        const Index first = first_out(t_, v);
        Index h = first;
        do {
            if (t_.is_inside(h)) look_at(h);
            h = t_.turn(h);
        } while (h != first);
    }

    /// Where two lines of the pane leave v by less than 60 degrees, the halves of them are powers of two, so that those of both end alike.
    bool is_sharp(Index v) const
    {
        const Index first = t_.out(v);
        Index h = first;
        std::vector<Point2> lines;
        do {
            if (t_.is_fixed(h)) lines.push_back(glm::normalize(at(t_.target(h)) - at(v)));
            h = t_.turn(h);
        } while (h != first);
        for (std::size_t i = 0; i < lines.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                if (glm::dot(lines[i], lines[k]) > 0.5) return true;
        return false;
    }

    /// False where the edge stays as it is.
    bool halve(Index h)
    {
        if (!is_splittable(h)) return false;
        Index u = t_.origin(h), v = t_.target(h);
        const bool u_sharp = is_sharp(u), v_sharp = is_sharp(v), loop = (t_.bits(h) & Triangulation::loop_bit) != 0;
        double part = 0.5;
        Index corner = Pane::none;
        if (u_sharp != v_sharp) {
            if (v_sharp) std::swap(u, v);
            const double length = glm::length(at(v) - at(u));
            part = std::exp2(std::round(std::log2(length / 2))) / length;
            corner = u;
        }
        const Point2 middle = at(u) + part * (at(v) - at(u));
        if (t_.look_around(middle, t_.locate(middle), pane_.state_.weld).vertex != Pane::none) return false;
        const Index w = pane_.split_edge(u, v, middle);
        if (corner != Pane::none) {
            corner_of_.resize(std::max<std::size_t>(corner_of_.size(), t_.vertex_end()), Pane::none);
            corner_of_[w] = corner;
        }
        if (loop && pane_.twins_.size() > 0) pane_.twin_split(w, u, v);
        if (pane_.loops_changed_) pane_.settle();
        else pane_.realise();
        made(w);
        for (const auto& [a, b] : {std::pair{u, w}, std::pair{w, v}})
            if (const Index side = t_.find_side(a, b); side != Pane::none && is_crowded(side)) edges_.emplace_back(a, b);
        return true;
    }

    /// A point at a place, which is seen from `face`, if it is not too near to another or to a line.
    bool put(const Point2& p, Index face)
    {
        const auto place = t_.locate(p, face);
        if (!t_.is_inside(place.side)) return false;
        const auto near = t_.look_around(p, place, 4 * pane_.state_.weld);
        if (near.vertex != Pane::none || near.fixed != Pane::none) return false;
        made(pane_.put(p, Pane::none, place));
        return true;
    }

    /// Whether so many faces may be looked through for one triangle.
    bool may_look(std::size_t faces)
    {
        if (faces <= usual_faces) return true;
        return ++looked_ <= most_faces + faces_for_point * result_.made;
    }

    /// A triangle that only has a small angle stays as it is.
    void give_up(const Point2& middle, Index face, bool large)
    {
        halves_.clear();
        if (large) put(middle, face);
    }

    /// The centre of the triangle's circle, if nothing is in the way. `face` is its first side. Of what waits before a wall, whatever does.
    void mend(Index face, bool before_wall)
    {
        const Corners corners{t_.origin(face), t_.target(face), t_.apex(face)};
        const bool large = is_large(face);
        const Point2 u = at(corners[1]) - at(corners[0]), w = at(corners[2]) - at(corners[0]);
        const double doubled = cross(u, w), uu = square(u), ww = square(w);
        const Point2 start = at(corners[0]) + (u + w) / 3.0, centre = at(corners[0]) + Point2(w.y * uu - u.y * ww, u.x * ww - w.x * uu) / (2 * doubled);
        if (!std::isfinite(centre.x) || !std::isfinite(centre.y)) return;

        // Straight from the middle of the triangle to the centre, as far as the next line.
        Index h = face, came = Pane::none, wall = Pane::none;
        for (std::size_t faces = 1; wall == Pane::none; ++faces) {
            if (!may_look(faces)) return give_up(start, face, large);
            Index through = Pane::none;
            const Index first = first_side(t_, h);
            for (const Index side : {first, Triangulation::next(first), Triangulation::previous(first)})
                if (side != came && orient(at(t_.origin(side)), at(t_.target(side)), centre) < 0 && orient(start, centre, at(t_.origin(side))) <= 0 &&
                    orient(start, centre, at(t_.target(side))) >= 0)
                    through = side;
            if (through == Pane::none) break;
            if (t_.is_fixed(through)) {
                wall = through;
                if (is_splittable(wall)) halves_.emplace_back(t_.origin(wall), t_.target(wall));
            } else {
                came = t_.twin(through);
                h = Triangulation::face(came);
            }
        }
        if (wall == Pane::none) {
            const auto found = look_round(centre, h, large);
            if (!found) return give_up(start, face, large);
            wall = *found;
        }

        bool halved = false;
        for (const auto& [from, to] : std::exchange(halves_, {}))
            if (const Index side = t_.find_side(from, to); side != Pane::none) halved |= halve(side);
        if (halved) {
            triangles_.push_back(corners); // it may be there still, and bad
        } else if (wall == Pane::none) {
            if (!put(centre, h) && large) put(start, face);
        } else if (large && !before_wall) {
            walled_.push_back(corners);
        } else if (large) {
            put_before(wall, start, centre, face);
        }
    }

    /// Looks at the faces that would make room for a centre, and at the lines around them: what the centre is too near to is to be halved. Returns one that
    /// may not, or none; nothing where too much would have to be looked at.
    std::optional<Index> look_round(const Point2& centre, Index face, bool large)
    {
        std::vector<Index>& room = room_;
        room.assign(1, face);
        ++look_;
        looked_in_.resize(t_.side_end() / 4 + 1, 0);
        looked_in_[face / 4] = look_;
        Index wall = Pane::none;
        for (std::size_t i = 0; i < room.size(); ++i) {
            if (!may_look(i)) return {};
            const Index first = first_side(t_, room[i]);
            for (const Index side : {first, Triangulation::next(first), Triangulation::previous(first)}) {
                if (t_.is_fixed(side)) {
                    if (is_splittable(side)) {
                        if (!sees_within_circle(side, centre)) continue;
                        halves_.emplace_back(t_.origin(side), t_.target(side));
                    } else if (!is_too_near_wall(side, centre, large)) {
                        continue;
                    }
                    wall = side;
                    continue;
                }
                const Index beyond = Triangulation::face(t_.twin(side));
                if (looked_in_[beyond / 4] != look_ && incircle(at(t_.origin(beyond)), at(t_.target(beyond)), at(t_.apex(beyond)), centre) > 0) {
                    looked_in_[beyond / 4] = look_;
                    room.push_back(beyond);
                }
            }
        }
        return wall;
    }

    /// On the way from the middle of a face to the centre of its circle, half as far from the wall; but not so near that the triangle on the wall comes out much smaller than
    /// it has to be.
    void put_before(Index wall, const Point2& start, const Point2& centre, Index face)
    {
        const double from = doubled_area(wall, start), to = doubled_area(wall, centre), left = std::max(from / 2, 0.9 * doubled_most_);
        const double part = from > left && from > to ? (from - left) / (from - to) : 0;
        if (part <= 0 || !put(start + std::min(part, 1.0) * (centre - start), face)) put(start, face);
    }

    Pane& pane_;
    Triangulation& t_;
    const Pane::Refinement& asked_;
    Progress* progress_;
    double sine_, doubled_most_;
    std::size_t most_;
    std::deque<std::pair<Index, Index>> edges_;
    std::deque<Corners> triangles_, walled_;
    std::vector<std::pair<Index, Index>> halves_;
    std::vector<Index> room_;               // of look_round
    std::vector<std::uint32_t> looked_in_;  // by face: the number of the last look that came there
    std::uint32_t look_ = 0;
    std::size_t looked_ = 0; // faces beyond the usual ones
    std::vector<Index> corner_of_; // by vertex: the sharp corner whose line was split there
    Pane::Refined result_;
};

Pane::Refined Pane::refine(const Refinement& refinement, Progress* progress)
{
    if (!(refinement.min_angle >= 0 && refinement.min_angle <= 30))
        refuse(Reason::angle_too_large, fmt::format("min_angle={}: expected 0 to 30 degrees", refinement.min_angle));
    if (refinement.max_area && !(*refinement.max_area > 0)) refuse(Reason::range, fmt::format("max_area={}: expected more than 0", *refinement.max_area));
    return edit([&] { return Refiner(*this, refinement, progress).run(); });
}

void Pane::unrefine()
{
    edit([&] {
        for (std::uint32_t i = 0; i < vertex_of_.size(); ++i) {
            const Index v = vertex_of_[i];
            if (v == none || !points_[v].refined || points_[v].locked) continue;
            bool ends_here = false;
            for (Index k = points_[v].first_knot; k != none; k = knots_[k].sibling)
                ends_here |= knots_[k].previous == none || knots_[k].next == none;
            if (ends_here) continue;
            do_remove(v, Through::join);
            settle();
        }
        return 0;
    });
}

void Pane::spread(int rounds)
{
    if (rounds < 1 || rounds > 100) refuse(Reason::range, fmt::format("rounds={}: expected 1 to 100", rounds));
    edit([&] {
        for (int round = 0; round < rounds; ++round)
            for (std::uint32_t i = 0; i < vertex_of_.size(); ++i) {
                const Index v = vertex_of_[i];
                if (v == none) continue;
                const PointData& point = points_[v];
                if (point.kind != PointKind::interior || point.locked || point.first_knot != none) continue;
                // The middle of the triangles around it, by area, stands for that of its Voronoi cell.
                Point2 sum(0);
                double weight = 0;
                const Index first = first_out(triangulation_, v);
                Index h = first;
                do {
                    const Point2 &p = triangulation_.position(v), &a = triangulation_.position(triangulation_.target(h));
                    const Point2& b = triangulation_.position(triangulation_.apex(h));
                    const double area = (a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x);
                    sum += area * ((a - p) + (b - p)) / 3.0;
                    weight += area;
                    h = triangulation_.turn(h);
                } while (h != first);
                const Point2 to = triangulation_.position(v) + sum / weight;
                if (!(std::abs(to.x) <= 1e150 && std::abs(to.y) <= 1e150)) continue;
                if (triangulation_.look_around(to, triangulation_.locate(to, first), state_.weld, v).vertex == none) triangulation_.move(v, to);
            }
        return 0;
    });
}

} // namespace druse
