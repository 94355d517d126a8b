#include "graph/strut_contacts.h"

#include "dlfl/triangulate.h"
#include "geom/box_tree.h"
#include "geom/segments.h"
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

bool StrutNeighbours::is_near(const PartPair& pair, const StrutPlacement& placement) const
{
    return distance(pair) <= radius(pair[0], placement) + radius(pair[1], placement);
}

std::vector<PartPair> StrutNeighbours::near(const StrutPlacement& placement, double least, Progress& progress) const
{
    const auto edges = static_cast<std::uint32_t>(graph_.edges.size());
    const auto parts = edges + static_cast<std::uint32_t>(graph_.vertices.size());
    std::vector<Box> boxes(parts);
    for (std::uint32_t part = 0; part < parts; ++part) {
        if (part < edges) {
            for (const std::uint32_t v : graph_.edges[part]) boxes[part].add(graph_.vertices[v]);
        } else {
            boxes[part].add(graph_.vertices[part - edges]);
        }
        const Vector wide(std::max(radius(part, placement), least));
        boxes[part].min -= wide;
        boxes[part].max += wide;
    }
    const BoxTree tree(boxes, progress, 0, 0.4);
    boxes = {};
    std::vector<PartPair> found;
    tree.for_each_pair(progress, 0.4, [&](std::uint32_t i, std::uint32_t j) {
        const PartPair pair{std::min(i, j), std::max(i, j)};
        if (joined(pair)) return true;
        const double d = distance(pair);
        if (d <= radius(pair[0], placement) + radius(pair[1], placement) || (pair[1] < edges && d <= least)) found.push_back(pair);
        return true;
    });
    std::sort(found.begin(), found.end());
    return found;
}

double clearing_factor(const StrutNeighbours& neighbours, const StrutPlacer& placer, const std::vector<PartPair>& pairs)
{
    const auto clears = [&](double factor) {
        const StrutPlacement placement = placer.place(factor);
        return std::none_of(pairs.begin(), pairs.end(), [&](const PartPair& pair) { return neighbours.is_near(pair, placement); });
    };
    double good = 0, bad = 1;
    while (good < bad * (1 - 1e-9) && bad > 1e-9) {
        const double middle = 0.5 * (good + bad);
        (clears(middle) ? good : bad) = middle;
    }
    return good;
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

StrutContacts StrutNeighbours::contacts(const StrutSurface& surface, const std::vector<PartPair>& pairs, Progress& progress) const
{
    const Mesh& mesh = surface.mesh;
    StrutContacts result;
    FaceData<bool> meets(mesh, false);
    PartTriangles first, second;
    Triangulator triangulator;
    std::vector<Face> faces;
    for (std::size_t i = 0; i < pairs.size() && result.pairs < StrutContacts::most; ++i) {
        if (i % 64 == 0) progress.step(double(i) / double(pairs.size()));
        if (i == 0 || pairs[i][0] != pairs[i - 1][0]) {
            list_faces(surface.table, pairs[i][0], faces);
            gather(mesh, faces, triangulator, first);
        }
        list_faces(surface.table, pairs[i][1], faces);
        gather(mesh, faces, triangulator, second);
        const std::uint64_t before = result.pairs;
        first.for_each_contact(second, [&](const auto& a, const auto& b) {
            meets[a.face] = meets[b.face] = true;
            return ++result.pairs < StrutContacts::most;
        });
        if (result.pairs > before) result.parts.push_back(pairs[i]);
    }
    for (const Face f : mesh.faces())
        if (meets[f]) result.faces.push_back(f);
    return result;
}

} // namespace druse
