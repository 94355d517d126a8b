#include "tile/carve.h"

#include "dlfl/errors.h"
#include "geom/predicates.h"
#include "geom/segments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace druse {

namespace {

using Number = std::uint32_t;
using Corners3 = std::array<Number, 3>;
using Ends = std::pair<Number, Number>;

constexpr Number no_number = Pane::none;
constexpr HeightSource unknown{{no_number, no_number, no_number}, {0, 0}};

bool is_known(const HeightSource& source) { return source.of[0] != no_number; }

HeightSource same_as(Number relief) { return {{relief, relief, relief}, {0, 0}}; }

/// At t from a to b, both of which are points of the relief.
HeightSource between(const HeightSource& a, const HeightSource& b, double t) { return {{a.of[0], b.of[0], a.of[0]}, {t, 0}}; }

Ends unordered(Number a, Number b) { return {std::min(a, b), std::max(a, b)}; }

double distance_to(const Point2& p, const Point2& a, const Point2& b) { return distance_to_segment(Point(p, 0.0), Point(a, 0.0), Point(b, 0.0)); }

/// How far p has come from a to b: 0 to 1.
double along(const Point2& p, const Point2& a, const Point2& b)
{
    const double square = glm::dot(b - a, b - a);
    return square > 0 ? std::clamp(glm::dot(p - a, b - a) / square, 0.0, 1.0) : 0.0;
}

/// Points that copies have in common: the first one found within reach of a place stands for all.
class CommonPoints {
public:
    explicit CommonPoints(double reach) : reach_(reach), cell_(8 * reach) {}

    Point2 at(const Point2& p)
    {
        const auto x = std::floor(p.x / cell_), y = std::floor(p.y / cell_);
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j)
                if (const auto found = cells_.find(key(x + i, y + j)); found != cells_.end())
                    for (const Number k : found->second)
                        if (glm::length(points_[k] - p) <= reach_) return points_[k];
        cells_[key(x, y)].push_back(static_cast<Number>(points_.size()));
        points_.push_back(p);
        return p;
    }

private:
    static std::uint64_t key(double x, double y)
    {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(x)) * 0x9e3779b97f4a7c15u ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(y));
    }

    double reach_, cell_;
    std::vector<Point2> points_;
    std::unordered_map<std::uint64_t, std::vector<Number>> cells_;
};

/// The polygon that cuts.
class Cutter {
public:
    explicit Cutter(std::span<const Point2> corners) : corners_(corners)
    {
        std::vector<FlatBox> boxes;
        for (Number k = 0; k < size(); ++k) {
            FlatBox& box = boxes.emplace_back();
            box.add(from(k));
            box.add(to(k));
        }
        sides_ = FlatGrid(boxes);
        for (FlatBox& box : boxes) box.min.x = box.max.x = 0; // by height only
        rows_ = FlatGrid(boxes);
    }

    Number size() const { return static_cast<Number>(corners_.size()); }
    const Point2& from(Number side) const { return corners_[side]; }
    const Point2& to(Number side) const { return corners_[side + 1 == corners_.size() ? 0 : side + 1]; }
    const FlatBox& bounds() const { return sides_.bounds(); }
    template <class F>
    void for_sides(const FlatBox& box, F&& f) const
    {
        sides_.for_each(box, f);
    }

    bool contains(const Point2& p) const
    {
        bool inside = false;
        rows_.for_each({{0, p.y}, {0, p.y}}, [&](Number k) {
            const Point2 &a = from(k), &b = to(k);
            if ((a.y > p.y) != (b.y > p.y) && (orient(a, b, p) > 0) == (a.y < b.y)) inside = !inside;
        });
        return inside;
    }

    /// Whether a side may come within reach of a triangle.
    bool comes_near(const Point2& a, const Point2& b, const Point2& c, double reach) const
    {
        FlatBox box;
        for (const Point2& p : {a, b, c}) box.add(p);
        bool near = false;
        for_sides(box.grown(reach), [&](Number k) { near = near || !(apart(a, b, from(k), to(k), reach) || apart(b, c, from(k), to(k), reach) || apart(c, a, from(k), to(k), reach)); });
        return near;
    }

private:
    /// Whether p and q both lie beyond the line from a to b, more than `reach` to its right.
    static bool apart(const Point2& a, const Point2& b, const Point2& p, const Point2& q, double reach)
    {
        const Point2 u = b - a, normal(u.y, -u.x);
        const double limit = reach * glm::length(u);
        return glm::dot(p - a, normal) > limit && glm::dot(q - a, normal) > limit;
    }

