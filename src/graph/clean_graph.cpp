#include "graph/clean_graph.h"

#include "dlfl/errors.h"
#include "graph/weld.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
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

/// Leaves out vertices without an edge, and tells which were kept.
std::vector<std::uint32_t> keep_used(Graph& graph)
{
    std::vector<std::uint32_t> number(graph.vertices.size(), unused), kept;
    for (const auto& edge : graph.edges)
        for (const std::uint32_t v : edge) number[v] = 0;
    for (std::uint32_t v = 0; v < number.size(); ++v) {
        if (number[v] == unused) continue;
        number[v] = static_cast<std::uint32_t>(kept.size());
        graph.vertices[kept.size()] = graph.vertices[v];
        kept.push_back(v);
    }
    graph.vertices.resize(kept.size());
    for (auto& edge : graph.edges)
        for (std::uint32_t& v : edge) v = number[v];
    return kept;
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

std::string CleanGraph::vertex_name(std::uint32_t v) const
{
    if (vertex_ids[v] < given) return fmt::format("vertex {}", vertex_ids[v]);
    const Point& p = graph.vertices[v];
    return fmt::format("the crossing at {:.6g},{:.6g},{:.6g}", p.x, p.y, p.z);
}

std::string CleanGraph::edge_name(std::uint32_t e, std::uint32_t from) const { return fmt::format("({} {})", edge_ends[e][from], edge_ends[e][1 - from]); }

CleanGraph cleaned(const Graph& graph, double weld, GraphRepairs& repairs, Progress& progress)
{
    check_coordinates(graph);
    if (graph.edges.empty()) throw CommandError("the graph has no edges");
    CleanGraph clean{graph, static_cast<std::uint32_t>(graph.vertices.size()), {}, std::vector<std::uint32_t>(graph.edges.size())};
    std::iota(clean.edge_ids.begin(), clean.edge_ids.end(), 0u);
    repairs.repeated += drop_repeated(clean);

    const std::vector<std::uint32_t> first = first_within_reach(graph.vertices, weld, progress);
    std::uint32_t welded = 0;
    for (std::uint32_t v = 0; v < first.size(); ++v)
        if (first[v] != v) ++welded;
    if (welded > 0) {
        for (auto& edge : clean.graph.edges)
            for (std::uint32_t& v : edge) v = first[v];
        repairs.repeated += drop_repeated(clean);
        repairs.welded += welded;
    }
    clean.edge_ends.reserve(clean.edge_ids.size());
    for (const std::uint32_t e : clean.edge_ids) clean.edge_ends.push_back(graph.edges[e]);
    for (std::size_t e = 0; e < clean.graph.edges.size(); ++e)
        if (const auto& [v, w] = clean.graph.edges[e]; v == w)
            throw CommandError(fmt::format("edge {} of the graph has no length: it ends at vertex {} where it begins", clean.edge_ids[e], v));

    clean.vertex_ids = keep_used(clean.graph);
    repairs.isolated += static_cast<std::uint32_t>(graph.vertices.size() - clean.vertex_ids.size()) - welded;
    return clean;
}

std::uint32_t drop_isolated(Graph& graph)
{
    const std::size_t before = graph.vertices.size();
    return static_cast<std::uint32_t>(before - keep_used(graph).size());
}

} // namespace druse
