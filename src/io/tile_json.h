#pragma once

#include "dlfl/errors.h"
#include "geom/point.h"
#include "io/keyed_map.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace druse {

class ByteSink;

using TileJson = nlohmann::basic_json<KeyedMap>;

/// A `.tile` file of any kind as a tree, whose values are asked for by path, as `paths[1].points[0]`. What is not as it should be is an InputError with the line on
/// which it stands. The text must outlive it.
class TileJsonFile {
public:
    /// @throws InputError where the text is no JSON, is nested too deep, or is no `.tile` file of a version that this program reads
    TileJsonFile(std::string_view text, std::string file);

    const TileJson& json() const { return json_; }
    const std::string& file() const { return file_; }
    /// What kind of tile it is: `layered` or `cell`.
    std::string kind() const { return text_at("kind"); }

    [[noreturn]] void fail(const std::string& path, const std::string& what) const;
    /// Where no single value is at fault.
    [[noreturn]] void fail(const std::string& what) const { throw InputError(file_, what); }
    double number(const TileJson& j, const std::string& path) const; // as far as 1e100
    double number_at(const TileJson& j, const char* key, const std::string& path, std::optional<double> otherwise) const;
    int count(const TileJson& j, const std::string& path) const; // a whole number, 0 or above
    std::string text(const TileJson& j, const std::string& path) const;
    std::string text_at(const std::string& key) const;
    Point2 pair(const TileJson& j, const std::string& path) const;
    std::vector<Point2> pairs(const TileJson& j, const std::string& path) const;
    const TileJson& list(const TileJson& j, const std::string& path) const;
    const TileJson& object(const TileJson& j, const std::string& path) const;

    /// Runs f; what it refuses is the fault of the value at a path.
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

private:
    long line_of(std::string_view path) const; // 0: there is no such value

    std::string_view text_;
    std::string file_;
    TileJson json_;
};

TileJson pair_json(const Point2& p);
TileJson pairs_json(const std::vector<Point2>& points);
/// An object that is there already keeps its other keys, and their order.
TileJson& object_in(TileJson& parent, const char* key);

/// Writes an object, a line for each of its keys; numbers are the shortest that read back as the same.
void put_tile(const TileJson& tree, ByteSink& sink);

} // namespace druse