    std::span<const Point2> corners_;
    FlatGrid sides_, rows_;
};

class Carver {
public:
    Carver(const LayeredTile& tile, std::span<const Point2> polygon, const Isometry& carried, double weld)
        : tile_(tile), cutter_(polygon), carried_(carried), weld_(weld), common_(weld),
          shared_(weld > tile.weld() ? tile.point_count() : tile.outline_count())
    {
        for (const Point2& p : polygon) add(p, unknown);
    }

    Carving carve()
    {
        for (const TileCopy& copy : tile_.copies_in(cutter_.bounds().grown(2 * weld_), carried_)) load(copy);
        weld_to_cutter();
        cut();
        result_.field = result_.over(tile_.surface());
        return std::move(result_);
    }

private:
    Point2 at(Number point) const { return points_[point]; }

    /// Sorts the triangles of a copy: inside, far from the cutter's sides; near these; and the others, which do not count.
    void load(const TileCopy& copy)
    {
        const Isometry there = carried_ * tile_.motion(copy);
        const bool turned_over = reflects(there);
        const HeightField& surface = tile_.surface();
        places_.clear();
        for (const Point& p : surface.points) places_.push_back(there(Point2(p)));
        for (int i = 0; i < shared_; ++i) places_[static_cast<std::size_t>(i)] = common_.at(places_[static_cast<std::size_t>(i)]);
        numbers_.assign(places_.size(), no_number);
        const auto number = [&](Number i) {
            if (numbers_[i] != no_number) return numbers_[i];
            if (i >= static_cast<Number>(shared_)) return numbers_[i] = add(places_[i], same_as(i));
            // Another copy may have brought it already.
            const auto [known, is_new] = brought_.try_emplace(std::pair(places_[i].x, places_[i].y), no_number);
            if (is_new) known->second = add(places_[i], same_as(i));
            return numbers_[i] = known->second;
        };
        const FlatBox reach = cutter_.bounds().grown(2 * weld_);
        for (const Corners3& t : surface.triangles) {
            FlatBox box;
            for (const Number v : t) box.add(places_[v]);
            if (!box.meets(reach)) continue;
            std::array<Number, 3> v = t;
            if (turned_over) std::swap(v[1], v[2]);
            const Point2 &a = places_[v[0]], &b = places_[v[1]], &c = places_[v[2]];
            if (a == b || b == c || c == a) continue;
            const bool near = cutter_.comes_near(a, b, c, 2 * weld_);
            if (!near && !cutter_.contains((a + b + c) / 3.0)) continue;
            (near ? near_ : result_.field.triangles).push_back({number(v[0]), number(v[1]), number(v[2])});
        }
    }

    Number add(const Point2& p, const HeightSource& source)
    {
        points_.push_back(p);
        sources_.push_back(source);
        return static_cast<Number>(points_.size() - 1);
    }

