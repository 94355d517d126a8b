#include "io/tile_file.h"

#include "dlfl/errors.h"
#include "io/text_walk.h"
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

using TileJson = nlohmann::ordered_json;

constexpr std::uint64_t largest_tile_file = 1u << 30;
constexpr std::size_t deepest_tile_value = 64; // of lists and objects in each other
constexpr int tile_version = 1;

/// Looks for the line on which the value at a path of keys begins, by reading the text once more; and refuses values too deep in each other.
class PathFinder {
public:
    PathFinder(const TextPlace& place, std::string_view wanted) : place_(place), wanted_(wanted) {}
    long line() const { return found_; }
    bool is_too_deep() const { return deepest_ > deepest_tile_value; }

    bool null() { return value(); }
    bool boolean(bool) { return value(); }
    bool number_integer(std::int64_t) { return value(); }
    bool number_unsigned(std::uint64_t) { return value(); }
    bool number_float(double, const std::string&) { return value(); }
    bool string(const std::string&) { return value(); }
    bool binary(const nlohmann::json::binary_t&) { return value(); }
    bool start_object(std::size_t) { return open(false); }
    bool start_array(std::size_t) { return open(true); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }
    bool key(const std::string& name)
    {
        levels_.back().key = name;
        return true;
    }
    template <class Error>
    bool parse_error(std::size_t, const std::string&, const Error&)
    {
        return false;
    }

private:
    struct Level {
        bool is_list = false;
        std::size_t count = 0;
        std::string key;
    };

    bool value()
    {
        if (!levels_.empty() && levels_.back().is_list) levels_.back().key = fmt::format("[{}]", levels_.back().count++);
        std::string path;
        for (const Level& level : levels_) path += level.is_list || path.empty() ? level.key : "." + level.key;
        if (found_ == 0 && path == wanted_ && !wanted_.empty()) found_ = place_.line();
        return true;
    }
    bool open(bool is_list)
    {
        value();
        levels_.push_back({is_list, 0, {}});
        deepest_ = std::max(deepest_, levels_.size());
        return deepest_ <= deepest_tile_value;
    }
    bool close()
    {
        levels_.pop_back();
        return true;
    }

    const TextPlace& place_;
    std::string_view wanted_;
    std::vector<Level> levels_;
    std::size_t deepest_ = 0;
    long found_ = 0;
};

