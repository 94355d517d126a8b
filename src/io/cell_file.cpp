#include "io/cell_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>

namespace druse {

namespace {

constexpr std::array cell_kinds{CellKind::bcc, CellKind::fcc, CellKind::cube, CellKind::hexprism, CellKind::elongated};

/// The parts of a CellDesign, each from its key.
class CellFileReader {
public:
    explicit CellFileReader(const TileJsonFile& file) : file_(file), json_(file.json()) {}

    CellTile read()
    {
        CellDesign design;
        const std::string kind = file_.text_at("cell");
        const auto found = std::ranges::find_if(cell_kinds, [&](CellKind k) { return name(k) == kind; });
        if (found == cell_kinds.end()) file_.fail("cell", fmt::format("'{}' is no cell: they are bcc, fcc, cube, hexprism and elongated", kind));
        design.cell = *found;
        design.size = file_.number_at(json_, "size", "size", {});
        if (!(design.size > 0)) file_.fail("size", "expected above 0");
        if (json_.contains("height")) {
            design.height = file_.number_at(json_, "height", "height", {});
            if (!(*design.height > 0)) file_.fail("height", "expected above 0");
        }
        if (json_.contains("matrix")) {
            if (file_.list(json_["matrix"], "matrix").size() != 9) file_.fail("matrix", "expected 9 numbers");
            for (std::size_t i = 0; i < 9; ++i) design.matrix[i] = file_.number(json_["matrix"][i], fmt::format("matrix[{}]", i));
        }
        const Parallelohedron cell = make_parallelohedron(design.cell, 1, 1);
        design.panes.resize(cell.panes.size());
        design.edges.resize(cell.edges.size());
        read_panes(design);
        read_edges(design);
        design.phase = json_.contains("phase") ? file_.count(json_["phase"], "phase") : 1;
        if (design.phase != 1 && design.phase != 2) file_.fail("phase", "expected 1 or 2");
        if (json_.contains("shape") && design.phase == 1) file_.fail("shape", "is of phase 2");
        if (json_.contains("shape")) read_shape(design, file_.object(json_["shape"], "shape"));
        design.kept = kept().dump();
        return made(std::move(design));
    }

private:
    CellPointName point(const TileJson& j, const std::string& path) const
    {
        CellPointName found;
        file_.at(path, [&] { found = CellPointName::parse(file_.text(j, path)); });
        return found;
    }

    void require_size(const TileJson& j, const std::string& path, std::size_t size, const char* of) const
    {
        if (file_.list(j, path).size() != size) file_.fail(path, fmt::format("there are {} {} of this cell, not {}", size, of, j.size()));
    }

    void read_panes(CellDesign& design) const
    {
        if (!json_.contains("panes")) return;
        const TileJson& panes = json_["panes"];
        require_size(panes, "panes", design.panes.size(), "pairs of panes");
        for (std::size_t p = 0; p < panes.size(); ++p) {
            const std::string path = fmt::format("panes[{}]", p);
            file_.object(panes[p], path);
            if (panes[p].contains("points")) design.panes[p].points = file_.pairs(panes[p]["points"], path + ".points");
            if (!panes[p].contains("segments")) continue;
            const TileJson& segments = file_.list(panes[p]["segments"], path + ".segments");
            for (std::size_t s = 0; s < segments.size(); ++s) {
                const std::string place = fmt::format("{}.segments[{}]", path, s);
                if (file_.list(segments[s], place).size() < 2) file_.fail(place, "expected 2 names of points, or more");
                auto& chain = design.panes[p].segments.emplace_back();
                for (std::size_t i = 0; i < segments[s].size(); ++i) chain.push_back(point(segments[s][i], fmt::format("{}[{}]", place, i)));
            }
        }
    }

    void read_edges(CellDesign& design) const
    {
        if (!json_.contains("edges")) return;
        const TileJson& edges = json_["edges"];
        require_size(edges, "edges", design.edges.size(), "orbits of edges");
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const std::string path = fmt::format("edges[{}]", e);
            for (std::size_t i = 0; i < file_.list(edges[e], path).size(); ++i) design.edges[e].push_back(file_.number(edges[e][i], fmt::format("{}[{}]", path, i)));
        }
    }

