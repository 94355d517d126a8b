#include "graph/graph_facts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

namespace druse {

namespace {

/// The directions in which edges leave each vertex, vertex after vertex.
class Stars {
public:
    explicit Stars(const Graph& graph) : first_(graph.vertices.size() + 1, 0)
    {
        for (const auto& [a, b] : graph.edges) {
            ++first_[a + 1];
            ++first_[b + 1];
        }
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        directions_.resize(first_.back());
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        for (const auto& [a, b] : graph.edges) {
            const Vector along = unit(graph.vertices[b] - graph.vertices[a]);
            directions_[next[a]++] = along;
            directions_[next[b]++] = -along;
        }
    }

    int valence(std::size_t v) const { return static_cast<int>(first_[v + 1] - first_[v]); }

    /// Makes `chord` the distance of the two nearest tips of unit vectors at `v`, if it is less.
    void shorten(std::size_t v, double& chord)
    {
        const auto begin = directions_.begin() + static_cast<std::ptrdiff_t>(first_[v]), end = directions_.begin() + static_cast<std::ptrdiff_t>(first_[v + 1]);
        // Sorted along a line that no figure is likely to be square to, only few lie near enough to be looked at.
        const Vector line = unit(Vector(1.0, std::numbers::sqrt2, std::numbers::e));
        const auto place = [&line](const Vector& d) { return glm::dot(d, line); };
        std::sort(begin, end, [&place](const Vector& a, const Vector& b) { return place(a) < place(b); });
        for (auto a = begin; a != end; ++a)
            for (auto b = a + 1; b != end && chord > 0.0 && place(*b) - place(*a) < chord; ++b) chord = std::min(chord, glm::distance(*a, *b));
    }

private:
    std::vector<std::size_t> first_;
    std::vector<Vector> directions_;
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

    double chord = std::numeric_limits<double>::infinity();
    Stars stars(graph);
    for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
        ++r.valences[stars.valence(v)];
        stars.shorten(v, chord);
    }
    if (chord <= 2.0) r.smallest_angle = 2.0 * std::asin(0.5 * chord) * (180.0 / std::numbers::pi);
    else if (std::isfinite(chord)) r.smallest_angle = 180.0;

    if (graph.edges.empty()) return r;
    r.shortest_edge = std::numeric_limits<double>::infinity();
    double sum = 0.0;
    for (const auto& [a, b] : graph.edges) {
        const double length = glm::distance(graph.vertices[a], graph.vertices[b]);
        r.shortest_edge = std::min(r.shortest_edge, length);
        r.longest_edge = std::max(r.longest_edge, length);
        sum += length;
    }
    r.mean_edge = sum / r.edges;
    return r;
}

} // namespace druse
