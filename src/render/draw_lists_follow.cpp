#include "render/draw_lists.h"

#include "geom/sort_unique.h"
#include "render/palette.h"

#include <algorithm>

namespace druse {

namespace {

constexpr std::uint32_t left_over = 4096; // elements left behind that a small mesh may have

} // namespace

void DrawLists::update(const Graph& graph)
{
    Box box;
    for (const Point& p : graph.vertices) box.add(p);
    if (id_ == 0 || face_triangles_.size() > 0 || is_divided_ || origin_for(box) != origin_) {
        build(graph);
        return;
    }
    new_version();
    shape_version_ = version_;
    const auto vertices = static_cast<std::uint32_t>(graph.vertices.size()), edges = static_cast<std::uint32_t>(graph.edges.size());
    if (vertices < positions_.size()) {
        positions_.truncate(vertices);
        newest_.truncate(vertices);
        draw_vertices_.truncate(vertices); // one for each vertex
        vertex_of_.truncate(vertices);
        next_copy_.truncate(vertices);
        vertex_versions_.resize((vertices >> block_bits) + 1, version_);
    }
    for (std::uint32_t v = 0; v < vertices; ++v) {
        const Point& p = graph.vertices[v];
        if (v >= positions_.size()) {
            positions_.push_back(p);
            newest_.push_back(none);
            copy_vertex(v);
        } else if (positions_[v] != p) {
            positions_.set(v, p);
            const Vector q = p - origin_;
            draw_vertices_.set(v, {float(q.x), float(q.y), float(q.z), 0, 0});
            touch(vertex_versions_, v);
        }
    }
    edge_sum_ = 0;
    if (edges < edge_ends_.size()) edge_ends_.truncate(edges);
    edge_versions_.resize((edges >> block_bits) + 1, version_);
    for (std::uint32_t e = 0; e < edges; ++e) {
        const auto& [a, b] = graph.edges[e];
        edge_sum_ += glm::distance(graph.vertices[a], graph.vertices[b]);
        if (e >= edge_ends_.size()) edge_ends_.push_back({a, b});
        else if (edge_ends_[e] != std::array{a, b}) edge_ends_.set(e, {a, b});
        else continue;
        touch(edge_versions_, e);
    }
    mean_edge_ = edges == 0 ? 0.0 : edge_sum_ / double(edges);
    bounds_ = reach_ = box;
}

void DrawLists::update(const Mesh& mesh, const MeshDelta& delta, const GroupColours& colours)
{
    const std::uint32_t known_faces = face_triangles_.size();
    const std::size_t dead = triangles_.size() - live_triangles_;
    const bool crowded =
        dead > live_triangles_ / 2 + left_over || draw_vertices_.size() > 2 * (live_triangles_ + mesh.vertex_limit()) + left_over;
    const bool much =
        delta.whole || delta.faces.size() + delta.vertices.size() > (mesh.face_limit() + mesh.vertex_limit()) / 4 + 64;
    if (much && !crowded && is_only_moved(mesh, delta)) {
        put_places(mesh);
        if (!is_far_from_origin()) return;
    }
    if (id_ == 0 || much || crowded || (live_triangles_ == 0 && mesh.face_count() > 0)) {
        std::vector<Face> selection;
        for (const Face f : selected_)
            if (mesh.is_alive(f)) selection.push_back(f);
        build(mesh, colours);
        select(selection);
        return;
    }
    new_version();
    if (!(delta.vertices.empty() && delta.edges.empty() && delta.faces.empty())) shape_version_ = version_;
    Palette palette(colours);

    // The faces and edges to put again: those that changed, and all around a vertex that moved.
    std::vector<Face> faces = delta.faces;
    std::vector<Edge> edges = delta.edges;
    for (const Vertex v : delta.vertices) {
        if (!mesh.is_alive(v)) continue;
        for (const Corner c : mesh.around(v)) {
            if (!mesh.face(c).is_boundary()) faces.push_back(mesh.face(c));
            if (mesh.edge(c).valid()) edges.push_back(mesh.edge(c));
        }
    }
    sort_unique(faces);
    for (std::uint32_t i = mesh.edge_limit(); i < edge_ends_.size(); ++i) edges.push_back(Edge(i));
    for (std::uint32_t i = edge_ends_.size(); i < mesh.edge_limit(); ++i) edges.push_back(Edge(i));
    sort_unique(edges);
    for (const Edge e : edges)
        if (e.index < edge_ends_.size()) edge_sum_ -= length(e);

    std::vector<std::uint32_t> blocks;
    const auto note_blocks = [&](Face f) {
        const Range range = face_triangles_[f.index];
        for (std::uint32_t i = range.first >> pick_bits; range.count > 0 && i <= (range.first + range.count - 1) >> pick_bits;
             ++i)
            blocks.push_back(i);
    };
    const auto remove = [&](Face f) {
        note_blocks(f);
        release(f);
    };
    for (const Face f : faces)
        if (f.index < known_faces) remove(f);
    for (std::uint32_t i = mesh.face_limit(); i < known_faces; ++i) remove(Face(i));

    resize(mesh);
    std::erase_if(selected_, [&](Face f) { return f.index >= mesh.face_limit(); });

    for (const Vertex v : delta.vertices) {
        if (v.index >= positions_.size()) continue;
        positions_.set(v.index, mesh.position(v));
        const Vector p = mesh.position(v) - origin_;
        for (std::uint32_t copy = newest_[v.index]; copy != none; copy = next_copy_[copy]) {
            DrawVertex& vertex = *draw_vertices_.write(copy, 1);
            vertex.x = float(p.x), vertex.y = float(p.y), vertex.z = float(p.z);
            touch(vertex_versions_, copy);
        }
    }
    for (const Face f : faces) {
        if (!mesh.is_alive(f)) continue;
        face_group_.set(f.index, mesh.group(f));
        put_triangles(mesh, f, palette, nullptr);
        note_blocks(f);
    }
    for (const Face f : delta.regrouped) {
        if (!mesh.is_alive(f)) continue;
        face_group_.set(f.index, mesh.group(f));
        paint(f, palette);
    }

    const auto take_edge = [&](Edge e) {
        std::array<std::uint32_t, 2> ends{none, none};
        if (mesh.is_alive(e)) {
            ends = {mesh.ends(e)[0].index, mesh.ends(e)[1].index};
            for (const std::uint32_t v : ends)
                if (newest_[v] == none) copy_vertex(v);
        }
        edge_ends_.set(e.index, ends);
        edge_sum_ += length(e);
        touch(edge_versions_, e.index);
    };
    for (const Edge e : edges)
        if (e.index < edge_ends_.size()) take_edge(e);
    mean_edge_ = mesh.edge_count() > 0 ? edge_sum_ / mesh.edge_count() : 0.0;
    take_boundary(mesh);

    sort_unique(blocks);
    for (const std::uint32_t block : blocks) renew_box(block);
    renew_bounds();
    // Where the model has moved far from what its single precision places are relative to, they are taken anew.
    if (is_far_from_origin()) {
        const std::vector<Face> selection = selected_;
        build(mesh, colours);
        select(selection);
    }
}

/// Whether there are triangles only, and no others than before: polygons may be cut otherwise when they have moved.
bool DrawLists::is_only_moved(const Mesh& mesh, const MeshDelta& delta) const
{
    if (delta.whole || !(delta.edges.empty() && delta.faces.empty() && delta.regrouped.empty()) || is_divided_ || live_triangles_ == 0) return false;
    if (mesh.vertex_limit() != positions_.size() || mesh.edge_limit() != edge_ends_.size() || mesh.face_limit() != face_triangles_.size()) return false;
    return std::ranges::none_of(face_triangles_.view(), [](const Range& range) { return range.count > 1; });
}

/// Takes the places of all vertices again, and what follows from them.
void DrawLists::put_places(const Mesh& mesh)
{
    new_version();
    shape_version_ = version_;
    Point* place = positions_.write(0, positions_.size());
    for (std::uint32_t v = 0; v < positions_.size(); ++v) place[v] = mesh.position(Vertex(v));
    DrawVertex* vertices = draw_vertices_.write(0, draw_vertices_.size());
    for (std::uint32_t i = 0; i < draw_vertices_.size(); ++i) {
        const Vector p = place[vertex_of_[i]] - origin_;
        vertices[i].x = float(p.x), vertices[i].y = float(p.y), vertices[i].z = float(p.z);
    }
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
        if (triangle_face_[t] == none) continue;
        const auto [a, b, c] = triangles_[t];
        const Point& from = place[vertex_of_[a]];
        vertices[c].normal = pack_normal(unit(glm::cross(place[vertex_of_[b]] - from, place[vertex_of_[c]] - from)));
    }
    vertex_versions_.assign(vertex_versions_.size(), version_);
    triangle_versions_.assign(triangle_versions_.size(), version_); // the heights of their sides are made of these
    edge_sum_ = 0;
    for (std::uint32_t e = 0; e < edge_ends_.size(); ++e) edge_sum_ += length(Edge(e));
    mean_edge_ = mesh.edge_count() > 0 ? edge_sum_ / mesh.edge_count() : 0.0;
    for (std::uint32_t block = 0; block < pick_boxes_.size(); ++block) renew_box(block);
    renew_bounds();
}

