#include "graph/strut_contacts.h"

#include "dlfl/triangulate.h"
#include "geom/box_tree.h"
#include "geom/segments.h"
#include "geom/sort_unique.h"
#include "graph/largest_factor.h"
#include "graph/strut_part.h"

#include <algorithm>

namespace druse {

namespace {

/// The triangles of faces, as they are cut for printing.
void gather(const Mesh& mesh, const std::vector<Face>& faces, Triangulator& triangulator, PartTriangles& out)
{
    out.clear();
    for (const Face f : faces)
        for (const auto& [a, b, c] : triangulator.triangles(mesh, f)) out.add({mesh.position(a), mesh.position(b), mesh.position(c)}, f);
}

} // namespace

double StrutNeighbours::radius(std::uint32_t part, const StrutPlacement& placement) const
{
    const auto edges = static_cast<std::uint32_t>(graph_.edges.size());
    if (part >= edges) return placement.reach[part - edges];
    return std::max(placement.ends[2 * part].radius, placement.ends[2 * part + 1].radius);
}

double StrutNeighbours::distance(const PartPair& pair) const
{
    const auto edges = static_cast<std::uint32_t>(graph_.edges.size());
    const auto ends = [this](std::uint32_t e) { return std::array{graph_.vertices[graph_.edges[e][0]], graph_.vertices[graph_.edges[e][1]]}; };
    if (pair[0] >= edges) return glm::distance(graph_.vertices[pair[0] - edges], graph_.vertices[pair[1] - edges]);
    const auto [a, b] = ends(pair[0]);
    if (pair[1] >= edges) return distance_to_segment(graph_.vertices[pair[1] - edges], a, b);
    const auto [c, d] = ends(pair[1]);
    return nearest_points(a, b, c, d).distance;
}

/// Neighbours in the graph, and what lies at a leaf, which is in the strut that ends there.
bool StrutNeighbours::joined(const PartPair& pair) const
{
    const auto edges = static_cast<std::uint32_t>(graph_.edges.size());
    const auto holds = [this](std::uint32_t e, std::uint32_t v) { return graph_.edges[e][0] == v || graph_.edges[e][1] == v; };
    if (pair[1] < edges) return holds(pair[0], graph_.edges[pair[1]][0]) || holds(pair[0], graph_.edges[pair[1]][1]);
    const std::uint32_t w = pair[1] - edges;
    if (pair[0] < edges) return incidence_.valence(w) == 1 || holds(pair[0], w);
    const std::uint32_t v = pair[0] - edges;
    if (incidence_.valence(v) == 1 || incidence_.valence(w) == 1) return true;
    const bool swap = incidence_.valence(v) > incidence_.valence(w);
    for (const std::uint32_t end : incidence_.ends(swap ? w : v))
        if (holds(end / 2, swap ? v : w)) return true;
    return false;
}

/// Boxes of all parts, or of edges alone where nothing says how thick they are.
std::vector<Box> StrutNeighbours::boxes(const StrutPlacement* placement, double least) const
{
    const auto edges = static_cast<std::uint32_t>(graph_.edges.size());
    std::vector<Box> list(placement ? edges + graph_.vertices.size() : edges);
    for (std::uint32_t part = 0; part < list.size(); ++part) {
        if (part < edges) {
            for (const std::uint32_t v : graph_.edges[part]) list[part].add(graph_.vertices[v]);
        } else {
            list[part].add(graph_.vertices[part - edges]);
        }
        const Vector wide(placement ? std::max(radius(part, *placement), least) : least);
        list[part].min -= wide;
        list[part].max += wide;
    }
    return list;
}

/// Calls f(pair, distance) for parts with boxes that overlap and that are not joined, until it returns false.
template <class F>
void StrutNeighbours::walk(const std::vector<Box>& boxes, Progress& progress, F&& f) const
{
    const BoxTree tree(boxes, progress, 0, 0.4);
    tree.for_each_pair(progress, 0.4, [&](std::uint32_t i, std::uint32_t j) {
        const PartPair pair{std::min(i, j), std::max(i, j)};
        return joined(pair) || f(pair, distance(pair));
    });
}

NearParts StrutNeighbours::near(const StrutPlacement& placement, double least, Progress& progress) const
{
    const auto edges = static_cast<std::uint32_t>(graph_.edges.size());
    NearParts found;
    const auto add_meeting = [&](const PartPair& pair, double d) {
        if (pair[1] < edges && d <= least) found.meeting.push_back(pair);
        return found.meeting.size() < NearParts::most;
    };
    walk(boxes(&placement, least), progress, [&](const PartPair& pair, double d) {
        if (d <= radius(pair[0], placement) + radius(pair[1], placement)) found.pairs.push_back(pair);
        return found.complete = add_meeting(pair, d) && found.pairs.size() < NearParts::most;
    });
    if (!found.complete) { // what is thinner overlaps less
        found.meeting.clear();
        walk(boxes(nullptr, least), progress, add_meeting);
    }
    std::sort(found.pairs.begin(), found.pairs.end());
    std::sort(found.meeting.begin(), found.meeting.end());
    return found;
}

void StrutNeighbours::for_each_list(const NearParts& known, const StrutPlacement& placement, Progress& progress,
                                    const std::function<bool(const std::vector<PartPair>&)>& f) const
{
    if (known.complete) {
        f(known.pairs);
        return;
    }
    std::vector<PartPair> list;
    bool goes_on = true;
    const auto tell = [&] {
        std::sort(list.begin(), list.end());
        goes_on = f(list);
        list.clear();
        return goes_on;
    };
    walk(boxes(&placement, 0), progress, [&](const PartPair& pair, double d) {
        if (d <= radius(pair[0], placement) + radius(pair[1], placement)) list.push_back(pair);
        return list.size() < NearParts::most || tell();
    });
    if (goes_on && !list.empty()) tell();
}

double StrutNeighbours::clearing_factor(const StrutPlacer& placer, const std::vector<PartPair>& pairs, double most) const
{
    std::vector<double> distances;
    distances.reserve(pairs.size());
    for (const PartPair& pair : pairs) distances.push_back(distance(pair));
    return most * largest_factor([&](double factor) {
        const StrutPlacement placement = placer.place(most * factor);
        for (std::size_t i = 0; i < pairs.size(); ++i)
            if (distances[i] <= radius(pairs[i][0], placement) + radius(pairs[i][1], placement)) return false;
        return true;
    });
}

/// What lies at a leaf belongs to the strut that ends there.
void StrutNeighbours::list_faces(const StrutTable& table, std::uint32_t part, std::vector<Face>& faces) const
{
    faces.clear();
    const auto edges = static_cast<std::uint32_t>(graph_.edges.size());
    if (part >= edges) return table.add_ball(part - edges, faces);
    table.add_strut(part, faces);
    for (const std::uint32_t v : graph_.edges[part]) table.add_cap(v, faces);
}

bool StrutNeighbours::add_contacts(const StrutSurface& surface, const std::vector<PartPair>& pairs, StrutContacts& found, Progress& progress) const
{
    const Mesh& mesh = surface.mesh;
    PartTriangles first, second;
    Triangulator triangulator;
    std::vector<Face> faces;
    for (std::size_t i = 0; i < pairs.size() && found.pairs < StrutContacts::most; ++i) {
        if (i % 64 == 0) progress.step(double(i) / double(pairs.size()));
        if (i == 0 || pairs[i][0] != pairs[i - 1][0]) {
            list_faces(surface.table, pairs[i][0], faces);
            gather(mesh, faces, triangulator, first);
        }
        list_faces(surface.table, pairs[i][1], faces);
        gather(mesh, faces, triangulator, second);
        const std::uint64_t before = found.pairs;
        first.for_each_contact(second, [&](const auto& a, const auto& b) {
            found.faces.insert(found.faces.end(), {a.face, b.face});
            return ++found.pairs < StrutContacts::most;
        });
        if (found.pairs > before) found.parts.push_back(pairs[i]);
    }
    sort_unique(found.faces);
    return found.pairs < StrutContacts::most;
}

} // namespace druse
