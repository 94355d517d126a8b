#include "io/tile_file.h"

#include "dlfl/errors.h"
#include "io/cell_file.h"
#include "io/tile_json.h"
#include "tile/tile_look.h"

#include <fmt/format.h>

#include <filesystem>
#include <string>

namespace druse {

namespace {

/// A file beside the one that is written is named from there, so that both can be moved together.
std::string beside(const std::string& file, const std::string& written)
{
    namespace fs = std::filesystem;
    const fs::path name = fs::path(file).lexically_proximate(fs::absolute(written).lexically_normal().parent_path());
    return name.begin() == name.end() || *name.begin() == ".." ? file : name.generic_string();
}

TileJson json_of(const LayeredTile& tile, const std::string& written)
{
    const TileDesign& design = tile.design();
    TileJson j = design.kept.empty() ? TileJson::object() : TileJson::parse(design.kept);
    j["format"] = "druse-tile";
    j["version"] = 1;
    j["kind"] = "layered";
    j["units"] = "mm";
    j["type"] = tile.type().name();
    j["size"] = design.size;
    j["rotation"] = design.rotation;
    j["origin"] = pair_json(design.origin);
    j["params"] = design.parameters;
    TileJson& paths = j["paths"];
    if (!paths.is_array() || paths.size() != design.paths.size()) paths = TileJson(design.paths.size(), TileJson::object());
    for (std::size_t p = 0; p < design.paths.size(); ++p) {
        if (!paths[p].is_object()) paths[p] = TileJson::object();
        paths[p]["shape"] = std::string(1, letter(tile.type().shapes[p]));
        paths[p]["points"] = pairs_json(design.paths[p]);
    }
    j["interior"] = pairs_json(design.interior);
    TileJson& segments = j["segments"] = TileJson::array();
    for (const auto& chain : design.segments) {
        TileJson& names = segments.emplace_back(TileJson::array());
        for (const PointName& name : chain) names.push_back(name.text());
    }
    if (design.thickness) j["thickness"] = *design.thickness;
    else j.erase("thickness");
    TileJson& heights = j["heights"] = TileJson::object();
    for (int i = 0; i < tile.point_count(); ++i)
        if (const auto found = design.heights.find(tile.name(i)); found != design.heights.end()) heights[found->first.text()] = found->second;
    TileJson& stack = object_in(j, "stack");
    static constexpr const char* modes[] = {"column", "shift", "mirror", "free"};
    stack["mode"] = modes[static_cast<int>(design.stack.mode)];
    if (design.stack.mode == TileStack::Mode::column) stack.erase("offset");
    else stack["offset"] = pair_json(design.stack.offset);
    if (design.stack.mode == TileStack::Mode::mirror) stack["axis"] = design.stack.axis;
    else stack.erase("axis");
    if (const TileLook drawn = look(design); drawn.trace) j["view"]["trace"]["image"] = beside(drawn.trace->image, written);
    return j;
}

} // namespace

void write_tile(const ModelView& model, OutputFiles& out)
{
    if (!model.tile && !model.cell) throw InputError(out.name(), "the document holds no tile to write");
    put_tile(model.tile ? json_of(*model.tile, out.name()) : cell_json(*model.cell), out.main());
}

} // namespace druse
