#include "io/coincident_edges.h"

#include "dlfl/measures.h"
#include "io/edge_splits.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace druse {

CoincidentEdges::CoincidentEdges(const Mesh& mesh) : mesh_(mesh), place_(mesh.vertex_limit())
{
    bool shared = false; // places
    for (const Vertex v : mesh.vertices()) {
        place_[v.index] = welder_.vertex(mesh.position(v));
        if (place_[v.index] == place_count_) ++place_count_;
        else shared = true;
    }
    // Vertices place by place, so that edges between two places come up together.
    std::vector<Vertex> order;
    order.reserve(mesh.vertex_count());
    for (const Vertex v : mesh.vertices()) order.push_back(v);
    if (shared) std::ranges::stable_sort(order, {}, [this](Vertex v) { return place_[v.index]; });

    struct Met {
        std::uint32_t from = Vertex::none; // the place that was left last for this one
        Edge edge;                         // by which edge, first
    };
    std::vector<Met> met(place_count_);
    struct Upon {
        std::uint32_t from, to;
        Edge edge;
    };
    std::vector<Upon> upon;
    std::vector<Vertex> folds; // with two edges: the faces there have both of them
    for (const Vertex v : order) {
        if (mesh.is_point_sphere(v)) continue;
        const std::uint32_t from = place_[v.index];
        int valence = 0;
        for (const Corner c : mesh.around(v)) {
            ++valence;
            const std::uint32_t to = place_[mesh.target(c).index];
            if (to <= from) continue; // met from there, or of no length
            if (Met& m = met[to]; m.from != from) {
                m = {from, mesh.edge(c)};
            } else {
                upon.push_back({from, to, m.edge});
                upon.push_back({from, to, mesh.edge(c)});
            }
        }
        if (valence == 2) folds.push_back(v);
    }
    for (Upon& u : upon) u.edge = without_lunes(u.edge);
    std::ranges::sort(upon, {}, [](const Upon& u) { return std::tuple(u.from, u.to, u.edge); });
    const auto same = [](const Upon& a, const Upon& b) { return a.edge == b.edge; };
    upon.erase(std::unique(upon.begin(), upon.end(), same), upon.end());
    // The first of those between two places stays whole.
    std::unordered_set<std::uint32_t> upon_others; // edges, also those that are not divided
    for (std::size_t i = 0, k = 0; i < upon.size(); ++i) {
        k = i > 0 && upon[i - 1].from == upon[i].from && upon[i - 1].to == upon[i].to ? k + 1 : 0;
        const bool alone = k == 0 && (i + 1 == upon.size() || upon[i + 1].from != upon[i].from || upon[i + 1].to != upon[i].to);
        if (alone) continue;
        const Edge e = upon[i].edge;
        upon_others.insert(e.index);
        if (k == 0) continue;
        auto [a, b] = mesh.ends(e);
        if (place_[a.index] > place_[b.index]) std::swap(a, b);
        if (const auto point = point_between(mesh.position(a), mesh.position(b), int(std::min<std::size_t>(k, 1000)) + 1)) divided_.emplace(e.index, *point);
        else ++left_;
    }
    if (!upon_others.empty() || !folds.empty()) mark_near(upon_others, folds);
}

void CoincidentEdges::mark_near(const std::unordered_set<std::uint32_t>& upon_others, const std::vector<Vertex>& folds)
{
    near_.resize(place_count_, false);
    const auto mark = [this](Face f) {
        for (const Corner c : mesh_.corners(f)) near_[place_[mesh_.vertex(c).index]] = true;
    };
    for (const Vertex v : folds)
        for (const Corner c : mesh_.around(v)) mark(mesh_.face(c));
    if (!upon_others.empty())
        for (const Face f : mesh_.faces())
            if (std::ranges::any_of(mesh_.corners(f), [&](Corner c) { return mesh_.edge(c).valid() && upon_others.contains(without_lunes(mesh_.edge(c)).index); }))
                mark(f);
    for (const Edge e : mesh_.edges()) {
        const auto [v, w] = mesh_.ends(e);
        const std::uint32_t p = place_[v.index], q = place_[w.index];
        if (near_[p] && near_[q]) taken_.insert(between(p, q));
    }
}

/// Of the edges that two-sided faces in a row part, the lowest.
Edge CoincidentEdges::without_lunes(Edge e) const
{
    Edge lowest = e;
    for (const int side : {0, 1}) {
        Corner c = mesh_.corner(e, side);
        while (mesh_.next(mesh_.next(c)) == c && mesh_.next(c) != c) {
            c = mesh_.opposite(mesh_.next(c));
            if (mesh_.edge(c) == e) break; // all round
            lowest = std::min(lowest, mesh_.edge(c));
        }
    }
    return lowest;
}