void DrawLists::paint(Face f, Palette& palette)
{
    const Range range = face_triangles_[f.index];
    const std::uint32_t colour = palette(face_group_[f.index]) | (face_selected_[f.index] ? DrawVertex::selected_flag : 0u);
    for (std::uint32_t t = range.first; t < range.first + range.count; ++t) {
        const std::uint32_t last = triangles_[t][2];
        const std::uint32_t before = draw_vertices_[last].look;
        const std::uint32_t look = (before & 0xff000000u & ~DrawVertex::selected_flag) | colour;
        if (look == before) continue;
        draw_vertices_.write(last, 1)->look = look;
        touch(vertex_versions_, last);
    }
}

void DrawLists::recolour(const Mesh& mesh, const GroupColours& colours)
{
    recolour([&](Face f) { return mesh.is_alive(f) ? mesh.group(f) : 0; }, colours);
}

void DrawLists::recolour(const std::function<int(Face)>& group_of, const GroupColours& colours)
{
    new_version();
    Palette palette(colours);
    for (std::uint32_t i = 0; i < face_limit(); ++i) {
        face_group_.set(i, group_of(Face(i)));
        paint(Face(i), palette);
    }
}

void DrawLists::set_copies(std::vector<Copy> copies)
{
    if (copies == copies_) return;
    copies_ = std::move(copies);
    new_version();
}

void DrawLists::select(std::span<const Face> faces)
{
    new_version();
    const auto mark = [&](Face f, bool on) {
        if (f.index >= face_limit()) return;
        face_selected_.set(f.index, on ? 1 : 0);
        const Range range = face_triangles_[f.index];
        for (std::uint32_t t = range.first; t < range.first + range.count; ++t) {
            const std::uint32_t last = triangles_[t][2];
            std::uint32_t& look = draw_vertices_.write(last, 1)->look;
            look = on ? look | DrawVertex::selected_flag : look & ~DrawVertex::selected_flag;
            touch(vertex_versions_, last);
        }
    };
    for (const Face f : selected_) mark(f, false);
    for (const Face f : faces) mark(f, true);
    selected_.assign(faces.begin(), faces.end());
}

} // namespace druse