    void read_shape(CellDesign& design, const TileJson& shape) const
    {
        if (shape.contains("moved"))
            for (const auto& [key, value] : file_.object(shape["moved"], "shape.moved").items()) {
                const std::string path = "shape.moved." + key;
                CellPointName name;
                file_.at(path, [&, text = std::string_view(key)] { name = CellPointName::parse(text); });
                if (!design.moved.emplace(name, triple(value, path)).second) file_.fail(path, "is moved twice");
            }
        if (shape.contains("splits")) {
            const TileJson& splits = file_.list(shape["splits"], "shape.splits");
            for (std::size_t i = 0; i < splits.size(); ++i) design.details.push_back(detail(splits[i], fmt::format("shape.splits[{}]", i)));
        }
        if (!shape.contains("flat")) return;
        const TileJson& flat = file_.list(shape["flat"], "shape.flat");
        for (std::size_t i = 0; i < flat.size(); ++i) {
            const std::string path = fmt::format("shape.flat[{}]", i);
            if (!file_.object(flat[i], path).contains("pane")) file_.fail(path + ".pane", "is missing");
            const auto [entry, is_new] = design.flat.try_emplace(file_.count(flat[i]["pane"], path + ".pane"));
            if (!is_new) file_.fail(path + ".pane", fmt::format("{} is there twice", entry->first));
            CellDesign::Flat& its = entry->second;
            its.kept = others(flat[i], {"pane", "keep", "new"});
            if (flat[i].contains("keep")) {
                if (!flat[i]["keep"].is_boolean()) file_.fail(path + ".keep", "expected true or false");
                its.keep = flat[i]["keep"].get<bool>();
            }
            if (!flat[i].contains("new")) continue;
            const TileJson& fresh = file_.list(flat[i]["new"], path + ".new");
            for (std::size_t k = 0; k < fresh.size(); ++k) {
                const std::string place = fmt::format("{}.new[{}]", path, k);
                const CellPointName name = point(fresh[k], place);
                if (name.kind != CellPointName::Kind::interior || name.pane >= 0) file_.fail(place, "expected a point inside the pane, as \"i0\"");
                its.fresh.push_back(name.index);
            }
        }
    }

    Vector triple(const TileJson& j, const std::string& path) const
    {
        if (file_.list(j, path).size() != 3) file_.fail(path, "expected 3 numbers");
        return {file_.number(j[0], path + "[0]"), file_.number(j[1], path + "[1]"), file_.number(j[2], path + "[2]")};
    }

    CellDetail detail(const TileJson& j, const std::string& path) const
    {
        CellDetail detail;
        detail.kept = others(j, {"pane", "triangle", "at", "edge", "t", "flip"});
        if (!file_.object(j, path).contains("pane")) file_.fail(path + ".pane", "is missing");
        detail.pane = file_.count(j["pane"], path + ".pane");
        const auto ends = [&](const char* key) {
            const std::string place = path + "." + key;
            if (file_.list(j[key], place).size() != 2) file_.fail(place, "expected 2 names of points");
            detail.edge = {point(j[key][0], place + "[0]"), point(j[key][1], place + "[1]")};
        };
        if (j.contains("triangle")) {
            detail.triangle = file_.count(j["triangle"], path + ".triangle");
            if (!j.contains("at")) file_.fail(path + ".at", "is missing");
            const Vector weights = triple(j["at"], path + ".at");
            detail.at = {weights.x, weights.y, weights.z};
        } else if (j.contains("edge")) {
            detail.kind = CellDetail::Kind::edge;
            ends("edge");
            detail.t = file_.number_at(j, "t", path + ".t", {});
        } else if (j.contains("flip")) {
            detail.kind = CellDetail::Kind::flip;
            ends("flip");
        } else {
            file_.fail(path, "expected a triangle, an edge or a flip");
        }
        return detail;
    }

    /// What an object says beside what a cell reads of it; empty where that is all.
    static std::string others(const TileJson& j, std::initializer_list<const char*> known)
    {
        if (!j.is_object()) return {};
        TileJson rest = j;
        for (const char* key : known) rest.erase(key);
        return rest.empty() ? std::string() : rest.dump();
    }

    /// The file without what the cell tells, but for the order of its keys.
    TileJson kept() const
    {
        TileJson rest = json_;
        for (const char* key : {"format", "version", "kind", "units", "cell", "size", "height", "matrix", "edges", "phase"})
            if (rest.contains(key)) rest[key] = nullptr;
        if (rest.contains("panes"))
            for (TileJson& pane : rest["panes"])
                for (const char* key : {"points", "segments"})
                    if (pane.contains(key)) pane[key] = nullptr;
        if (rest.contains("shape"))
            for (const char* key : {"moved", "splits", "flat"})
                if (rest["shape"].contains(key)) rest["shape"][key] = nullptr;
        return rest;
    }