bool CoincidentEdges::concern(Face f) const
{
    if (empty()) return false;
    int near = 0, sides = 0;
    bool divided = false;
    for (const Corner c : mesh_.corners(f)) {
        ++sides;
        if (!near_[place_[mesh_.vertex(c).index]]) continue;
        ++near;
        const Edge e = mesh_.edge(c);
        divided = divided || (e.valid() && divided_.contains(without_lunes(e).index));
    }
    return divided || (near > 1 && sides > 3);
}

/// A place that nothing is at yet.
std::optional<CoincidentEdges::Place> CoincidentEdges::new_place(const Point& p)
{
    const std::uint32_t number = welder_.vertex(p);
    if (number < place_count_) return std::nullopt;
    ++place_count_;
    return Place{p, number};
}

/// A point on the way from a to b, at 1 / first of it or nearer to a.
std::optional<CoincidentEdges::Place> CoincidentEdges::point_between(const Point& a, const Point& b, int first)
{
    constexpr int most = 1000; // tries
    for (int k = first; k < first + most; ++k)
        if (const auto found = new_place(a + (b - a) / double(k))) return found;
    return std::nullopt;
}

/// The point in a side of a triangle, if it needs one.
std::optional<CoincidentEdges::Place> CoincidentEdges::point_in_side(Corner from, Corner to)
{
    if (mesh_.next(from) == to) {
        const auto point = divided_.find(without_lunes(mesh_.edge(from)).index);
        return point == divided_.end() ? std::nullopt : std::optional(point->second);
    }
    if (to < from) std::swap(from, to); // the triangle across the side asks from the other end
    const auto [it, is_new] = across_.try_emplace(std::uint64_t(from.index) << 32 | to.index);
    if (!is_new) return it->second;
    const Place a = place(from), b = place(to);
    if (near_[a.number] && near_[b.number] && a.number != b.number && !taken_.insert(between(a.number, b.number)).second)
        it->second = a.number < b.number ? point_between(a.at, b.at, 2) : point_between(b.at, a.at, 2);
    return it->second;
}

/// True if no side of another triangle lies where those would be that run from a point of the ring to all but its neighbours.
bool CoincidentEdges::is_free_around(std::size_t hub) const
{
    const std::size_t n = ring_.size();
    for (std::size_t i = 2; i + 1 < n; ++i)
        if (taken_.contains(between(ring_[hub].number, ring_[(hub + i) % n].number))) return false;
    return true;
}

/// A triangle with the points in its sides: a fan around one of them, or where that would lie upon another, around a point inside.
void CoincidentEdges::put(const std::array<Corner, 3>& t)
{
    ring_.clear();
    std::array<std::size_t, 3> hubs{};
    std::size_t points = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        ring_.push_back(place(t[i]));
        if (const auto point = point_in_side(t[i], t[(i + 1) % 3])) {
            hubs[points++] = ring_.size();
            ring_.push_back(*point);
        }
    }
    const std::size_t n = ring_.size();
    const auto fan_around = [&](const Point& hub, std::size_t first, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) triangles_.push_back({hub, ring_[(first + i) % n].at, ring_[(first + i + 1) % n].at});
    };
    std::size_t hub = points > 0 ? hubs[points - 1] : 0;
    if (points > 0 && !is_free_around(hub)) {
        const auto other = std::find_if(hubs.begin(), hubs.begin() + std::ptrdiff_t(points), [this](std::size_t k) { return is_free_around(k); });
        if (other != hubs.begin() + std::ptrdiff_t(points)) {
            hub = *other;
        } else {
            const Point a = mesh_.position(t[0]), middle = (a + mesh_.position(t[1]) + mesh_.position(t[2])) / 3.0;
            if (const auto inside = point_between(a, middle, 1)) {
                fan_around(inside->at, 0, n);
                return;
            }
        }
    }
    for (std::size_t i = 2; points > 0 && i + 1 < n; ++i) taken_.insert(between(ring_[hub].number, ring_[(hub + i) % n].number));
    fan_around(ring_[hub].at, hub + 1, n - 2);
}

const std::vector<std::array<Point, 3>>& CoincidentEdges::triangles(const std::vector<std::array<Corner, 3>>& cut)
{
    triangles_.clear();
    across_.clear();
    for (const auto& t : cut) put(t);
    return triangles_;
}

void CoincidentEdges::note(OutputFiles& out) const
{
    if (!divided_.empty()) out.note(fmt::format("{} coincident edge{} divided", divided_.size(), divided_.size() == 1 ? "" : "s"));
    if (left_ > 0)
        out.note(fmt::format("{} coincident edge{} too short to be divided in single precision", left_, left_ == 1 ? " is" : "s are"));
    if (!divided_.empty() || left_ > 0) note_thin_walls(facts(mesh_).zero_thickness_walls, out);
}

} // namespace druse