    /// Moves points of the relief that lie within weld of the cutter on to it, and takes edges of the relief through its corners.
    void weld_to_cutter()
    {
        const Number corners = cutter_.size();
        stands_for_.resize(points_.size());
        for (Number v = 0; v < points_.size(); ++v) stands_for_[v] = v;
        on_side_.resize(corners);
        std::vector<Number> near;
        for (const Corners3& t : near_) near.insert(near.end(), t.begin(), t.end());
        std::sort(near.begin(), near.end());
        near.erase(std::unique(near.begin(), near.end()), near.end());
        for (const Number v : near) {
            const Point2 p = at(v);
            double nearest = weld_;
            Number corner = no_number, side = no_number;
            cutter_.for_sides(FlatBox{p, p}.grown(weld_), [&](Number k) {
                for (const Number c : {k, k + 1 == corners ? 0 : k + 1})
                    if (const double away = glm::length(p - at(c)); away <= nearest) {
                        nearest = away;
                        corner = c;
                    }
                if (distance_to(p, cutter_.from(k), cutter_.to(k)) <= weld_) side = k;
            });
            if (corner != no_number) {
                stands_for_[v] = corner;
                if (!is_known(sources_[corner])) sources_[corner] = sources_[v];
            } else if (side != no_number) {
                points_[v] = foot(p, cutter_.from(side), cutter_.to(side));
                on_side_[side].push_back(v);
            }
        }
        for (Number k = 0; k < corners; ++k)
            std::sort(on_side_[k].begin(), on_side_[k].end(), [&](Number a, Number b) {
                return along(at(a), cutter_.from(k), cutter_.to(k)) < along(at(b), cutter_.from(k), cutter_.to(k));
            });

        for (const Corners3& t : near_)
            for (std::size_t i = 0; i < 3; ++i) edges_.push_back(unordered(t[i], t[(i + 1) % 3]));
        std::sort(edges_.begin(), edges_.end());
        // Edges of one near triangle only have a triangle behind them that was sorted at once: inside, or outside.
        for (const Corners3& t : near_)
            for (std::size_t i = 0; i < 3; ++i) {
                const Number u = t[i], v = t[(i + 1) % 3];
                const auto [first, last] = std::equal_range(edges_.begin(), edges_.end(), unordered(u, v));
                if (last - first == 1 && cutter_.contains(0.5 * (at(u) + at(v)))) seams_.emplace_back(v, u);
            }
        edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    }

    /// Triangulates what lies along the cutter.
    void cut()
    {
        // The pane reaches beyond all that it gets; its points by number, and back.
        std::vector<Number> used;
        for (Number k = 0; k < cutter_.size(); ++k) used.push_back(k);
        for (const Corners3& t : near_)
            for (const Number v : t) used.push_back(stands_for_[v]);
        std::sort(used.begin(), used.end());
        used.erase(std::unique(used.begin(), used.end()), used.end());
        FlatBox all;
        std::vector<Point2> places;
        for (const Number v : used) {
            places.push_back(at(v));
            all.add(places.back());
        }
        const double room = 0.1 * std::max(all.max.x - all.min.x, all.max.y - all.min.y);
        const FlatBox box = all.grown(room);
        const std::array<Point2, 4> loop{box.min, Point2(box.max.x, box.min.y), box.max, Point2(box.min.x, box.max.y)};
        Pane pane(loop, {}, {.snap = 0.0, .weld = weld_});
        const std::vector<PointId> ids = pane.add_all(places);
        id_.assign(points_.size(), no_number);
        for (std::size_t i = 0; i < used.size(); ++i) id_[used[i]] = Number(ids[i]);

        make_pieces();
        std::vector<std::pair<PointId, PointId>> ends;
        for (const Piece& piece : pieces_) ends.emplace_back(PointId(piece.from), PointId(piece.to));
        const std::vector<SegmentId> segments = pane.constrain_all(ends);
        ASSERT(segments.size() == ends.size(), "each piece is a segment of its own");

        take_points(pane, segments);
        take_triangles(pane, segments);
    }

    /// A part of a side of the cutter or of an edge of the relief, by points of the pane.
    struct Piece {
        Number from = no_number, to = no_number;
        Ends of{no_number, no_number}; // an edge of the relief; none: a side
    };

