#include "io/tile_file.h"

#include "dlfl/errors.h"
#include "io/cell_file.h"
#include "io/tile_json.h"
#include "tile/tile_look.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace druse {

namespace {

constexpr std::uint64_t largest_tile_file = 1u << 30;

/// A file of a layered tile.
class TileFileReader : TileJsonFile {
public:
    explicit TileFileReader(TileJsonFile&& file) : TileJsonFile(std::move(file)), json_(json()) {}

    LayeredTile read()
    {
        TileDesign design;
        const IsohedralType& type = read_type(design);
        design.size = number_at(json_, "size", "size", {});
        if (!(design.size > 0)) fail("size", "expected above 0");
        design.rotation = turn_at(json_, "rotation", "rotation");
        if (json_.contains("origin")) design.origin = pair(json_["origin"], "origin");
        read_parameters(type, design);
        read_paths(type, design);
        if (json_.contains("interior")) design.interior = pairs(json_["interior"], "interior");
        read_segments(design);
        if (json_.contains("thickness")) {
            design.thickness = number_at(json_, "thickness", "thickness", {});
            if (!(*design.thickness > 0)) fail("thickness", "expected above 0");
        }
        read_heights(design);
        read_stack(design);
        check_view();
        design.kept = kept().dump();
        return made(std::move(design));
    }

private:
    /// Degrees, as operators take them.
    double turn_at(const TileJson& j, const char* key, const std::string& path) const
    {
        const double turn = number_at(j, key, path, 0.0);
        if (!(std::abs(turn) <= 360)) fail(path, "expected -360 to 360 degrees");
        return turn;
    }

    const IsohedralType& read_type(TileDesign& design) const
    {
        const std::string name = text_at("type");
        int number = 0;
        for (std::size_t i = 2; i < name.size() && i < 4; ++i) number = name[i] >= '0' && name[i] <= '9' ? 10 * number + (name[i] - '0') : -1000;
        if (name.size() != 4 || !name.starts_with("IH") || number < 1) fail("type", fmt::format("'{}' is no type: they are IH01 to IH93", name));
        design.type = number;
        at("type", [&] { isohedral_type(number); });
        return isohedral_type(number);
    }

    void read_parameters(const IsohedralType& type, TileDesign& design) const
    {
        if (!json_.contains("params")) {
            design.parameters = type.default_parameters();
            return;
        }
        const TileJson& items = list(json_["params"], "params");
        for (std::size_t i = 0; i < items.size(); ++i) design.parameters.push_back(number(items[i], fmt::format("params[{}]", i)));
        at("params", [&] { type.corners_of(design.parameters); });
    }

    void read_paths(const IsohedralType& type, TileDesign& design) const
    {
        design.paths.resize(type.shapes.size());
        if (!json_.contains("paths")) return;
        const TileJson& items = list(json_["paths"], "paths");
        if (items.size() != type.shapes.size()) fail("paths", fmt::format("{} has {} of them ({}), not {}", type.name(), type.shapes.size(), type.shape_text(), items.size()));
        for (std::size_t p = 0; p < items.size(); ++p) {
            const std::string path = fmt::format("paths[{}]", p);
            if (!items[p].is_object()) fail(path, "expected an object");
            const std::string shape(1, letter(type.shapes[p]));
            if (items[p].contains("shape") && items[p]["shape"] != shape) fail(path + ".shape", fmt::format("expected \"{}\" of {}", shape, type.name()));
            if (items[p].contains("points")) design.paths[p] = pairs(items[p]["points"], path + ".points");
            at(path + ".points", [&] { check_path(type, static_cast<int>(p), design.paths[p]); });
        }
    }

    void read_segments(TileDesign& design) const
    {
        if (!json_.contains("segments")) return;
        const TileJson& items = list(json_["segments"], "segments");
        for (std::size_t s = 0; s < items.size(); ++s) {
            const std::string path = fmt::format("segments[{}]", s);
            if (!items[s].is_array() || items[s].size() < 2) fail(path, "expected 2 names of points, or more");
            auto& chain = design.segments.emplace_back();
            for (std::size_t i = 0; i < items[s].size(); ++i) {
                const std::string place = fmt::format("{}[{}]", path, i);
                if (!items[s][i].is_string()) fail(place, "expected a name of a point");
                at(place, [&] { chain.push_back(PointName::parse(items[s][i].get<std::string>())); });
            }
        }
    }

    void read_heights(TileDesign& design) const
    {
        if (!json_.contains("heights")) return;
        if (!json_["heights"].is_object()) fail("heights", "expected an object");
        for (const auto& [key, value] : json_["heights"].items()) {
            const std::string path = "heights." + key;
            at(path, [&] {
                const PointName name = PointName::parse(key);
                design.heights[name] = number(value, path);
            });
        }
    }

    void read_stack(TileDesign& design) const
    {
        if (!json_.contains("stack")) return;
        const TileJson& stack = json_["stack"];
        if (!stack.is_object()) fail("stack", "expected an object");
        static constexpr std::array modes{"column", "shift", "mirror", "free"};
        const std::string mode = stack.contains("mode") && stack["mode"].is_string() ? stack["mode"].get<std::string>() : "";
        const auto found = std::ranges::find(modes, mode);
        if (found == modes.end()) fail("stack.mode", R"(expected "column", "shift", "mirror" or "free")");
        design.stack.mode = static_cast<TileStack::Mode>(found - modes.begin());
        // As tile.stack has it.
        const auto unused = [&](const char* key) {
            if (stack.contains(key)) fail(fmt::format("stack.{}", key), fmt::format("mode={} does not use it", mode));
        };
        if (design.stack.mode == TileStack::Mode::column) unused("offset");
        else if (stack.contains("offset")) design.stack.offset = pair(stack["offset"], "stack.offset");
        if (design.stack.mode == TileStack::Mode::mirror) design.stack.axis = turn_at(stack, "axis", "stack.axis");
        else unused("axis");
    }

