#include "io/coincident_edges.h"

#include "dlfl/measures.h"
#include "io/edge_splits.h"
#include "io/point_welder.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace druse {

CoincidentEdges::CoincidentEdges(const Mesh& mesh) : mesh_(mesh), place_(mesh.vertex_limit())
{
    MeshBuilder places;
    PointWelder welder(places);
    std::uint32_t count = 0;
    bool shared = false; // places
    for (const Vertex v : mesh.vertices()) {
        place_[v.index] = welder.vertex(mesh.position(v));
        if (place_[v.index] == count) ++count;
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
    std::vector<Met> met(count);
    struct Upon {
        std::uint32_t from, to;
        Edge edge;
    };
    std::vector<Upon> upon;
    for (const Vertex v : order) {
        if (mesh.is_point_sphere(v)) continue;
        const std::uint32_t from = place_[v.index];
        for (const Corner c : mesh.around(v)) {
            const std::uint32_t to = place_[mesh.target(c).index];
            if (to <= from) continue; // met from there, or of no length
            if (Met& m = met[to]; m.from != from) {
                m = {from, mesh.edge(c)};
            } else {
                upon.push_back({from, to, m.edge});
                upon.push_back({from, to, mesh.edge(c)});
            }
        }
    }
    for (Upon& u : upon) u.edge = without_lunes(u.edge);
    std::ranges::sort(upon, {}, [](const Upon& u) { return std::tuple(u.from, u.to, u.edge); });
    const auto same = [](const Upon& a, const Upon& b) { return a.edge == b.edge; };
    upon.erase(std::unique(upon.begin(), upon.end(), same), upon.end());
    // The first of those between two places stays whole; of the others, no two are divided at the same place.
    for (std::size_t i = 0, k = 0; i < upon.size(); ++i) {
        k = i > 0 && upon[i - 1].from == upon[i].from && upon[i - 1].to == upon[i].to ? k + 1 : 0;
        const bool alone = k == 0 && (i + 1 == upon.size() || upon[i + 1].from != upon[i].from || upon[i + 1].to != upon[i].to);
        if (alone) continue;
        const Edge e = upon[i].edge;
        upon_others_.insert(e.index);
        if (k == 0) continue;
        auto [a, b] = mesh.ends(e);
        if (place_[a.index] > place_[b.index]) std::swap(a, b);
        divided_.emplace(e.index, mesh.position(a) + (mesh.position(b) - mesh.position(a)) / double(k + 1));
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
    return std::ranges::any_of(mesh_.corners(f), [this](Corner c) {
        const Edge e = mesh_.edge(c);
        return e.valid() && upon_others_.contains(without_lunes(e).index);
    });
}

CoincidentEdges::Sides CoincidentEdges::between(Corner a, Corner b) const
{
    const std::uint64_t p = place_[mesh_.vertex(a).index], q = place_[mesh_.vertex(b).index];
    return std::min(p, q) << 32 | std::max(p, q);
}

/// A triangle with the points in its sides: a fan around one of them.
void CoincidentEdges::put(const std::array<Corner, 3>& t)
{
    ring_.clear();
    std::size_t hub = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        ring_.push_back(mesh_.position(t[i]));
        if (mesh_.next(t[i]) != t[(i + 1) % 3]) continue; // it runs across the face
        const auto point = divided_.find(without_lunes(mesh_.edge(t[i])).index);
        if (point == divided_.end()) continue;
        hub = ring_.size();
        ring_.push_back(point->second);
    }
    std::ranges::rotate(ring_, ring_.begin() + std::ptrdiff_t(hub));
    for (std::size_t i = 2; i < ring_.size(); ++i) triangles_.push_back({ring_[0], ring_[i - 1], ring_[i]});
}

const std::vector<std::array<Point, 3>>& CoincidentEdges::triangles(const std::vector<std::array<Corner, 3>>& cut)
{
    triangles_.clear();
    if (cut.size() == 2) { // a quad: of two upon each other the second one is cut along its other diagonal
        const bool from_first = cut[1][0] == cut[0][0];
        const std::array q{cut[0][0], cut[0][1], from_first ? cut[0][2] : cut[1][1], from_first ? cut[1][2] : cut[0][2]};
        const Sides mine = from_first ? between(q[0], q[2]) : between(q[1], q[3]), other = from_first ? between(q[1], q[3]) : between(q[0], q[2]);
        if (!taken_.insert(mine).second && taken_.insert(other).second) {
            put({q[0], q[1], from_first ? q[3] : q[2]});
            if (from_first) put({q[1], q[2], q[3]});
            else put({q[0], q[2], q[3]});
            return triangles_;
        }
    }
    for (const auto& t : cut) put(t);
    return triangles_;
}

void CoincidentEdges::note(OutputFiles& out) const
{
    if (divided_.empty()) return;
    out.note(fmt::format("{} coincident edge{} divided", divided_.size(), divided_.size() == 1 ? "" : "s"));
    note_thin_walls(facts(mesh_).zero_thickness_walls, out);
}

} // namespace druse
