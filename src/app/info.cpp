#include "app/info.h"

#include "app/padded.h"
#include "cell/cell_solid.h"
#include "dlfl/measures.h"
#include "graph/graph_facts.h"
#include "ops/selector.h"
#include "ops/shown_lines.h"
#include "ops/text.h"
#include "pane/pane_check.h"
#include "tile/tile_solid.h"
#include "tile/tile_stack.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace druse {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* units = "mm";

/// What of a pane is told beside its own facts.
struct PaneFacts {
    explicit PaneFacts(const Pane& pane) : own(check(pane)), lines(facts(pane_edges(pane))) {}

    PaneCheck own;
    GraphFacts lines; // its edges
};

/// What of a tile is told beside its own facts.
struct TileFacts {
    explicit TileFacts(const LayeredTile& t) : tile(t), lines(facts(tile_edges(t)))
    {
        if (!t.is_extruded()) return;
        for (int m = 0; m < member_count(t); ++m) {
            const int aspect = aspect_of_member(t, m);
            const TileSolid solid = make_solid(t, TileBottom::carved, aspect);
            min_thickness = std::min(min_thickness.value_or(solid.thinnest.thickness), solid.thinnest.thickness);
            if (m > 0 || !(solid.thinnest.thickness > 0)) continue;
            body = facts(solid_mesh(t, aspect, solid));
        }
    }
    static Mesh solid_mesh(const LayeredTile& t, int aspect, const TileSolid& solid)
    {
        MeshBuilder builder;
        add_solid(builder, solid, {t.to_world() * t.aspects()[std::size_t(aspect)], 0.0});
        return builder.build();
    }

    const LayeredTile& tile;
    GraphFacts lines; // its edges
    std::optional<double> min_thickness;
    std::optional<MeshFacts> body; // the solid of tile.solid, where there is one
};

/// What of a cell is told beside its own facts: those of its solid.
struct CellFacts {
    explicit CellFacts(const CellTile& c) : cell(c), mesh(facts(solid_mesh(c))) {}
    static Mesh solid_mesh(const CellTile& cell)
    {
        MeshBuilder builder;
        add_solid(builder, make_solid(cell), pane_groups(cell));
        return builder.build();
    }

    const CellTile& cell;
    MeshFacts mesh;
};

/// What is there to be told: the facts of the mesh, unless all there is is a source.
struct Facts {
    explicit Facts(const Scene& scene) : mesh(facts(scene.mesh)), only_source(shows_source(scene))
    {
        if (const Graph* g = std::get_if<Graph>(&*scene.source)) graph = facts(*g);
        if (const Pane* p = std::get_if<Pane>(&*scene.source)) pane.emplace(*p);
        if (const LayeredTile* t = std::get_if<LayeredTile>(&*scene.source)) tile.emplace(*t);
        if (const CellTile* c = std::get_if<CellTile>(&*scene.source)) cell.emplace(*c);
        kind = !only_source ? "mesh" : tile ? "layered" : name(*scene.source);
        if (only_source && tile && tile->body) mesh = *tile->body;
        if (only_source && cell) mesh = cell->mesh;
    }
    /// Whether `mesh` tells of faces: those of the scene, or of the solid that its tile or cell describes.
    bool has_solid() const { return !only_source || cell || (tile && tile->body); }

    MeshFacts mesh;
    std::optional<GraphFacts> graph;
    std::optional<PaneFacts> pane;
    std::optional<TileFacts> tile;
    std::optional<CellFacts> cell;
    bool only_source = false;
    const char* kind = nullptr;
};

// --- JSON ---------------------------------------------------------------------------------------------------------------------

Json json(const Point& p) { return {p.x, p.y, p.z}; }

Json box_json(const Box& box)
{
    if (box.empty()) return nullptr;
    return {{"min", json(box.min)}, {"max", json(box.max)}};
}

Json lengths_json(double least, double mean, double most, bool any)
{
    if (!any) return nullptr;
    return {{"min", least}, {"mean", mean}, {"max", most}};
}

Json counts_json(const std::map<int, std::uint32_t>& counts)
{
    Json object = Json::object();
    for (const auto& [n, count] : counts) object[std::to_string(n)] = count;
    return object;
}

template <class H>
Json ids_json(const std::vector<H>& list)
{
    Json ids = Json::array();
    for (const H h : list) ids.push_back(h.index);
    return ids;
}

