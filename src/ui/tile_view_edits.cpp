// The commands that gestures in the plane of a tile come to.
#include "ui/tile_view.h"

#include "ui/layout.h"

#include "tile/tile_stack.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace druse::ui {

void TileView::add_point(const TileHit& at)
{
    if (at.edge >= tile_.outline) return; // the tile is another by now
    if (at.edge >= 0) {
        const Point2 &a = tile_.points[std::size_t(at.edge)].at, &b = tile_.points[std::size_t((at.edge + 1) % tile_.outline)].at;
        const Point2 foot = foot_on_piece(at.at, a, b);
        session_.run(fmt::format("tile.edge_add at={},{}", foot.x, foot.y)); // on the edge to the last bit: no bend comes of it
    } else if (at.inside) {
        session_.run("tile.point_add at=" + place_text(at.at));
    } else {
        select({});
    }
}

void TileView::move_to(const Point2& picture)
{
    const TilePoint& point = grabbed_point_;
    const Point2 at = inverse(tile_.copies[grabbed_.copy].map)(plane_.plane(picture)) + grip_;
    switch (point.kind) {
    case TilePoint::Kind::corner: drag_corner_to(at); break;
    case TilePoint::Kind::path: step_->send(fmt::format("tile.edge_move point={} to={}", point.name, place_text(at))); break;
    case TilePoint::Kind::interior: step_->send(fmt::format("tile.point_move point={} to={}", point.name, place_text(at))); break;
    case TilePoint::Kind::middle: break;
    }
}

/// Corners move as far as the parameters of the type let them; the frame of the tile stays.
void TileView::drag_corner_to(const Point2& at)
{
    const int k = std::atoi(grabbed_point_.name.c_str() + 1); // v2
    const IsohedralType& type = *tile_.type;
    if (type.inside.freedom(k) == 0) {
        if (session_.message().text.empty())
            note(type.parameters.empty() ? fmt::format("corners of {} are fixed", type.name()) : fmt::format("corner v{} holds the frame of the tile", k));
        return;
    }
    step_->send(fmt::format("tile.corner corner={} to={}", k, place_text(at)));
}

/// The layer above is taken along with the pointer; where it may lie, the stack is that at once.
void TileView::drag_offset(const Point2& picture)
{
    constexpr double attraction = 10; // pixels
    const Point2 wanted = offset_start_ + plane_.plane(picture) - plane_.plane(pressed_);
    offset_ = attract(tile_, wanted, attraction * layout().scale / plane_.pixels);
    if (!offset_->is_allowed) return;
    if (offset_->at == wanted) offset_->at = tidy(wanted); // nothing is near
    constexpr std::array modes{"shift", "shift", "mirror", "free"}; // a column that is dragged is a shift
    const std::size_t mode = std::size_t(tile_.stack.mode);
    std::string command = fmt::format("tile.stack mode={} offset={},{}", modes[mode], offset_->at.x, offset_->at.y);
    if (tile_.stack.mode == TileStack::Mode::mirror) command += fmt::format(" axis={}", tile_.stack.axis);
    step_->send(std::move(command));
}

void TileView::drag_trace(const Point2& picture)
{
    const Point2 by = tidy(plane_.plane(picture) - plane_.plane(pressed_));
    std::array<double, 6> place = grabbed_trace_.place;
    place[2] += by.x;
    place[5] += by.y;
    step_->send(fmt::format("tile.trace place={}", fmt::join(place, ",")));
}

void TileView::end_constraint(const Point2& picture)
{
    const int to = point_near(plane_.plane(picture), grabbed_.copy);
    if (to < 0 || to == grabbed_.point) return;
    const Isometry map = tile_.copies[grabbed_.copy].map;
    const Line line(map(grabbed_point_.at), map(tile_.points[std::size_t(to)].at));
    draw_line(fmt::format("tile.constrain from={} to={}", grabbed_point_.name, tile_.points[std::size_t(to)].name), line);
}

void TileView::remove()
{
    std::set<std::string> names = selected_;
    if (names.empty() && hovered_ && hovered_->point >= 0) names.insert(tile_.points[std::size_t(hovered_->point)].name);
    // Each once, however many of its images are selected; from the last to the first, so that the names of those before stay what they are.
    std::set<PointName> points;
    for (const TilePoint& p : tile_.points) {
        if (!names.contains(p.name) || (p.kind != TilePoint::Kind::interior && p.kind != TilePoint::Kind::path)) continue;
        PointName name = PointName::parse(p.name);
        if (p.kind == TilePoint::Kind::path) name.kind = PointName::Kind::path, name.edge = -1;
        points.insert(name);
    }
    std::vector<std::string> commands;
    for (auto name = points.rbegin(); name != points.rend(); ++name)
        commands.push_back((name->kind == PointName::Kind::interior ? "tile.point_remove point=" : "tile.edge_remove point=") + name->text());
    if (commands.empty() && !names.empty()) note("corners and middles of paths stay");
    select({});
    for (const std::string& command : commands) {
        session_.run(command);
        session_.wait();
    }
}

} // namespace druse::ui
