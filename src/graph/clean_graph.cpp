#include "graph/clean_graph.h"

#include "dlfl/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <numeric>

namespace druse {

namespace {

constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

void check_coordinates(const Graph& graph)
{
    for (std::size_t v = 0; v < graph.vertices.size(); ++v)
        if (!is_in_reach(graph.vertices[v])) throw CommandError(fmt::format("vertex {} of the graph lies beyond {}", v, largest_coordinate));
    for (std::size_t e = 0; e < graph.edges.size(); ++e)
        for (const std::uint32_t v : graph.edges[e])
            if (v >= graph.vertices.size())
                throw CommandError(fmt::format("edge {} of the graph names vertex {}, there are {}", e, v, graph.vertices.size()));
}

/// Keeps the first of the edges between the same vertices. @return how many others there were
std::uint32_t drop_repeated(CleanGraph& clean)
{
    Graph& graph = clean.graph;
    std::vector<std::uint32_t> order(graph.edges.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto ends = [&graph](std::uint32_t e) { return std::minmax(graph.edges[e][0], graph.edges[e][1]); };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return ends(a) < ends(b) || (ends(a) == ends(b) && a < b); });
    std::vector<bool> repeats(graph.edges.size(), false);
    std::uint32_t count = 0;
    for (std::size_t i = 1; i < order.size(); ++i)
        if (ends(order[i]) == ends(order[i - 1])) {
            repeats[order[i]] = true;
            ++count;
        }
    if (count == 0) return 0;
    std::size_t kept = 0;
    for (std::size_t e = 0; e < repeats.size(); ++e) {
        if (repeats[e]) continue;
        graph.edges[kept] = graph.edges[e];
        if (!graph.normals.empty()) graph.normals[kept] = graph.normals[e];
        clean.edge_ids[kept++] = clean.edge_ids[e];
    }
    graph.edges.resize(kept);
    if (!graph.normals.empty()) graph.normals.resize(kept);
    clean.edge_ids.resize(kept);
    return count;
}

/// What vertices with an edge will be called, and how many there are.
std::uint32_t number_used(const Graph& graph, std::vector<std::uint32_t>& number)
{
    number.assign(graph.vertices.size(), unused);
    for (const auto& edge : graph.edges)
        for (const std::uint32_t v : edge) number[v] = 0;
    std::uint32_t count = 0;
    for (std::uint32_t& n : number)
        if (n == 0) n = count++;
    return count;
}

} // namespace

std::vector<std::string> GraphRepairs::notes() const
{
    std::vector<std::string> lines;
    const auto note = [&lines](std::uint32_t count, const char* one, const char* many) {
        if (count > 0) lines.push_back(fmt::format("{} {}", count, count == 1 ? one : many));
    };
    note(repeated, "edge was there twice: kept once", "edges were there already: kept once");
    note(welded, "vertex was welded to another one at its place", "vertices were welded to others at their place");
    note(isolated, "vertex has no edge: left out", "vertices have no edge: left out");
    return lines;
}

CleanGraph cleaned(const Graph& graph, double weld, GraphRepairs& repairs)
{
    check_coordinates(graph);
    if (graph.edges.empty()) throw CommandError("the graph has no edges");
    CleanGraph clean{graph, std::vector<std::uint32_t>(graph.vertices.size()), std::vector<std::uint32_t>(graph.edges.size())};
    std::iota(clean.vertex_ids.begin(), clean.vertex_ids.end(), 0u);
    std::iota(clean.edge_ids.begin(), clean.edge_ids.end(), 0u);
    repairs.repeated += drop_repeated(clean);

    const std::vector<std::uint32_t> first = first_within_reach(graph.vertices, weld);
    std::uint32_t welded = 0;
    for (std::uint32_t v = 0; v < first.size(); ++v)
        if (first[v] != v) ++welded;
    if (welded > 0) {
        for (auto& edge : clean.graph.edges)
            for (std::uint32_t& v : edge) v = first[v];
        repairs.repeated += drop_repeated(clean);
        repairs.welded += welded;
    }
    for (std::size_t e = 0; e < clean.graph.edges.size(); ++e)
        if (const auto& [a, b] = clean.graph.edges[e]; a == b)
            throw CommandError(fmt::format("edge {} of the graph has no length: it ends at vertex {} where it begins", clean.edge_ids[e], a));

    std::vector<std::uint32_t> number;
    number_used(clean.graph, number);
    for (std::uint32_t v = 0; v < number.size(); ++v)
        if (number[v] != unused) clean.vertex_ids[number[v]] = v;
    const std::uint32_t dropped = drop_isolated(clean.graph);
    repairs.isolated += dropped - welded;
    clean.vertex_ids.resize(clean.graph.vertices.size());
    return clean;
}

std::vector<std::uint32_t> first_within_reach(const std::vector<Point>& points, double reach)
{
    std::vector<std::uint32_t> first(points.size()), order(points.size());
    std::iota(first.begin(), first.end(), 0u);
    order = first;
    const auto root = [&first](std::uint32_t v) {
        while (first[v] != v) v = first[v] = first[first[v]];
        return v;
    };
    // Sorted along a line that no figure is likely to be square to, only few lie near enough to be looked at.
    const Vector line = unit(Vector(1.0, std::numbers::sqrt2, std::numbers::e));
    std::vector<double> place(points.size());
    Box box;
    for (std::size_t v = 0; v < points.size(); ++v) {
        place[v] = glm::dot(points[v], line);
        box.add(points[v]);
    }
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return place[a] < place[b] || (place[a] == place[b] && a < b); });
    // Equal points have equal places; others may be off by the rounding of these.
    const double farthest = reach > 0 ? reach + 1e-15 * (box.diagonal() + glm::length(box.center())) : 0.0;
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size() && place[order[j]] - place[order[i]] <= farthest; ++j) {
            const Point &p = points[order[i]], &q = points[order[j]];
            if (reach > 0 ? !(glm::distance(p, q) <= reach) : p != q) continue;
            const std::uint32_t a = root(order[i]), b = root(order[j]);
            first[std::max(a, b)] = std::min(a, b);
        }
    for (std::uint32_t v = 0; v < first.size(); ++v) first[v] = root(v);
    return first;
}

std::uint32_t drop_isolated(Graph& graph)
{
    std::vector<std::uint32_t> number;
    const std::uint32_t used = number_used(graph, number), dropped = static_cast<std::uint32_t>(number.size()) - used;
    if (dropped == 0) return 0;
    for (std::size_t v = 0; v < number.size(); ++v)
        if (number[v] != unused) graph.vertices[number[v]] = graph.vertices[v];
    graph.vertices.resize(used);
    for (auto& edge : graph.edges)
        for (std::uint32_t& v : edge) v = number[v];
    return dropped;
}

} // namespace druse