    void make_pieces()
    {
        std::unordered_map<std::uint64_t, Number> known;
        const auto put = [&](Number from, Number to, const Ends& of) -> Number {
            const Number a = id_[from], b = id_[to];
            if (a == b) return no_number;
            const auto [ends_low, ends_high] = unordered(a, b);
            const auto [found, is_new] = known.try_emplace(std::uint64_t(ends_low) << 32 | ends_high, static_cast<Number>(pieces_.size()));
            if (is_new) pieces_.push_back({a, b, of});
            return found->second;
        };
        side_pieces_.resize(cutter_.size());
        for (Number k = 0; k < cutter_.size(); ++k) {
            Number last = k;
            const auto go = [&](Number v) {
                if (const Number piece = put(last, v, {no_number, no_number}); piece != no_number) side_pieces_[k].push_back(piece);
                last = v;
            };
            for (const Number v : on_side_[k]) go(v);
            go(k + 1 == cutter_.size() ? 0 : k + 1);
        }
        std::vector<std::pair<double, Number>> stops;
        for (const auto& [u, v] : edges_) {
            const Number a = stands_for_[u], b = stands_for_[v];
            if (a == b) continue;
            const Point2 from = at(a), to = at(b);
            FlatBox box;
            box.add(from);
            box.add(to);
            stops.clear();
            cutter_.for_sides(box.grown(weld_), [&](Number k) {
                for (const Number c : {k, k + 1 == cutter_.size() ? 0 : k + 1})
                    if (c != a && c != b && distance_to(at(c), from, to) <= weld_) stops.emplace_back(along(at(c), from, to), c);
            });
            std::sort(stops.begin(), stops.end());
            stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
            Number last = a;
            for (const auto& [t, c] : stops) {
                if (!is_known(sources_[c])) sources_[c] = between(sources_[a], sources_[b], t);
                put(last, c, {a, b});
                last = c;
            }
            put(last, b, {a, b});
        }
    }

