#include "graph/graph_facts.h"

#include "geom/angle.h"
#include "geom/sort_unique.h"
#include "graph/incidence.h"
#include "graph/nearest_directions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace druse {

namespace {

/// The least angle at each vertex. An edge that is there twice is one, and one without a length has no direction.
class SmallestAngle {
public:
    explicit SmallestAngle(const Graph& graph) : graph_(graph), incidence_(graph) {}

    int valence(std::size_t v) const { return static_cast<int>(incidence_.valence(v)); }

    /// Makes `least` the least angle of two edges at `v`, if it is less; radians.
    void lower(std::size_t v, double& least)
    {
        const Point& here = graph_.vertices[v];
        steps_.clear();
        for (const std::uint32_t end : incidence_.ends(v)) {
            const Vector d = graph_.vertices[graph_.edges[end / 2][1 - end % 2]] - here;
            if (d != Vector(0.0)) steps_.push_back({d.x, d.y, d.z});
        }
        sort_unique(steps_);
        directions_.clear();
        for (const auto& [x, y, z] : steps_) directions_.push_back(direction({x, y, z}));
        if (directions_.size() < 2) return;
        finder_.find(directions_);
        for (std::uint32_t i = 0; i < directions_.size(); ++i) least = std::min(least, angle_between(directions_[i], directions_[finder_[i]]));
    }

private:
    const Graph& graph_;
    Incidence incidence_;
    std::vector<std::array<double, 3>> steps_;
    std::vector<Vector> directions_;
    NearestDirections finder_;
};

std::uint32_t count_components(const Graph& graph)
{
    std::vector<std::uint32_t> parent(graph.vertices.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto find = [&parent](std::uint32_t v) {
        while (parent[v] != v) v = parent[v] = parent[parent[v]];
        return v;
    };
    auto components = static_cast<std::uint32_t>(graph.vertices.size());
    for (const auto& [a, b] : graph.edges) {
        const std::uint32_t x = find(a), y = find(b);
        if (x == y) continue;
        parent[std::max(x, y)] = std::min(x, y);
        --components;
    }
    return components;
}

} // namespace

GraphFacts facts(const Graph& graph)
{
    GraphFacts r;
    r.vertices = static_cast<std::uint32_t>(graph.vertices.size());
    r.edges = static_cast<std::uint32_t>(graph.edges.size());
    r.components = count_components(graph);
    r.cycle_rank = std::int64_t(r.edges) - r.vertices + r.components;
    for (const Point& p : graph.vertices) r.bounds.add(p);

    double least = std::numeric_limits<double>::infinity();
    SmallestAngle angle(graph);
    for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
        ++r.valences[angle.valence(v)];
        angle.lower(v, least);
    }
    if (std::isfinite(least)) r.smallest_angle = degrees(least);

    if (graph.edges.empty()) return r;
    r.shortest_edge = std::numeric_limits<double>::infinity();
    double sum = 0.0;
    for (const auto& [a, b] : graph.edges) {
        const Vector d = graph.vertices[b] - graph.vertices[a];
        const double length = std::hypot(d.x, d.y, d.z); // also where a square is too small for a double
        r.shortest_edge = std::min(r.shortest_edge, length);
        r.longest_edge = std::max(r.longest_edge, length);
        sum += length;
    }
    r.mean_edge = sum / r.edges;
    return r;
}

} // namespace druse