    /// How it is drawn stays in what is kept. The picture itself is not looked at: a tile whose picture is gone is a tile still.
    void check_view() const
    {
        if (!json_.contains("view")) return;
        const TileJson& view = object(json_["view"], "view");
        if (view.contains("trace")) check_trace_at(object(view["trace"], "view.trace"));
        if (!view.contains("colors")) return;
        const TileJson& colours = view["colors"];
        if (!colours.is_array() || colours.size() != TileLook().colours.size()) fail("view.colors", "expected 3 colours");
        for (std::size_t i = 0; i < colours.size(); ++i)
            if (!colours[i].is_string() || !colour_from_hex(colours[i].get<std::string>()))
                fail(fmt::format("view.colors[{}]", i), "expected a colour as \"#cc3333\"");
    }

    void check_trace_at(const TileJson& j) const
    {
        TileTrace trace;
        if (!j.contains("image") || !j["image"].is_string()) fail("view.trace.image", "expected a name of a file");
        const double opacity = number_at(j, "opacity", "view.trace.opacity", trace.opacity);
        if (!(opacity >= 0 && opacity <= 1)) fail("view.trace.opacity", "expected 0 to 1");
        if (!j.contains("place")) return;
        const TileJson& place = j["place"];
        if (!place.is_array() || place.size() != trace.place.size()) fail("view.trace.place", "expected 6 numbers");
        for (std::size_t i = 0; i < place.size(); ++i) trace.place[i] = number(place[i], fmt::format("view.trace.place[{}]", i));
        at("view.trace.place", [&] { check_trace(trace); });
    }

    /// The file without what the tile tells, but for the order of its keys.
    TileJson kept() const
    {
        TileJson rest = json_;
        for (const char* key : {"format", "version", "kind", "units", "type", "size", "rotation", "origin", "params", "interior", "segments", "thickness", "heights"})
            if (rest.contains(key)) rest[key] = nullptr;
        if (rest.contains("paths"))
            for (TileJson& path : rest["paths"]) {
                path["shape"] = nullptr;
                path["points"] = nullptr;
            }
        if (rest.contains("view") && rest["view"].contains("trace")) { // within the program the picture has its full name
            TileJson& image = rest["view"]["trace"]["image"];
            image = (std::filesystem::absolute(file()).parent_path() / image.get<std::string>()).lexically_normal().string();
        }
        return rest;
    }

    /// The tile, or which part of the design is none of one.
    LayeredTile made(TileDesign design) const
    {
        std::optional<LayeredTile> whole;
        try {
            whole.emplace(design);
        } catch (const CommandError&) {
        }
        if (whole) {
            for (const auto& [name, height] : design.heights) at("heights." + name.text(), [&] { whole->find(name); });
            return std::move(*whole);
        }
        TileDesign part = design;
        part.interior.clear();
        part.segments.clear();
        part.heights.clear();
        part.stack = {};
        at(design.parameters.empty() ? "paths" : "params", [&] { // straight edges tell parameters that make no tile
            TileDesign straight = part;
            for (auto& points : straight.paths) points.clear();
            const LayeredTile trial(std::move(straight));
        });
        at("paths", [&] { const LayeredTile trial(part); });
        part.stack = design.stack;
        at(design.stack.mode == TileStack::Mode::mirror ? "stack" : "stack.offset", [&] { const LayeredTile trial(part); });
        part.interior = design.interior;
        at("interior", [&] { const LayeredTile trial(part); });
        for (std::size_t s = 0; s < design.segments.size(); ++s) {
            TileDesign one = part;
            one.segments = {design.segments[s]};
            at(fmt::format("segments[{}]", s), [&] { const LayeredTile trial(std::move(one)); });
        }
        part.segments = design.segments;
        for (const auto& [name, height] : design.heights) {
            part.heights[name] = height;
            at("heights." + name.text(), [&] { LayeredTile(part).find(name); });
        }
        at("segments", [&] { const LayeredTile trial(design); });
        fail("makes no tile");
    }

    const TileJson& json_;
};

std::string_view text_of(const std::vector<char>& bytes)
{
    const std::string_view text(bytes.data(), bytes.size());
    return text.substr(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
}

} // namespace

bool is_cell_file(const std::filesystem::path& file)
{
    try {
        ByteSource source = ByteSource::file(file);
        const std::vector<char> bytes = source.read_all(largest_tile_file);
        return TileJsonFile(text_of(bytes), source.name()).kind() == "cell";
    } catch (const InputError&) {
        return false;
    }
}

Model read_tile(ByteSource& source)
{
    const std::vector<char> bytes = source.read_all(largest_tile_file);
    Model model;
    TileJsonFile file(text_of(bytes), source.name());
    if (file.kind() == "cell") model.cell.emplace(read_cell(file));
    else model.tile.emplace(TileFileReader(std::move(file)).read());
    return model;
}

} // namespace druse