    /// The cell, or which part of the design is none of one.
    CellTile made(CellDesign design) const
    {
        try {
            return CellTile(design);
        } catch (const CommandError&) {
        }
        CellDesign part = design;
        for (auto& pane : part.panes) pane = {};
        for (auto& edge : part.edges) edge.clear();
        part.moved.clear();
        part.details.clear();
        part.flat.clear();
        part.matrix = CellDesign().matrix;
        const auto attempt = [&](const std::string& path) { file_.at(path, [&] { const CellTile trial(part); }); };
        part.height.reset();
        attempt("size");
        part.height = design.height;
        attempt("height");
        part.matrix = design.matrix;
        attempt("matrix");
        for (std::size_t e = 0; e < design.edges.size(); ++e) {
            part.edges[e] = design.edges[e];
            attempt(fmt::format("edges[{}]", e));
        }
        for (std::size_t p = 0; p < design.panes.size(); ++p) {
            part.panes[p].points = design.panes[p].points;
            attempt(fmt::format("panes[{}].points", p));
            part.panes[p].segments = design.panes[p].segments;
            attempt(fmt::format("panes[{}].segments", p));
        }
        part.flat = design.flat;
        attempt("shape.flat");
        // Of the details, the first that cannot be done.
        std::size_t good = 0, bad = design.details.size() + 1;
        while (bad - good > 1) {
            const std::size_t middle = (good + bad) / 2;
            part.details.assign(design.details.begin(), design.details.begin() + static_cast<std::ptrdiff_t>(middle));
            try {
                const CellTile trial(part);
                good = middle;
            } catch (const CommandError&) {
                bad = middle;
            }
        }
        if (bad <= design.details.size()) {
            part.details.assign(design.details.begin(), design.details.begin() + static_cast<std::ptrdiff_t>(bad));
            attempt(fmt::format("shape.splits[{}]", bad - 1));
        }
        const CellTile unmoved(part);
        for (const auto& [name, by] : design.moved)
            file_.at("shape.moved." + name.text(), [&] {
                const CellPointName its = unmoved.name(unmoved.find(name));
                if (its != name) throw CommandError("is called " + its.text() + " there");
                CellTile::check_moved(name, by);
            });
        part.moved = design.moved;
        attempt("shape.moved");
        file_.fail("makes no cell");
    }

    const TileJsonFile& file_;
    const TileJson& json_;
};

TileJson names_json(std::span<const CellPointName> names)
{
    TileJson list = TileJson::array();
    for (const CellPointName& name : names) list.push_back(name.text());
    return list;
}

/// Adds what an object of a file said beside what a cell reads of it.
void add_others(TileJson& j, const std::string& kept)
{
    if (!kept.empty()) j.update(TileJson::parse(kept));
}

TileJson detail_json(const CellDetail& detail)
{
    TileJson j = TileJson::object();
    j["pane"] = detail.pane;
    switch (detail.kind) {
    case CellDetail::Kind::triangle:
        j["triangle"] = detail.triangle;
        j["at"] = detail.at;
        break;
    case CellDetail::Kind::edge:
        j["edge"] = names_json(detail.edge);
        j["t"] = detail.t;
        break;
    case CellDetail::Kind::flip: j["flip"] = names_json(detail.edge); break;
    }
    add_others(j, detail.kept);
    return j;
}

} // namespace

CellTile read_cell(const TileJsonFile& file) { return CellFileReader(file).read(); }

TileJson cell_json(const CellTile& tile)
{
    const CellDesign design = tile.design();
    TileJson j = design.kept.empty() ? TileJson::object() : TileJson::parse(design.kept);
    j["format"] = "druse-tile";
    j["version"] = 1;
    j["kind"] = "cell";
    j["units"] = "mm";
    j["cell"] = name(design.cell);
    j["size"] = design.size;
    if (design.height) j["height"] = *design.height;
    else j.erase("height");
    j["matrix"] = design.matrix;
    TileJson& panes = j["panes"];
    if (!panes.is_array() || panes.size() != design.panes.size()) panes = TileJson(design.panes.size(), TileJson::object());
    for (std::size_t p = 0; p < design.panes.size(); ++p) {
        panes[p]["points"] = pairs_json(design.panes[p].points);
        TileJson& segments = panes[p]["segments"] = TileJson::array();
        for (const auto& chain : design.panes[p].segments) segments.push_back(names_json(chain));
    }
    TileJson& edges = j["edges"] = TileJson::array();
    for (const auto& list : design.edges) edges.push_back(list);
    j["phase"] = design.phase;
    if (design.phase == 1) {
        j.erase("shape");
        return j;
    }
    TileJson& shape = object_in(j, "shape");
    TileJson& moved = shape["moved"] = TileJson::object();
    for (const auto& [name, by] : design.moved) moved[name.text()] = {by.x, by.y, by.z};
    TileJson& splits = shape["splits"] = TileJson::array();
    for (const CellDetail& detail : design.details) splits.push_back(detail_json(detail));
    if (design.flat.empty()) {
        shape.erase("flat");
        return j;
    }
    TileJson& flat = shape["flat"] = TileJson::array();
    for (const auto& [pane, its] : design.flat) {
        TileJson& entry = flat.emplace_back(TileJson::object());
        entry["pane"] = pane;
        entry["keep"] = its.keep;
        TileJson& fresh = entry["new"] = TileJson::array();
        for (const int i : its.fresh) fresh.push_back(CellPointName::interior(-1, i).text());
        add_others(entry, its.kept);
    }
    return j;
}

} // namespace druse