Json groups_json(const MeshFacts& facts, const GroupTable& groups)
{
    Json object = Json::object();
    for (const auto& [id, faces] : facts.groups) {
        const std::string& name = groups.name(id);
        object[std::to_string(id)] = {{"faces", faces}, {"color", to_hex(groups.colour(id))}, {"name", name.empty() ? Json(nullptr) : Json(name)}};
    }
    return object;
}

void add_mesh(Json& j, const MeshFacts& m)
{
    j["vertices"] = m.counts.vertices;
    j["edges"] = m.counts.edges;
    j["faces"] = m.counts.faces;
    j["corners"] = m.corners;
    j["components"] = m.components;
    j["euler"] = m.euler;
    j["genus"] = m.genus;
    j["watertight"] = m.boundary_edges == 0;
    j["oriented"] = true; // a doubly linked face list is nothing else
    j["manifold"] = true;
    j["boundary_edges"] = m.boundary_edges;
    j["volume"] = m.volume;
    j["area"] = m.area;
    j["bbox"] = box_json(m.bounds);
    j["edge_length"] = lengths_json(m.shortest_edge, m.mean_edge, m.longest_edge, m.counts.edges > 0);
    j["sides"] = counts_json(m.sides);
    j["valences"] = counts_json(m.valences);
    j["max_nonplanarity"] = m.max_nonplanarity;
}

void add_graph(Json& j, const GraphFacts& g)
{
    j["vertices"] = g.vertices;
    j["edges"] = g.edges;
    j["faces"] = 0;
    j["corners"] = 0;
    j["components"] = g.components;
    for (const char* key : {"euler", "genus", "watertight", "oriented", "manifold", "boundary_edges", "volume", "area"}) j[key] = nullptr;
    j["bbox"] = box_json(g.bounds);
    j["edge_length"] = lengths_json(g.shortest_edge, g.mean_edge, g.longest_edge, g.edges > 0);
    j["sides"] = Json::object();
    j["valences"] = counts_json(g.valences);
    j["max_nonplanarity"] = nullptr;
}

/// Its triangles are faces, its boundary is open; what tells of a body is null.
void add_pane(Json& j, const PaneFacts& p)
{
    j["vertices"] = p.own.points;
    j["edges"] = p.own.edges;
    j["faces"] = p.own.triangles;
    j["corners"] = 3 * p.own.triangles;
    j["components"] = p.lines.components;
    j["euler"] = 1 - std::int64_t(p.own.holes);
    for (const char* key : {"genus", "watertight", "oriented", "manifold"}) j[key] = nullptr;
    j["boundary_edges"] = p.own.boundary_points;
    j["volume"] = nullptr;
    j["area"] = p.own.area;
    j["bbox"] = box_json(p.lines.bounds);
    j["edge_length"] = lengths_json(p.lines.shortest_edge, p.lines.mean_edge, p.lines.longest_edge, true);
    j["sides"] = {{"3", p.own.triangles}};
    j["valences"] = counts_json(p.lines.valences);
    j["max_nonplanarity"] = nullptr;
}

/// A tile without a solid has none of what is told of a mesh.
void add_nothing(Json& j)
{
    for (const char* key : {"vertices", "edges", "faces", "corners", "components", "euler", "genus", "watertight", "oriented", "manifold", "boundary_edges", "volume", "area",
                            "bbox", "edge_length", "sides", "valences", "max_nonplanarity"})
        j[key] = nullptr;
}

/// The offset of the stack in the lattice, from 0 to 1: what is the same for all offsets that make the same stack.
Point2 offset_class(const LayeredTile& tile)
{
    const TileStack& stack = tile.design().stack;
    if (stack.mode == TileStack::Mode::column) return Point2(0.0);
    const auto part = [](double x) {
        x -= std::floor(x);
        return x > 1 - 1e-9 || x < 1e-9 ? 0.0 : x;
    };
    const Point2 c = lattice_coordinates(tile.lattice(), stack.offset);
    return {part(c.x), part(c.y)};
}

void add_own_of_tile(Json& j, const TileFacts& t)
{
    const auto [t1, t2] = t.tile.lattice();
    const Point2 offset = offset_class(t.tile);
    j["type"] = t.tile.type().name();
    j["area"] = t.tile.area();
    j["lattice"] = {{t1.x, t1.y}, {t2.x, t2.y}};
    j["volume_expected"] = t.tile.is_extruded() ? Json(t.tile.thickness() * t.tile.area()) : Json(nullptr);
    j["aspects"] = t.tile.type().aspects();
    j["offset_class"] = {offset.x, offset.y};
    j["min_thickness"] = t.min_thickness ? Json(*t.min_thickness) : Json(nullptr);
    j["orbits"] = t.tile.outline().orbits;
}

