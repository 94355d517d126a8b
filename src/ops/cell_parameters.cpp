#include "ops/cell_parameters.h"

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

std::vector<int> CellPoints::resolve(const CellTile& tile, const Selection& selection) const
{
    std::vector<int> points;
    for (const std::string& word : words) {
        if (word == "selected") {
            std::vector<int> of_vertex; // in the order of make_solid()
            for (int i = 0; i < tile.point_count(); ++i) of_vertex.insert(of_vertex.end(), tile.members(i).size(), i);
            const std::size_t before = points.size();
            for (const Vertex v : selection.vertices)
                if (v.index < of_vertex.size()) points.push_back(of_vertex[v.index]);
            if (points.size() == before) throw CommandError("points=selected: no points of the cell are selected");
        } else if (is_cell_word(word)) {
            for (int i = 0; i < tile.point_count(); ++i)
                if (word == "all" || (word == "interior" && tile.pane_of(i) >= 0) || (word == "outline" && tile.pane_of(i) < 0)) points.push_back(i);
        } else {
            points.push_back(tile.find(CellPointName::parse(word)));
        }
    }
    return points;
}

} // namespace druse
