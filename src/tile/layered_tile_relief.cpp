// The stack of a LayeredTile, its thickness and its heights.
#include "tile/layered_tile.h"
#include "tile/tile_stack.h"

#include <fmt/format.h>

#include <cmath>

namespace druse {

void LayeredTile::set_stack(const TileStack& stack, std::optional<double> reach)
{
    TileStack next = stack;
    std::vector<std::string> notes;
    if (!(std::abs(stack.offset.x) <= 1e100 && std::abs(stack.offset.y) <= 1e100)) throw CommandError("the offset is no place");
    if (next.mode == TileStack::Mode::column) next = {};
    if (next.mode == TileStack::Mode::shift || next.mode == TileStack::Mode::mirror) {
        const IsohedralOffsets offsets(aspects_, lattice_, stack_motion(stack));
        const Point2 nearest = offsets.any() ? offsets.nearest(stack.offset) : stack.offset;
        const double away = glm::length(nearest - stack.offset);
        if (!offsets.any() || !(away <= reach.value_or(snap())))
            throw TileRefusal(TileRefusal::Reason::offset_not_isohedral, not_isohedral_text(type_->name(), aspects_, lattice_, stack));
        if (away > 1e-12 * size()) {
            next.offset = nearest;
            notes.push_back(fmt::format("the offset was moved to {:.9g},{:.9g}, the nearest that is isohedral", nearest.x, nearest.y));
        }
    }
    design_.stack = next;
    notes_ = std::move(notes);
}

void LayeredTile::extrude(double thickness)
{
    if (!(thickness > 0 && thickness <= 1e100)) throw CommandError(fmt::format("thickness {}: expected above 0", thickness));
    design_.thickness = thickness;
    notes_.clear();
}

void LayeredTile::set_heights(std::span<const int> points, double height)
{
    change_heights(points, [height](std::size_t, double) { return height; });
}

void LayeredTile::set_heights(std::span<const int> points, std::span<const double> heights)
{
    change_heights(points, [heights](std::size_t i, double) { return heights[i]; });
}

void LayeredTile::add_heights(std::span<const int> points, double by)
{
    change_heights(points, [by](std::size_t, double height) { return height + by; });
}

/// Once for each orbit, however many of its points are given.
template <class F>
void LayeredTile::change_heights(std::span<const int> points, F&& f)
{
    if (!is_extruded()) throw TileRefusal(TileRefusal::Reason::phase, "heights come after tile.extrude");
    std::vector<int> first(static_cast<std::size_t>(outline_.orbits), -1);
    for (int i = outline_count(); i-- > 0;) first[static_cast<std::size_t>(outline_.points[i].orbit)] = i;
    std::map<PointName, double> heights;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const int point = points[i];
        const int told_by = point < outline_count() ? first[static_cast<std::size_t>(outline_.points[point].orbit)] : point;
        const double value = f(i, height(point));
        if (!(std::abs(value) <= 1e100)) throw CommandError(fmt::format("height {}: numbers go to 1e100", value));
        heights.try_emplace(name(told_by), value);
    }
    for (const auto& [name, value] : heights) {
        if (value != 0) design_.heights[name] = value;
        else design_.heights.erase(name);
    }
    notes_.clear();
    take_heights();
}

} // namespace druse
