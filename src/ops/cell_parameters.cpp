#include "ops/cell_parameters.h"

#include "cell/cell_solid.h"
#include "cell/cell_tile.h"
#include "ops/scene.h"
#include "pane/name_scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace druse {

namespace {

bool is_cell_word(std::string_view t)
{
    static constexpr std::array known{"all", "outline", "interior", "selected", "none"};
    return std::ranges::find(known, t) != known.end();
}

} // namespace

SpaceVector ParameterType<SpaceVector>::parse(std::string_view t, const Domain& d)
{
    check_length(split(t, ',').size(), Range{3, 3}, "numbers");
    return {ParameterType<Vector>::parse(t, d)};
}

CellPath ParameterType<CellPath>::parse(std::string_view t, const Domain& d)
{
    CellPath path;
    const auto pieces = split(t, ',');
    check_length(pieces.size(), d.length, "names");
    for (const std::string_view piece : pieces) path.points.push_back(CellPointName::parse(piece));
    return path;
}

std::string ParameterType<CellPath>::text(const CellPath& x, const Domain&)
{
    std::string text;
    for (const CellPointName& name : x.points) text.append(text.empty() ? "" : ",").append(name.text());
    return text;
}

CellTriangle ParameterType<CellTriangle>::parse(std::string_view t, const Domain&)
{
    NameScanner scanner(t);
    const auto pane = scanner.take('p') ? scanner.take_number() : std::nullopt;
    const auto triangle = scanner.take(':') ? scanner.take_number() : std::nullopt;
    if (!pane || !triangle || !scanner.done()) throw CommandError("expected a triangle of a pane, as p3:7");
    return {*pane, *triangle};
}

std::string ParameterType<CellTriangle>::text(const CellTriangle& x, const Domain&) { return fmt::format("p{}:{}", x.pane, x.triangle); }

CellPoints ParameterType<CellPoints>::parse(std::string_view t, const Domain&)
{
    CellPoints points;
    for (const std::string_view piece : split(t, ',')) {
        if (!is_cell_word(piece)) CellPointName::parse(piece);
        points.words.emplace_back(piece);
    }
    return points;
}

std::string ParameterType<CellPoints>::text(const CellPoints& x, const Domain&)
{
    std::string text;
    for (const std::string& word : x.words) text.append(text.empty() ? "" : ",").append(word);
    return text;
}

namespace {

/// Which points the vertices of a mesh are, where it is the solid of the cell.
std::vector<OrbitMember> points_of_vertices(const CellTile& tile, const Mesh& mesh)
{
    const CellSolid solid = make_solid(tile);
    bool same = mesh.vertex_count() == solid.points.size() && mesh.face_count() == solid.triangles.size();
    for (const Vertex v : mesh.vertices()) same = same && v.index < solid.points.size() && mesh.position(v) == solid.points[v.index];
    if (!same) throw CommandError("points=selected: the mesh is not the solid of this cell as it is now: run cell.solid and select again");
    std::vector<OrbitMember> points; // in the order of make_solid()
    for (int i = 0; i < tile.point_count(); ++i)
        for (const LatticeStep& step : tile.members(i)) points.push_back({i, step});
    return points;
}

} // namespace

std::vector<OrbitMember> CellPoints::resolve(const CellTile& tile, const Mesh& mesh, const Selection& selection) const
{
    std::vector<OrbitMember> points;
    for (const std::string& word : words) {
        if (word == "selected") {
            if (selection.vertices.empty()) throw CommandError("points=selected: no points of the cell are selected");
            const std::vector<OrbitMember> of_vertex = points_of_vertices(tile, mesh);
            for (const Vertex v : selection.vertices) points.push_back(of_vertex[v.index]);
        } else if (is_cell_word(word)) {
            for (int i = 0; i < tile.point_count(); ++i)
                if (word == "all" || (word == "interior" && tile.pane_of(i) >= 0) || (word == "outline" && tile.pane_of(i) < 0)) points.push_back({i, {}});
        } else {
            points.push_back(tile.find_member(CellPointName::parse(word)));
        }
    }
    return points;
}

} // namespace druse
