#include "graph/split_crossings.h"

#include "geom/segments.h"
#include "graph/weld.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace druse {

namespace {

/// Whether two segments that meet run along each other: where the one begins and ends beside the other they are as near.
bool run_along(const Point& a, const Point& b, const Point& c, const Point& d, double reach)
{
    const Vector along = b - a;
    const double square = glm::dot(along, along);
    const double from = glm::dot(c - a, along) / square, to = glm::dot(d - a, along) / square;
    const double begin = std::clamp(std::min(from, to), 0.0, 1.0), end = std::clamp(std::max(from, to), 0.0, 1.0);
    if (!((end - begin) * std::sqrt(square) > 4 * reach)) return false;
    return distance_to_segment(a + begin * along, c, d) <= 2 * reach && distance_to_segment(a + end * along, c, d) <= 2 * reach;
}

} // namespace

std::vector<Crossing> crossings(const Graph& graph, const std::vector<PartPair>& pairs, double reach)
{
    std::vector<Crossing> list;
    for (const auto& [e, f] : pairs) {
        if (f >= graph.edges.size()) continue;
        const Point &a = graph.vertices[graph.edges[e][0]], &b = graph.vertices[graph.edges[e][1]];
        const Point &c = graph.vertices[graph.edges[f][0]], &d = graph.vertices[graph.edges[f][1]];
        const NearestPoints nearest = nearest_points(a, b, c, d);
        if (!(nearest.distance <= reach)) continue;
        const Point p = a + nearest.s * (b - a), q = c + nearest.t * (d - c);
        list.push_back({e, f, nearest.s, nearest.t, 0.5 * (p + q), run_along(a, b, c, d, reach)});
    }
    return list;
}

CleanGraph split(const CleanGraph& clean, const std::vector<Crossing>& list, double reach, Progress& progress)
{
    // Every crossing gets a vertex on both edges; those that coincide, with each other or with an end, are then one.
    struct Stop {
        std::uint32_t edge;
        double place;
        std::uint32_t vertex;
    };
    std::vector<Stop> stops;
    std::vector<Point> points = clean.graph.vertices;
    for (const Crossing& c : list) {
        stops.push_back({c.first, c.s, static_cast<std::uint32_t>(points.size())});
        stops.push_back({c.second, c.t, static_cast<std::uint32_t>(points.size())});
        points.push_back(c.place);
    }
    const std::vector<std::uint32_t> same = first_within_reach(points, 4 * reach, progress);
    std::sort(stops.begin(), stops.end(), [](const Stop& a, const Stop& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.place != b.place ? a.place < b.place : a.vertex < b.vertex;
    });

    CleanGraph result;
    result.graph.vertices = std::move(points);
    result.vertex_ids = clean.vertex_ids;
    result.vertex_ids.resize(result.graph.vertices.size());
    std::iota(result.vertex_ids.begin() + static_cast<std::ptrdiff_t>(clean.vertex_ids.size()), result.vertex_ids.end(), clean.given);
    auto stop = stops.begin();
    for (std::uint32_t e = 0; e < clean.graph.edges.size(); ++e) {
        const auto& [a, b] = clean.graph.edges[e];
        std::uint32_t before = same[a];
        const auto add_piece = [&](std::uint32_t to) {
            if (to == before) return;
            result.graph.edges.push_back({before, to});
            if (!clean.graph.normals.empty()) result.graph.normals.push_back(clean.graph.normals[e]);
            result.edge_ids.push_back(clean.edge_ids[e]);
            result.edge_ends.push_back(clean.edge_ends[e]);
            before = to;
        };
        for (; stop != stops.end() && stop->edge == e; ++stop) add_piece(same[stop->vertex]);
        add_piece(same[b]);
    }
    GraphRepairs repairs;
    CleanGraph again = cleaned(result.graph, 0, repairs, progress);
    again.given = clean.given;
    for (std::uint32_t& v : again.vertex_ids) v = result.vertex_ids[v];
    for (std::size_t e = 0; e < again.edge_ids.size(); ++e) {
        again.edge_ends[e] = result.edge_ends[again.edge_ids[e]];
        again.edge_ids[e] = result.edge_ids[again.edge_ids[e]];
    }
    return again;
}

} // namespace druse
