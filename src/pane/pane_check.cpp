#include "pane/pane_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace druse {

namespace {

using Index = Pane::Index;
using Pair = std::pair<Index, Index>;

Pair ordered(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

class Checker {
public:
    Checker(const Pane& pane, double nozzle) : pane_(pane), t_(pane.triangulation()), nozzle_(nozzle) {}

    PaneCheck run()
    {
        found_.points = pane_.point_count();
        found_.boundary_points = pane_.boundary_count();
        found_.holes = pane_.hole_count();
        found_.segments = pane_.segment_count();
        faces();
        points();
        carried();
        counts();
        twins();
        return std::move(found_);
    }

private:
    void fault(std::string what)
    {
        if (found_.faults.size() < 20) found_.faults.push_back(std::move(what));
    }
    const Point2& at(Index v) const { return t_.position(v); }

    void faces()
    {
        used_.assign(t_.vertex_end(), false);
        for (Index f = 0; f < t_.side_end(); f += 4) {
            if (!t_.is_face(f)) continue;
            const Index a = t_.origin(f), b = t_.origin(f + 1), c = t_.origin(f + 2);
            if (orient(at(a), at(b), at(c)) <= 0) fault(fmt::format("face {} does not turn counter-clockwise", f));
            for (Index h = f; h < f + 3; ++h) side(h);
            if (!t_.is_inside(f)) continue;
            ++found_.triangles;
            const Point2 u = at(b) - at(a), w = at(c) - at(a);
            found_.area += (u.x * w.y - u.y * w.x) / 2;
            const double least = std::min({angle(a, b, c), angle(b, c, a), angle(c, a, b)});
            found_.smallest_angle = std::min(found_.smallest_angle, least);
            found_.thin_triangles += least < 10;
        }
        std::sort(segment_edges_.begin(), segment_edges_.end());
    }

    void side(Index h)
    {
        const Index o = t_.twin(h), v = t_.origin(h), w = t_.target(h);
        if (t_.origin(t_.out(v)) != v || !t_.is_face(t_.out(v))) fault(fmt::format("no side leaves vertex {}", v));
        if (t_.is_inside(h)) used_[v] = true;
        const std::uint32_t bits = t_.bits(h);
        if (o == Triangulation::none) {
            if (!t_.is_corner(v) || !t_.is_corner(w) || bits != Triangulation::hull_bit) fault(fmt::format("side {} has no twin", h));
            return;
        }
        if (t_.twin(o) != h || t_.origin(o) != w || t_.target(o) != v || t_.bits(o) != bits) fault(fmt::format("sides {} and {} are no pair", h, o));
        const bool loop = (bits & Triangulation::loop_bit) != 0;
        if (loop != (t_.is_inside(h) != t_.is_inside(o))) fault(fmt::format("side {} parts the inside from the outside, or should", h));
        if (bits == 0 && incircle_in_order(at(v), at(w), at(t_.apex(h)), at(t_.apex(o))) > 0) fault(fmt::format("side {} is not Delaunay", h));
        if (h > o) return;
        if ((bits & Triangulation::segment_bit) != 0) {
            segment_edges_.push_back(ordered(v, w));
            if (!t_.is_inside(h) && !t_.is_inside(o)) fault(fmt::format("the segment on side {} is outside", h));
        }
        loop_edges_ += loop;
        if (t_.is_inside(h) || t_.is_inside(o)) {
            ++found_.edges;
            found_.short_edges += glm::length(at(v) - at(w)) < nozzle_;
        }
    }

    double angle(Index a, Index b, Index c) const // at a
    {
        const Point2 u = at(b) - at(a), w = at(c) - at(a);
        return std::atan2(u.x * w.y - u.y * w.x, glm::dot(u, w)) * (180 / std::numbers::pi);
    }

    void points()
    {
        std::vector<Index> by_x;
        std::size_t boundary = 0;
        for (const PointId point : pane_.points()) {
            const Index v = pane_.vertex(point);
            by_x.push_back(v);
            boundary += pane_.kind(point) == PointKind::boundary;
            found_.locked += pane_.is_locked(point);
            if (pane_.id(v) != point) fault(fmt::format("point {} is not at its vertex", Index(point)));
            if (!used_[v]) fault(fmt::format("point {} is in no triangle", Index(point)));
        }
        if (by_x.size() != found_.points || boundary != found_.boundary_points) fault("points are miscounted");
        if (t_.vertex_count() != found_.points + 4) fault("there are vertices that are no points");
        std::sort(by_x.begin(), by_x.end(), [&](Index a, Index b) { return at(a).x < at(b).x; });
        for (std::size_t i = 0; i < by_x.size(); ++i)
            for (std::size_t k = i + 1; k < by_x.size() && at(by_x[k]).x - at(by_x[i]).x < pane_.weld(); ++k)
                if (glm::length(at(by_x[k]) - at(by_x[i])) < pane_.weld() * (1 - 1e-12))
                    fault(fmt::format("points {} and {} are nearer than weld", Index(pane_.id(by_x[i])), Index(pane_.id(by_x[k]))));
    }

    void carried()
    {
        std::vector<Pair> pieces;
        const auto segments = pane_.segments();
        if (segments.size() != found_.segments) fault("segments are miscounted");
        for (const SegmentId segment : segments) {
            const auto chain = pane_.chain(segment);
            if (chain.size() < 2) fault(fmt::format("segment {} has {} points", Index(segment), chain.size()));
            for (std::size_t i = 1; i < chain.size(); ++i) {
                if (chain[i] == chain[i - 1]) fault(fmt::format("segment {} has a piece without length", Index(segment)));
                pieces.push_back(ordered(pane_.vertex(chain[i - 1]), pane_.vertex(chain[i])));
            }
        }
        std::sort(pieces.begin(), pieces.end());
        pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
        if (pieces != segment_edges_) fault(fmt::format("{} pieces of segments, {} edges that carry one", pieces.size(), segment_edges_.size()));

        std::size_t along_loops = 0;
        double area = 0;
        for (std::size_t i = 0; i <= found_.holes; ++i) {
            const auto loop = pane_.loop(i);
            along_loops += loop.size();
            const Point2 base = pane_.position(loop[0]);
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const Point2 p = pane_.position(loop[k]) - base, q = pane_.position(loop[(k + 1) % loop.size()]) - base;
                area += (p.x * q.y - p.y * q.x) / 2;
                if (pane_.kind(loop[k]) != PointKind::boundary) fault(fmt::format("point {} of a loop is not of the boundary", Index(loop[k])));
            }
        }
        if (along_loops != loop_edges_ || along_loops != found_.boundary_points)
            fault(fmt::format("{} points along loops, {} edges of loops, {} points of the boundary", along_loops, loop_edges_, found_.boundary_points));
        if (!(std::abs(area - found_.area) <= 1e-9 * std::abs(area))) fault(fmt::format("area {} is not that of the loops, {}", found_.area, area));
    }

    void counts()
    {
        const auto I = std::ptrdiff_t(found_.points - found_.boundary_points), B = std::ptrdiff_t(found_.boundary_points);
        const auto h = std::ptrdiff_t(found_.holes), T = std::ptrdiff_t(found_.triangles), E = std::ptrdiff_t(found_.edges);
        if (T != 2 * I + B + 2 * h - 2 || E != 3 * I + 2 * B + 3 * h - 3 || I + B - E + T != 1 - h)
            fault(fmt::format("{} inner and {} boundary points with {} holes, but {} triangles and {} edges", I, B, h, T, E));
    }

    void twins()
    {
        double size = 0;
        for (const PointId point : pane_.points()) size = std::max({size, std::abs(pane_.position(point).x), std::abs(pane_.position(point).y)});
        pane_.for_twins([&](PointId point, PointId other, const Isometry& map) {
            if (glm::length(map(pane_.position(point)) - pane_.position(other)) > 1e-14 * size + pane_.weld())
                fault(fmt::format("point {} is not where its twin {} says", Index(other), Index(point)));
        });
    }

    const Pane& pane_;
    const Triangulation& t_;
    double nozzle_;
    PaneCheck found_;
    std::vector<bool> used_;
    std::vector<Pair> segment_edges_;
    std::size_t loop_edges_ = 0;
};

} // namespace

PaneCheck check(const Pane& pane, double nozzle) { return Checker(pane, nozzle).run(); }

} // namespace druse