void add_own_of_cell(Json& j, const CellFacts& f)
{
    const CellTile& cell = f.cell;
    j["cell"] = name(cell.cell().kind);
    j["phase"] = cell.phase();
    j["matrix"] = cell.matrix();
    j["lattice"] = Json::array();
    for (const Vector& v : cell.cell().lattice) j["lattice"].push_back(json(cell.world(v)));
    j["volume_expected"] = cell.volume();
    j["panes"] = cell.pane_count();
    int corners = 0, edges = 0, inside = 0;
    for (int i = 0; i < cell.point_count(); ++i) {
        const bool is_corner = cell.name(i).kind == CellPointName::Kind::corner;
        ++(is_corner ? corners : cell.pane_of(i) < 0 ? edges : inside);
    }
    j["orbits"] = {{"corner", corners}, {"edge", edges}, {"pane", inside}};
}

void add_own_of_pane(Json& j, const PaneCheck& p)
{
    j["points"] = p.points;
    j["boundary_points"] = p.boundary_points;
    j["holes"] = p.holes;
    j["segments"] = p.segments;
    j["triangles"] = p.triangles;
    j["area"] = p.area;
    j["smallest_angle"] = p.smallest_angle;
    j["locked"] = p.locked;
}

void add_own_of_graph(Json& j, const GraphFacts& g)
{
    j["cycle_rank"] = g.cycle_rank;
    j["smallest_angle"] = g.smallest_angle ? Json(*g.smallest_angle) : Json(nullptr);
}

// --- text ---------------------------------------------------------------------------------------------------------------------

/// Lines of a name and what it says, the second column aligned.
class Table {
public:
    void add(std::string_view name, std::string_view value) { text_ += padded(name, 23).append(value).append("\n"); }
    void add(std::string_view name, std::uint32_t value) { add(name, std::to_string(value)); }
    std::string take() { return std::move(text_); }

private:
    std::string text_;
};

std::string counted(std::uint32_t n, const char* one, const char* many) { return fmt::format("{} {}", n, n == 1 ? one : many); }

/// A number with at most six digits: for reading, not for reading back.
std::string rounded(double x) { return fmt::format("{:.6g}", x == 0.0 ? 0.0 : x); }

std::string spread(const std::map<int, std::uint32_t>& counts, const char* what)
{
    std::string text;
    for (const auto& [n, count] : counts) text += fmt::format("{}{} with {}", text.empty() ? "" : ", ", count, n);
    return text.empty() ? "none" : fmt::format("{} {}", text, what);
}

std::string box_text(const Box& box)
{
    if (box.empty()) return "none";
    const Vector size = box.size();
    return fmt::format("{} x {} x {} {}, from {},{},{} to {},{},{}", rounded(size.x), rounded(size.y), rounded(size.z), units, rounded(box.min.x),
                       rounded(box.min.y), rounded(box.min.z), rounded(box.max.x), rounded(box.max.y), rounded(box.max.z));
}

std::string lengths_text(double least, double mean, double most)
{
    return fmt::format("{} to {} {}, mean {} {}", rounded(least), rounded(most), units, rounded(mean), units);
}

template <class H>
std::string selected(const std::vector<H>& list)
{
    return list.empty() ? "none" : Selector<H>::of(list).text();
}

