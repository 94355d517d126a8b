#include "ops/tile_parameters.h"

#include "ops/scene.h"
#include "tile/layered_tile.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace druse {

namespace {

constexpr std::array point_words{"all", "outline", "interior", "selected", "none"};

bool is_point_word(std::string_view t) { return std::ranges::find(point_words, t) != point_words.end(); }

} // namespace

TileTypeNumber ParameterType<TileTypeNumber>::parse(std::string_view t, const Domain&)
{
    std::string_view digits = t;
    if (digits.size() > 2 && lower_case(std::string(digits.substr(0, 2))) == "ih") digits.remove_prefix(2);
    if (digits.empty() || digits.size() > 2 || digits.find_first_not_of("0123456789") != std::string_view::npos) throw CommandError("expected a type, IH01 to IH93");
    const int number = static_cast<int>(parse_integer(digits));
    isohedral_type(number);
    return {number};
}

std::string ParameterType<TileTypeNumber>::text(TileTypeNumber x, const Domain&) { return isohedral_type(x.number).name(); }

TilePoints ParameterType<TilePoints>::parse(std::string_view t, const Domain&)
{
    TilePoints points;
    for (const std::string_view piece : split(t, ',')) {
        if (!is_point_word(piece)) PointName::parse(piece);
        points.words.emplace_back(piece);
    }
    return points;
}

std::string ParameterType<TilePoints>::text(const TilePoints& x, const Domain&)
{
    std::string text;
    for (const std::string& word : x.words) text.append(text.empty() ? "" : ",").append(word);
    return text;
}

std::vector<int> TilePoints::resolve(const LayeredTile& tile, const Selection& selection) const
{
    std::vector<int> points;
    const auto add = [&](int from, int to) {
        for (int i = from; i < to; ++i) points.push_back(i);
    };
    for (const std::string& word : words) {
        if (word == "none") continue;
        if (word == "all") add(0, tile.point_count());
        else if (word == "outline") add(0, tile.outline_count());
        else if (word == "interior") add(tile.outline_count(), tile.point_count());
        else if (word == "selected") {
            const std::size_t before = points.size();
            for (const Vertex v : selection.vertices)
                if (v.index < static_cast<std::uint32_t>(tile.point_count())) points.push_back(static_cast<int>(v.index));
            if (points.size() == before) throw CommandError("points=selected: no points of the tile are selected");
        } else {
            points.push_back(tile.find(PointName::parse(word)));
        }
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

} // namespace druse
