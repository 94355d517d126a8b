#pragma once

// How types and points of a tile are parameters.

#include "ops/pane_parameters.h"
#include "tile/point_name.h"

#include <string>
#include <vector>

namespace druse {

class LayeredTile;
struct Selection;

/// A type of isohedral tiling, IH01 to IH93.
struct TileTypeNumber {
    int number = 1;
};
template <>
struct ParameterType<TileTypeNumber> {
    static constexpr auto type = Parameter::Type::text;
    static TileTypeNumber parse(std::string_view t, const Domain& d);
    static std::string text(TileTypeNumber x, const Domain& d);
};

template <>
struct ParameterType<PointName> {
    static constexpr auto type = Parameter::Type::text;
    static PointName parse(std::string_view t, const Domain&) { return PointName::parse(t); }
    static std::string text(const PointName& x, const Domain&) { return x.text(); }
};

/// Points of a tile: names, or `all`, `outline`, `interior`, `none` and `selected`, which are the selected vertices of the mesh that tile.solid made, by number.
struct TilePoints {
    std::vector<std::string> words;

    /// @throws CommandError where there is no such point
    std::vector<int> resolve(const LayeredTile& tile, const Selection& selection) const;
};
template <>
struct ParameterType<TilePoints> {
    static constexpr auto type = Parameter::Type::texts;
    static TilePoints parse(std::string_view t, const Domain& d);
    static std::string text(const TilePoints& x, const Domain& d);
};

} // namespace druse