void add_mesh(Table& t, const MeshFacts& m, const GroupTable& groups)
{
    t.add("vertices", m.counts.vertices);
    t.add("edges", m.counts.edges);
    t.add("faces", m.counts.faces);
    t.add("corners", m.corners);
    t.add("components", m.components);
    t.add("Euler characteristic", std::to_string(m.euler));
    std::string genus = std::to_string(m.genus);
    if (m.component_genus.size() > 1 && m.component_genus.size() <= 16) {
        const char* before = " (";
        for (const std::int64_t g : m.component_genus) genus.append(std::exchange(before, " + ")).append(std::to_string(g));
        genus += ')';
    }
    t.add("genus", genus);
    t.add("watertight", m.boundary_edges == 0 ? "yes" : fmt::format("no, {}", counted(m.boundary_edges, "open edge", "open edges")));
    t.add("oriented", "yes");
    t.add("manifold", "yes");
    t.add("volume", fmt::format("{} {}³", rounded(m.volume), units));
    t.add("area", fmt::format("{} {}²", rounded(m.area), units));
    t.add("bounding box", box_text(m.bounds));
    if (m.counts.edges > 0) t.add("edge length", lengths_text(m.shortest_edge, m.mean_edge, m.longest_edge));
    t.add("faces by sides", spread(m.sides, "sides"));
    t.add("vertices by valence", spread(m.valences, "edges"));
    t.add("largest nonplanarity", fmt::format("{} {}", rounded(m.max_nonplanarity), units));
    for (const auto& [id, faces] : m.groups)
        t.add(fmt::format("group {}", id), fmt::format("{}, {}{}{}", counted(faces, "face", "faces"), to_hex(groups.colour(id)),
                                                       groups.name(id).empty() ? "" : ", ", groups.name(id)));
}

void add_graph(Table& t, const GraphFacts& g, const std::string& prefix)
{
    t.add(prefix + "vertices", g.vertices);
    t.add(prefix + "edges", g.edges);
    t.add(prefix + "components", g.components);
    t.add(prefix + "cycle rank", std::to_string(g.cycle_rank));
    t.add(prefix + "smallest angle", g.smallest_angle ? rounded(*g.smallest_angle) + " degrees" : "none");
}

void add_tile(Table& t, const TileFacts& f, const std::string& prefix)
{
    const LayeredTile& tile = f.tile;
    t.add(prefix + "type", tile.type().name());
    t.add(prefix + "points", fmt::format("{}, {} of them on the outline, in {} orbits", tile.point_count(), tile.outline_count(), tile.outline().orbits));
    t.add(prefix + "aspects", std::to_string(tile.type().aspects()));
    t.add(prefix + "area", fmt::format("{} {}²", rounded(tile.area()), units));
    if (!tile.is_extruded()) return;
    t.add(prefix + "volume", fmt::format("{} {}³", rounded(tile.area() * tile.thickness()), units));
    t.add(prefix + "min thickness", fmt::format("{} {}", rounded(*f.min_thickness), units));
}

void add_cell(Table& t, const CellFacts& f, const std::string& prefix)
{
    const CellTile& cell = f.cell;
    t.add(prefix + "cell", name(cell.cell().kind));
    t.add(prefix + "phase", std::to_string(cell.phase()));
    t.add(prefix + "panes", fmt::format("{} pairs, {} triangles in all", cell.pane_count(), f.mesh.counts.faces));
    t.add(prefix + "points", fmt::format("{}, in {} orbits", f.mesh.counts.vertices, cell.point_count()));
    t.add(prefix + "volume", fmt::format("{} {}³", rounded(cell.volume()), units));
}

void add_pane(Table& t, const PaneCheck& p, const std::string& prefix)
{
    t.add(prefix + "points", std::to_string(p.points));
    t.add(prefix + "boundary points", std::to_string(p.boundary_points));
    t.add(prefix + "holes", std::to_string(p.holes));
    t.add(prefix + "segments", std::to_string(p.segments));
    t.add(prefix + "triangles", std::to_string(p.triangles));
    t.add(prefix + "area", fmt::format("{} {}²", rounded(p.area), units));
    t.add(prefix + "smallest angle", rounded(p.smallest_angle) + " degrees");
    t.add(prefix + "locked", std::to_string(p.locked));
}

/// What graphs and panes have in common as lines.
void add_lines(Table& t, const GraphFacts& g)
{
    t.add("bounding box", box_text(g.bounds));
    if (g.edges > 0) t.add("edge length", lengths_text(g.shortest_edge, g.mean_edge, g.longest_edge));
    t.add("vertices by valence", spread(g.valences, "edges"));
}

std::string met_text(const std::optional<SelfIntersections>& met)
{
    if (!met) return "not looked for; --check does";
    if (met->pairs == 0) return "none";
    return fmt::format("{} of triangles, in {} faces", met->pairs == 1 ? "1 pair" : fmt::format("{} pairs", met->pairs), met->faces.size());
}

} // namespace

