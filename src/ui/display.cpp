#include "ui/display.h"

#include "ops/shown_lines.h"

#include <algorithm>
#include <utility>

namespace druse::ui {

namespace {

constexpr std::uint32_t quickly_counted = 20000; // faces
constexpr std::size_t most_starts = 5000;        // more dots than that say nothing

GroupColours colours_of(const GroupTable& groups)
{
    return [&groups](int group) { return groups.colour(group); };
}

Counts shown_counts(const Scene& scene)
{
    if (!shows_source(scene)) return scene.mesh.counts();
    const auto lines = [](std::size_t vertices, std::size_t edges) { return Counts{static_cast<std::uint32_t>(vertices), static_cast<std::uint32_t>(edges), 0}; };
    if (const Pane* pane = std::get_if<Pane>(&*scene.source)) return lines(pane->point_count(), pane->edge_count());
    if (const LayeredTile* tile = std::get_if<LayeredTile>(&*scene.source)) {
        const std::size_t points = tile->surface().points.size(), triangles = tile->surface().triangles.size();
        return lines(points, points + triangles - 1); // of a disk
    }
    if (const CellTile* cell = std::get_if<CellTile>(&*scene.source)) {
        std::size_t triangles = 0; // of one of each pair of panes
        for (int pane = 0; pane < cell->pane_count(); ++pane) triangles += cell->mesh(pane).triangles.size();
        return lines(triangles + 2, 3 * triangles); // of a sphere
    }
    const Graph& graph = std::get<Graph>(*scene.source);
    return lines(graph.vertices.size(), graph.edges.size());
}

void build(DrawLists& lists, const Scene& scene)
{
    const ShownLines lines(scene);
    if (lines.graph()) lists.build(*lines.graph());
    else lists.build(scene.mesh, colours_of(*scene.groups));
}

} // namespace

std::vector<GroupSize> group_sizes(const Mesh& mesh)
{
    std::vector<GroupSize> sizes;
    if (std::size_t(mesh.largest_group()) <= 2 * std::size_t(mesh.face_count()) + 1000) {
        std::vector<std::uint32_t> counts(std::size_t(mesh.largest_group()) + 1, 0);
        for (const Face f : mesh.faces()) ++counts[std::size_t(mesh.group(f))];
        for (std::size_t id = 0; id < counts.size(); ++id)
            if (counts[id] > 0) sizes.push_back({static_cast<int>(id), counts[id]});
        return sizes;
    }
    std::vector<int> ids;
    ids.reserve(mesh.face_count());
    for (const Face f : mesh.faces()) ids.push_back(mesh.group(f));
    std::ranges::sort(ids);
    for (const int id : ids) {
        if (sizes.empty() || sizes.back().id != id) sizes.push_back({id, 0});
        ++sizes.back().faces;
    }
    return sizes;
}

DisplayChange::DisplayChange(const Document& document, MeshDelta delta, bool draws_sources) : delta_(std::move(delta))
{
    const Scene& scene = document.scene();
    const std::size_t changed = delta_.faces.size() + delta_.vertices.size();
    if (delta_.whole || changed > scene.mesh.face_count() / 2) {
        delta_.whole = true;
        const Pane* pane = shows_source(scene) ? std::get_if<Pane>(&*scene.source) : nullptr;
        if (pane && draws_sources) lines_ = pane_edges(*pane);
        else lists_.emplace();
        if (lists_ && (draws_sources || !shows_source(scene))) build(*lists_, scene);
    }
    if (delta_.whole || !delta_.faces.empty() || !delta_.regrouped.empty()) group_sizes_ = group_sizes(scene.mesh);
    if (scene.mesh.face_count() <= quickly_counted) facts_ = facts(scene.mesh);
    if (scene.selection->faces.size() <= most_starts)
        for (const Face f : scene.selection->faces) {
            const Point corner = scene.mesh.position(scene.mesh.corner(f));
            starts_.push_back(corner + 0.12 * (vertex_mean(scene.mesh, f) - corner));
        }
}

void DisplayChange::apply_to(Display& display, const Document& document)
{
    const Scene& scene = document.scene();
    if (lists_) {
        display.lists = std::move(*lists_);
        display.lists.select(scene.selection->faces);
    } else if (lines_) {
        display.lists.update(*lines_);
    } else {
        const bool mesh_changed = !(delta_.vertices.empty() && delta_.edges.empty() && delta_.faces.empty() && delta_.regrouped.empty());
        if (mesh_changed) display.lists.update(scene.mesh, delta_, colours_of(*scene.groups));
        if (!display.groups.same_as(scene.groups) && !(*display.groups == *scene.groups))
            display.lists.recolour(scene.mesh, colours_of(*scene.groups));
        display.lists.select(scene.selection->faces);
    }
    display.counts = shown_counts(scene);
    display.facts = std::move(facts_);
    display.groups = scene.groups;
    if (group_sizes_) display.group_sizes = std::move(*group_sizes_);
    display.selection = scene.selection;
    display.starts = std::move(starts_);

    const History& history = document.history();
    display.beginning = history.beginning().text;
    display.steps.clear();
    for (std::size_t i = 0; i < history.size(); ++i) display.steps.push_back(history[i].command.text);
    display.done = history.done();
    display.first = history.first();
}

MeshDelta whole_delta()
{
    MeshDelta delta;
    delta.whole = true;
    return delta;
}

MeshDelta both(MeshDelta a, const MeshDelta& b, const Mesh& mesh)
{
    // What the first one lists may be gone, and its id with it.
    std::erase_if(a.vertices, [&](Vertex v) { return v.index >= mesh.vertex_limit(); });
    std::erase_if(a.edges, [&](Edge e) { return e.index >= mesh.edge_limit(); });
    std::erase_if(a.faces, [&](Face f) { return f.index >= mesh.face_limit(); });
    std::erase_if(a.regrouped, [&](Face f) { return f.index >= mesh.face_limit(); });
    a.whole = a.whole || b.whole;
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    a.edges.insert(a.edges.end(), b.edges.begin(), b.edges.end());
    a.faces.insert(a.faces.end(), b.faces.begin(), b.faces.end());
    a.regrouped.insert(a.regrouped.end(), b.regrouped.begin(), b.regrouped.end());
    return a;
}

} // namespace druse::ui