/// A tile file as a tree, whose values are asked for by path.
class TileFileReader {
public:
    TileFileReader(std::string_view text, std::string file) : text_(text), file_(std::move(file))
    {
        if (find("").is_too_deep()) throw InputError(file_, fmt::format("lists in lists, more than {} deep", deepest_tile_value));
        try {
            json_ = TileJson::parse(text.begin(), text.end());
        } catch (const TileJson::parse_error& error) {
            const std::size_t at = std::min(error.byte, text.size());
            const long line = 1 + static_cast<long>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at > 0 ? at - 1 : 0), '\n'));
            throw InputError(file_, line, at >= text.size() ? "ends where more of its JSON should be" : "is no JSON from here on");
        } catch (const TileJson::exception&) {
            throw InputError(file_, "a number that is too large");
        }
        if (!json_.is_object()) throw InputError(file_, "expected an object of JSON");
    }

    LayeredTile read()
    {
        if (text_at("format") != "druse-tile") fail("format", R"(expected "druse-tile")");
        const double version = number_at(json_, "version", "version", {});
        if (version > tile_version) fail("version", fmt::format("{} is of a newer Druse: this one reads up to {}", version, tile_version));
        if (version != tile_version) fail("version", fmt::format("expected {}", tile_version));
        if (text_at("kind") != "layered") fail("kind", R"(expected "layered")");
        if (json_.contains("units") && text_at("units") != "mm") fail("units", R"(expected "mm")");

        TileDesign design;
        const IsohedralType& type = read_type(design);
        design.size = number_at(json_, "size", "size", {});
        if (!(design.size > 0)) fail("size", "expected above 0");
        design.rotation = number_at(json_, "rotation", "rotation", 0.0);
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
    PathFinder find(std::string_view path) const
    {
        TextPlace place{text_.data(), text_.data(), text_.data() + text_.size()};
        PathFinder finder(place, path);
        nlohmann::json::sax_parse(TextWalk(place, text_.data()), TextWalk(place, text_.data() + text_.size()), &finder);
        return finder;
    }

    [[noreturn]] void fail(const std::string& path, const std::string& what) const
    {
        // A key that is missing is missed on the line of what should hold it.
        std::string holder = path;
        long line = find(holder).line();
        while (line == 0 && !holder.empty()) {
            const std::size_t cut = holder.find_last_of(".[");
            holder.resize(cut == std::string::npos ? 0 : cut);
            line = find(holder).line();
        }
        throw InputError(file_, std::max(line, 1L), path + ": " + what);
    }

    template <class F>
    void at(const std::string& path, F&& f) const
    {
        try {
            f();
        } catch (const InputError&) {
            throw;
        } catch (const CommandError& error) {
            fail(path, error.what());
        }
    }

    double number(const TileJson& j, const std::string& path) const
    {
        if (!j.is_number()) fail(path, "expected a number");
        const auto x = j.get<double>();
        if (!(std::abs(x) <= 1e100)) fail(path, "numbers go to 1e100");
        return x;
    }
    double number_at(const TileJson& j, const char* key, const std::string& path, std::optional<double> otherwise) const
    {
        if (j.contains(key)) return number(j[key], path);
        if (!otherwise) fail(path, "is missing");
        return *otherwise;
    }
    std::string text_at(const std::string& key) const
    {
        if (!json_.contains(key)) fail(key, "is missing");
        if (!json_[key].is_string()) fail(key, "expected a text");
        return json_[key].get<std::string>();
    }
    Point2 pair(const TileJson& j, const std::string& path) const
    {
        if (!j.is_array() || j.size() != 2) fail(path, "expected 2 numbers");
        return {number(j[0], path + "[0]"), number(j[1], path + "[1]")};
    }
    std::vector<Point2> pairs(const TileJson& j, const std::string& path) const
    {
        if (!j.is_array()) fail(path, "expected a list");
        std::vector<Point2> points;
        for (std::size_t i = 0; i < j.size(); ++i) points.push_back(pair(j[i], fmt::format("{}[{}]", path, i)));
        return points;
    }
    const TileJson& list_at(const char* key) const
    {
        if (!json_[key].is_array()) fail(key, "expected a list");
        return json_[key];
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
        const TileJson& list = list_at("params");
        for (std::size_t i = 0; i < list.size(); ++i) design.parameters.push_back(number(list[i], fmt::format("params[{}]", i)));
        at("params", [&] { type.corners_of(design.parameters); });
    }

    void read_paths(const IsohedralType& type, TileDesign& design) const
    {
        design.paths.resize(type.shapes.size());
        if (!json_.contains("paths")) return;
        const TileJson& list = list_at("paths");
        if (list.size() != type.shapes.size()) fail("paths", fmt::format("{} has {} of them ({}), not {}", type.name(), type.shapes.size(), type.shape_text(), list.size()));
        for (std::size_t p = 0; p < list.size(); ++p) {
            const std::string path = fmt::format("paths[{}]", p);
            if (!list[p].is_object()) fail(path, "expected an object");
            const std::string shape(1, letter(type.shapes[p]));
            if (list[p].contains("shape") && list[p]["shape"] != shape) fail(path + ".shape", fmt::format("expected \"{}\" of {}", shape, type.name()));
            if (list[p].contains("points")) design.paths[p] = pairs(list[p]["points"], path + ".points");
            at(path + ".points", [&] { check_path(type, static_cast<int>(p), design.paths[p]); });
        }
    }

    void read_segments(TileDesign& design) const
    {
        if (!json_.contains("segments")) return;
        const TileJson& list = list_at("segments");
        for (std::size_t s = 0; s < list.size(); ++s) {
            const std::string path = fmt::format("segments[{}]", s);
            if (!list[s].is_array() || list[s].size() < 2) fail(path, "expected 2 names of points, or more");
            auto& chain = design.segments.emplace_back();
            for (std::size_t i = 0; i < list[s].size(); ++i) {
                const std::string place = fmt::format("{}[{}]", path, i);
                if (!list[s][i].is_string()) fail(place, "expected a name of a point");
                at(place, [&] { chain.push_back(PointName::parse(list[s][i].get<std::string>())); });
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
        if (design.stack.mode == TileStack::Mode::column) return;
        if (stack.contains("offset")) design.stack.offset = pair(stack["offset"], "stack.offset");
        if (design.stack.mode == TileStack::Mode::mirror) design.stack.axis = number_at(stack, "axis", "stack.axis", 0.0);
    }

    /// How it is drawn stays in what is kept. The picture itself is not looked at: a tile whose picture is gone is a tile still.
    void check_view()
    {
        if (!json_.contains("view")) return;
        TileJson& view = json_["view"];
        if (!view.is_object()) fail("view", "expected an object");
        if (view.contains("trace")) check_trace_at(view["trace"]);
        if (!view.contains("colors")) return;
        const TileJson& list = view["colors"];
        if (!list.is_array() || list.size() != TileLook().colours.size()) fail("view.colors", "expected 3 colours");
        for (std::size_t i = 0; i < list.size(); ++i)
            if (!list[i].is_string() || !colour_from_hex(list[i].get<std::string>())) fail(fmt::format("view.colors[{}]", i), "expected a colour as \"#cc3333\"");
    }

    /// Within the program the picture has its full name.
    void check_trace_at(TileJson& j)
    {
        TileTrace trace;
        if (!j.is_object()) fail("view.trace", "expected an object");
        if (!j.contains("image") || !j["image"].is_string()) fail("view.trace.image", "expected a name of a file");
        j["image"] = (std::filesystem::absolute(file_).parent_path() / j["image"].get<std::string>()).lexically_normal().string();
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
        throw InputError(file_, "makes no tile");
    }

    std::string_view text_;
    std::string file_;
    TileJson json_;
};

} // namespace

Model read_tile(ByteSource& source)
{
    const std::vector<char> bytes = source.read_all(largest_tile_file);
    std::string_view text(bytes.data(), bytes.size());
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    Model model;
    model.tile.emplace(TileFileReader(text, source.name()).read());
    return model;
}

} // namespace druse