std::optional<SelfIntersections> self_intersections(const Scene& scene, Progress& progress)
{
    if (!shows_source(scene)) return self_intersections(scene.mesh, progress);
    if (const CellTile* c = std::get_if<CellTile>(&*scene.source)) return self_intersections(CellFacts::solid_mesh(*c), progress);
    if (const LayeredTile* t = std::get_if<LayeredTile>(&*scene.source); t && t->is_extruded()) {
        const int aspect = aspect_of_member(*t, 0);
        const TileSolid solid = make_solid(*t, TileBottom::carved, aspect);
        if (solid.thinnest.thickness > 0) return self_intersections(TileFacts::solid_mesh(*t, aspect, solid), progress);
    }
    return std::nullopt;
}

std::string info_json(const Scene& scene, std::string_view file, const std::optional<SelfIntersections>& met)
{
    const Facts facts(scene);
    const MeshFacts& m = facts.mesh;
    Json j;
    j["file"] = file;
    j["kind"] = facts.kind;
    j["units"] = units;
    if (facts.only_source && facts.graph) add_graph(j, *facts.graph);
    else if (facts.only_source && facts.pane) add_pane(j, *facts.pane);
    else if (facts.only_source && facts.tile && !facts.tile->body) add_nothing(j);
    else add_mesh(j, m);
    j["groups"] = groups_json(m, *scene.groups);
    j["selection"] = {{"faces", ids_json(scene.selection->faces)},
                      {"edges", ids_json(scene.selection->edges)},
                      {"vertices", ids_json(scene.selection->vertices)}};
    j["parallel_edges"] = m.parallel_edges;
    j["point_spheres"] = m.point_spheres;
    j["zero_thickness_walls"] = m.zero_thickness_walls;
    j["self_intersections"] = met && facts.has_solid() ? Json(met->pairs) : Json(nullptr);
    if (facts.only_source) {
        if (facts.graph) add_own_of_graph(j, *facts.graph);
        if (facts.pane) add_own_of_pane(j, facts.pane->own);
        if (facts.tile) add_own_of_tile(j, *facts.tile);
        if (facts.cell) add_own_of_cell(j, *facts.cell);
    } else if (facts.graph) {
        Json& g = j["graph"];
        g["vertices"] = facts.graph->vertices;
        g["edges"] = facts.graph->edges;
        g["components"] = facts.graph->components;
        add_own_of_graph(g, *facts.graph);
    } else if (facts.pane) {
        add_own_of_pane(j["pane"], facts.pane->own);
    } else if (facts.tile) {
        add_own_of_tile(j["tile"], *facts.tile);
    } else if (facts.cell) {
        add_own_of_cell(j["cell"], *facts.cell);
    }
    return j.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string info_text(const Scene& scene, std::string_view file, const std::optional<SelfIntersections>& met)
{
    const Facts facts(scene);
    Table t;
    t.add("file", file);
    t.add("kind", facts.kind);
    t.add("units", units);
    if (facts.only_source && facts.graph) {
        add_graph(t, *facts.graph, "");
        add_lines(t, *facts.graph);
    } else if (facts.only_source && facts.tile) {
        add_tile(t, *facts.tile, facts.tile->body ? "tile " : "");
        if (facts.tile->body) {
            add_mesh(t, facts.mesh, *scene.groups);
            t.add("self-intersections", met_text(met));
        } else {
            add_lines(t, facts.tile->lines);
        }
    } else if (facts.only_source && facts.cell) {
        add_cell(t, *facts.cell, "");
        add_mesh(t, facts.mesh, *scene.groups);
        t.add("self-intersections", met_text(met));
    } else if (facts.only_source) {
        add_pane(t, facts.pane->own, "");
        add_lines(t, facts.pane->lines);
    } else {
        add_mesh(t, facts.mesh, *scene.groups);
    }
    const Selection& selection = *scene.selection;
    t.add("selected faces", selected(selection.faces));
    t.add("selected edges", selected(selection.edges));
    t.add("selected vertices", selected(selection.vertices));
    if (!facts.only_source) {
        t.add("parallel edges", facts.mesh.parallel_edges);
        t.add("point spheres", facts.mesh.point_spheres);
        t.add("zero-thickness walls", facts.mesh.zero_thickness_walls);
        t.add("self-intersections", met_text(met));
        if (facts.graph) add_graph(t, *facts.graph, "graph ");
        if (facts.pane) add_pane(t, facts.pane->own, "pane ");
        if (facts.tile) add_tile(t, *facts.tile, "tile ");
        if (facts.cell) add_cell(t, *facts.cell, "cell ");
    }
    return t.take();
}

} // namespace druse
