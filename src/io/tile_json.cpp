#include "io/tile_json.h"

#include "io/byte_sink.h"
#include "io/text_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace druse {

namespace {

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

PathFinder look_for(std::string_view text, std::string_view path)
{
    TextPlace place{text.data(), text.data(), text.data() + text.size()};
    PathFinder finder(place, path);
    nlohmann::json::sax_parse(TextWalk(place, text.data()), TextWalk(place, text.data() + text.size()), &finder);
    return finder;
}

void put_json(const TileJson& j, ByteSink& sink)
{
    char before = j.is_object() ? '{' : '[';
    switch (j.type()) {
    case TileJson::value_t::number_float: {
        const auto x = j.get<double>();
        if (x == 0 && std::signbit(x)) sink.put("-0.0"); // a reader may take -0 for a whole number, which has no sign then
        else sink.put(x);
        return;
    }
    case TileJson::value_t::array:
        for (const TileJson& item : j) {
            sink.put(before);
            if (before == ',') sink.put(' ');
            put_json(item, sink);
            before = ',';
        }
        if (before == '[') sink.put('[');
        sink.put(']');
        return;
    case TileJson::value_t::object:
        for (const auto& [key, value] : j.items()) {
            sink.put(before);
            if (before == ',') sink.put(' ');
            sink.put(TileJson(key).dump());
            sink.put(": ");
            put_json(value, sink);
            before = ',';
        }
        if (before == '{') sink.put('{');
        sink.put('}');
        return;
    default: sink.put(j.dump()); return;
    }
}

} // namespace

TileJsonFile::TileJsonFile(std::string_view text, std::string file) : text_(text), file_(std::move(file))
{
    if (look_for(text_, "").is_too_deep()) throw InputError(file_, fmt::format("lists in lists, more than {} deep", deepest_tile_value));
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
    if (text_at("format") != "druse-tile") fail("format", R"(expected "druse-tile")");
    const double version = number_at(json_, "version", "version", {});
    if (version > tile_version) fail("version", fmt::format("{} is of a newer Druse: this one reads up to {}", version, tile_version));
    if (version != tile_version) fail("version", fmt::format("expected {}", tile_version));
    if (kind() != "layered" && kind() != "cell") fail("kind", R"(expected "layered" or "cell")");
    if (json_.contains("units") && text_at("units") != "mm") fail("units", R"(expected "mm")");
}

long TileJsonFile::line_of(std::string_view path) const { return look_for(text_, path).line(); }

/// A key that is missing is missed on the line of what should hold it.
void TileJsonFile::fail(const std::string& path, const std::string& what) const
{
    std::string holder = path;
    long line = line_of(holder);
    while (line == 0 && !holder.empty()) {
        const std::size_t cut = holder.find_last_of(".[");
        holder.resize(cut == std::string::npos ? 0 : cut);
        line = line_of(holder);
    }
    throw InputError(file_, std::max(line, 1L), path + ": " + what);
}

double TileJsonFile::number(const TileJson& j, const std::string& path) const
{
    if (!j.is_number()) fail(path, "expected a number");
    const auto x = j.get<double>();
    if (!(std::abs(x) <= 1e100)) fail(path, "numbers go to 1e100");
    return x;
}

double TileJsonFile::number_at(const TileJson& j, const char* key, const std::string& path, std::optional<double> otherwise) const
{
    if (j.contains(key)) return number(j[key], path);
    if (!otherwise) fail(path, "is missing");
    return *otherwise;
}

int TileJsonFile::count(const TileJson& j, const std::string& path) const
{
    const double x = number(j, path);
    if (!(x >= 0 && x <= 1e9 && x == std::floor(x))) fail(path, "expected a whole number, 0 or above");
    return static_cast<int>(x);
}

std::string TileJsonFile::text(const TileJson& j, const std::string& path) const
{
    if (!j.is_string()) fail(path, "expected a text");
    return j.get<std::string>();
}

std::string TileJsonFile::text_at(const std::string& key) const
{
    if (!json_.contains(key)) fail(key, "is missing");
    return text(json_[key], key);
}

Point2 TileJsonFile::pair(const TileJson& j, const std::string& path) const
{
    if (!j.is_array() || j.size() != 2) fail(path, "expected 2 numbers");
    return {number(j[0], path + "[0]"), number(j[1], path + "[1]")};
}

std::vector<Point2> TileJsonFile::pairs(const TileJson& j, const std::string& path) const
{
    std::vector<Point2> points;
    for (std::size_t i = 0; i < list(j, path).size(); ++i) points.push_back(pair(j[i], fmt::format("{}[{}]", path, i)));
    return points;
}

const TileJson& TileJsonFile::list(const TileJson& j, const std::string& path) const
{
    if (!j.is_array()) fail(path, "expected a list");
    return j;
}

const TileJson& TileJsonFile::object(const TileJson& j, const std::string& path) const
{
    if (!j.is_object()) fail(path, "expected an object");
    return j;
}

TileJson pair_json(const Point2& p) { return TileJson::array({p.x, p.y}); }

TileJson pairs_json(const std::vector<Point2>& points)
{
    TileJson list = TileJson::array();
    for (const Point2& p : points) list.push_back(pair_json(p));
    return list;
}

/// An object that is there already keeps its other keys, and their order.
TileJson& object_in(TileJson& parent, const char* key)
{
    TileJson& value = parent[key];
    if (!value.is_object()) value = TileJson::object();
    return value;
}

void put_tile(const TileJson& tree, ByteSink& sink)
{
    const char* before = "{ ";
    for (const auto& [key, value] : tree.items()) {
        sink.put(before);
        sink.put(TileJson(key).dump());
        sink.put(": ");
        put_json(value, sink);
        before = ",\n  ";
    }
    sink.put(" }\n");
}

} // namespace druse