    /// Numbers the points that the pane made where lines cross, each with the height of the edge of the relief that it is on.
    void take_points(const Pane& pane, std::span<const SegmentId> segments)
    {
        number_.assign(std::size_t(pane.next_point()), no_number);
        for (Number v = 0; v < id_.size(); ++v)
            if (id_[v] != no_number && number_[id_[v]] == no_number) number_[id_[v]] = v; // corners of the cutter first
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const auto [a, b] = pieces_[i].of;
            if (a == no_number) continue;
            for (const PointId id : pane.chain(segments[i])) {
                Number& known = number_[std::size_t(id)];
                if (known == no_number) known = add(pane.position(id), unknown);
                if (!is_known(sources_[known])) sources_[known] = between(sources_[a], sources_[b], along(at(known), at(a), at(b)));
            }
        }
        // What is left are corners of the cutter within a triangle of the relief.
        std::vector<FlatBox> boxes;
        for (const Corners3& t : near_) {
            FlatBox& box = boxes.emplace_back();
            for (const Number v : t) box.add(at(stands_for_[v]));
        }
        const FlatGrid grid(boxes);
        for (Number k = 0; k < cutter_.size(); ++k) {
            if (is_known(sources_[k])) continue;
            double deepest = -1e300;
            grid.for_each(FlatBox{at(k), at(k)}.grown(weld_), [&](Number i) {
                std::array<Number, 3> v{};
                for (std::size_t j = 0; j < 3; ++j) v[j] = stands_for_[near_[i][j]];
                const auto share = shares(at(k), at(v[0]), at(v[1]), at(v[2]));
                const double depth = std::min({share[0], share[1], share[2]});
                if (depth <= deepest) return;
                deepest = depth;
                sources_[k] = {{sources_[v[0]].of[0], sources_[v[1]].of[0], sources_[v[2]].of[0]}, {share[1], share[2]}};
            });
            ASSERT(deepest > -1e-3, "the copies cover every corner of the cutter");
        }
    }

    /// Takes the faces of the pane inside the cutter but for those where the relief was taken as it is.
    void take_triangles(const Pane& pane, std::span<const SegmentId> segments)
    {
        const Triangulation& t = pane.triangulation();
        enum : std::uint8_t { open, barred, dropped };
        std::vector<std::uint8_t> wall(t.side_end(), open), face(t.side_end() / 4, open);
        std::vector<Number> waiting;
        const auto bar = [&](Number h, bool drop_left) {
            ASSERT(h != no_number, "each piece of a side or a seam is an edge of the pane");
            wall[h] = barred;
            const Number twin = t.twin(h);
            if (twin != no_number) wall[twin] = barred;
            const Number left = drop_left ? h : twin;
            if (left != no_number) waiting.push_back(left);
        };
        // What lies to the right of the cutter, and to the left of a seam.
        result_.rim.resize(cutter_.size());
        for (Number k = 0; k < cutter_.size(); ++k) {
            auto& rim = result_.rim[k];
            rim.push_back(k);
            for (const Number piece : side_pieces_[k]) {
                auto chain = pane.chain(segments[piece]);
                if (number_[std::size_t(chain.front())] != rim.back()) std::reverse(chain.begin(), chain.end());
                for (std::size_t i = 1; i < chain.size(); ++i) {
                    bar(t.find_side(pane.vertex(chain[i - 1]), pane.vertex(chain[i])), false);
                    rim.push_back(number_[std::size_t(chain[i])]);
                }
            }
        }
        for (const auto& [u, v] : seams_) bar(t.find_side(pane.vertex(PointId(id_[stands_for_[u]])), pane.vertex(PointId(id_[stands_for_[v]]))), true);
        while (!waiting.empty()) {
            const Number first = Triangulation::face(waiting.back());
            waiting.pop_back();
            if (face[first / 4] == dropped) continue;
            face[first / 4] = dropped;
            for (Number h = first; h < first + 3; ++h)
                if (wall[h] == open && t.twin(h) != no_number && face[t.twin(h) / 4] != dropped) waiting.push_back(t.twin(h));
        }
        for (Number h = 0; h < t.side_end(); h += 4) {
            if (!t.is_face(h) || !t.is_inside(h) || face[h / 4] == dropped) continue;
            Corners3 corners{};
            for (Number i = 0; i < 3; ++i) corners[i] = number_[std::size_t(pane.id(t.origin(h + i)))];
            result_.field.triangles.push_back(corners);
        }
        compact();
    }

    /// Leaves out points that no triangle has.
    void compact()
    {
        std::vector<Number> to(points_.size(), no_number);
        auto& points = result_.field.points;
        const auto renumber = [&](Number& v) {
            if (to[v] == no_number) {
                to[v] = static_cast<Number>(points.size());
                ASSERT(is_known(sources_[v]), "each point of a carving lies on the relief");
                points.emplace_back(points_[v], 0.0);
                result_.sources.push_back(sources_[v]);
            }
            v = to[v];
        };
        for (Number k = 0; k < cutter_.size(); ++k) {
            Number v = k;
            renumber(v);
        }
        for (auto& chain : result_.rim)
            for (Number& v : chain) renumber(v);
        for (Corners3& triangle : result_.field.triangles)
            for (Number& v : triangle) renumber(v);
    }

    const LayeredTile& tile_;
    const Cutter cutter_;
    const Isometry carried_;
    const double weld_;
    CommonPoints common_;
    const int shared_; // the first so many points of a copy may be nearer than weld to others: of the outline, to those of other copies
    struct PairHash {
        std::size_t operator()(const std::pair<double, double>& p) const { return std::hash<double>()(p.first) * 31 + std::hash<double>()(p.second); }
    };
    std::unordered_map<std::pair<double, double>, Number, PairHash> brought_;

    std::vector<Point2> points_; // the cutter's corners first
    std::vector<HeightSource> sources_; // of their heights: those of points of the relief, and of corners that these were moved to, are the same as one of the relief
    std::vector<Corners3> near_;
    std::vector<Point2> places_;   // of the copy that is loaded
    std::vector<Number> numbers_;
    std::vector<Number> stands_for_;            // a corner of the cutter, or the point itself
    std::vector<std::vector<Number>> on_side_;  // points of the relief on each side of the cutter
    std::vector<Ends> edges_;                   // of near triangles
    std::vector<Ends> seams_;                   // with a triangle inside, far from the cutter, to the left
    std::vector<Piece> pieces_;
    std::vector<std::vector<Number>> side_pieces_;
    std::vector<Number> id_, number_;           // of points in the pane, and back
    Carving result_;
};

} // namespace

HeightField Carving::over(const HeightField& relief) const
{
    HeightField result = field;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const auto& [of, share] = sources[i];
        const double z = relief.points[of[0]].z;
        result.points[i].z = z + share[0] * (relief.points[of[1]].z - z) + share[1] * (relief.points[of[2]].z - z);
    }
    return result;
}

Carving carve(const LayeredTile& tile, std::span<const Point2> cutter, const Isometry& carried) { return carve(tile, cutter, carried, tile.weld()); }

Carving carve(const LayeredTile& tile, std::span<const Point2> cutter, const Isometry& carried, double weld)
{
    return Carver(tile, cutter, carried, std::max(weld, tile.weld())).carve();
}

} // namespace druse
