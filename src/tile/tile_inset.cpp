#include "tile/tile_inset.h"

#include "pane/pane.h"
#include "tile/flat_grid.h"
#include "tile/tile_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace druse {

namespace {

constexpr double farthest = 4; // that a corner moves, in units of what its sides move

Point2 to_left(const Point2& from, const Point2& to) { return unit(Vector(-(to.y - from.y), to.x - from.x, 0)); }

/// Where the corners go; a side may turn round.
std::vector<Point2> moved_corners(std::span<const Point2> polygon, double by)
{
    std::vector<Point2> result;
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Point2 before = to_left(polygon[(i + n - 1) % n], polygon[i]), after = to_left(polygon[i], polygon[(i + 1) % n]);
        const Point2 sum = before + after;
        const double square = glm::dot(sum, sum); // 4 cos² of half the turn
        if (square > 4 / (farthest * farthest)) {
            result.push_back(polygon[i] + (2 * by / square) * sum);
        } else {
            // A needle: cut off in front.
            result.push_back(polygon[i] + by * before);
            result.push_back(polygon[i] + by * after);
        }
    }
    return result;
}

/// The sides of the moved polygon as they divide the plane.
class Windings {
public:
    using Index = Triangulation::Index;

    Windings(std::span<const Point2> corners, double weld) : pane_(around(corners), {}, {.snap = 0.0, .weld = weld})
    {
        const std::vector<PointId> ids = pane_.add_all(corners);
        std::vector<std::pair<PointId, PointId>> sides;
        for (std::size_t i = 0; i < ids.size(); ++i)
            if (const auto& [a, b] = std::pair(ids[i], ids[(i + 1) % ids.size()]); a != b) sides.emplace_back(a, b);
        // How often each edge is run along, by its side.
        const Triangulation& t = pane_.triangulation();
        std::map<std::pair<PointId, PointId>, int> runs;
        for (const auto& [a, b] : sides) runs[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        std::vector<std::pair<PointId, PointId>> once;
        std::vector<int> times;
        for (const auto& [ends, count] : runs) {
            once.push_back(ends);
            times.push_back(count);
        }
        const auto segments = pane_.constrain_all(once);
        ASSERT(segments.size() == once.size(), "each side is a segment of its own");
        runs_.assign(t.side_end(), 0);
        for (std::size_t i = 0; i < once.size(); ++i) {
            const auto chain = pane_.chain(segments[i]);
            for (std::size_t k = 1; k < chain.size(); ++k) {
                const Index h = t.find_side(pane_.vertex(chain[k - 1]), pane_.vertex(chain[k]));
                const int along = chain.front() == once[i].first ? times[i] : -times[i];
                runs_[h] += along;
                runs_[t.twin(h)] -= along;
            }
        }
        flood();
    }

    /// The boundary of the largest piece that is gone round once or more often and lies inside a polygon, `by` from its sides as far as welding leaves them:
    /// sides that have passed each other may go round a piece that does not.
    Inset largest(std::span<const Point2> polygon, double by, double weld) const
    {
        const Triangulation& t = pane_.triangulation();
        std::vector<Index> piece(winding_.size(), Triangulation::none), waiting;
        double best_area = 0, all = 0; // twice as large
        Index best = Triangulation::none;
        for (Index first = 0; first < t.side_end(); first += 4) {
            if (!t.is_face(first) || winding_[first / 4] < 1 || piece[first / 4] != Triangulation::none) continue;
            const Point2 middle = (t.position(t.origin(first)) + t.position(t.origin(first + 1)) + t.position(t.origin(first + 2))) / 3.0;
            const bool counts = contains(polygon, middle) && nearest_side(polygon, middle).distance >= by * (1 - 1e-9) - weld;
            double area = 0;
            waiting.assign(1, first);
            piece[first / 4] = first;
            while (!waiting.empty()) {
                const Index face = waiting.back();
                waiting.pop_back();
                const std::array<Point2, 3> corners{t.position(t.origin(face)), t.position(t.origin(face + 1)), t.position(t.origin(face + 2))};
                area += twice_area(corners);
                for (Index h = face; h < face + 3; ++h) {
                    const Index next = Triangulation::face(t.twin(h));
                    if (winding_[next / 4] < 1 || piece[next / 4] != Triangulation::none) continue;
                    piece[next / 4] = first;
                    waiting.push_back(next);
                }
            }
            if (!counts) continue;
            all += area;
            if (area > best_area) {
                best_area = area;
                best = first;
            }
        }
        if (best == Triangulation::none) return {};
        // Round the piece, from its first point by x and y.
        const auto is_rim = [&](Index h) { return piece[Triangulation::face(h) / 4] == best && piece[Triangulation::face(t.twin(h)) / 4] != best; };
        Index start = Triangulation::none;
        for (Index h = 0; h < t.side_end(); ++h)
            if ((h & 3) != 3 && t.is_face(Triangulation::face(h)) && t.is_inside(Triangulation::face(h)) && is_rim(h) &&
                (start == Triangulation::none || is_before(t.position(t.origin(h)), t.position(t.origin(start)))))
                start = h;
        std::vector<Point2> rim;
        Index h = start;
        do {
            rim.push_back(t.position(t.origin(h)));
            h = Triangulation::next(h);
            while (!is_rim(h)) h = Triangulation::next(t.twin(h));
        } while (h != start);
        return {std::move(rim), 0.5 * (all - best_area)};
    }

private:
    static std::array<Point2, 4> around(std::span<const Point2> corners)
    {
        FlatBox box;
        for (const Point2& p : corners) box.add(p);
        box = box.grown(0.1 * std::max(box.max.x - box.min.x, box.max.y - box.min.y));
        return {box.min, Point2(box.max.x, box.min.y), box.max, Point2(box.min.x, box.max.y)};
    }

    /// From outside, where nothing goes round, inwards.
    void flood()
    {
        const Triangulation& t = pane_.triangulation();
        winding_.assign(t.side_end() / 4, 0);
        std::vector<bool> seen(winding_.size());
        std::vector<Index> waiting;
        for (Index h = 0; h < t.side_end(); h += 4)
            if (t.is_face(h) && !t.is_inside(h)) {
                seen[h / 4] = true;
                waiting.push_back(h);
            }
        while (!waiting.empty()) {
            const Index face = waiting.back();
            waiting.pop_back();
            for (Index h = face; h < face + 3; ++h) {
                const Index other = t.twin(h);
                if (other == Triangulation::none || seen[other / 4]) continue;
                seen[other / 4] = true;
                winding_[other / 4] = winding_[face / 4] + runs_[other];
                waiting.push_back(Triangulation::face(other));
            }
        }
    }

    Pane pane_;
    std::vector<int> runs_;    // of sides: how often the polygon runs along them
    std::vector<int> winding_; // of faces: how often it goes round
};

} // namespace

Inset inset(std::span<const Point2> polygon, double by, double weld)
{
    const std::vector<Point2> corners = moved_corners(polygon, by);
    FlatBox box;
    for (const Point2& p : corners) box.add(p);
    if (std::max(box.max.x - box.min.x, box.max.y - box.min.y) < 8 * weld) return {};
    return Windings(corners, weld).largest(polygon, by, weld);
}

} // namespace druse
