#include "ui/relief_tool.h"

#include "ui/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace druse::ui {

namespace {

constexpr double flattest = 0.15; // of the length of a unit in the picture, that the vertical must have for a drag along it

} // namespace

std::optional<Target> ReliefTool::under(const Pointer& pointer) const
{
    const ShownTile& shape = plane_.tile();
    if (!shape.thickness || !relief_.is_shown) return {};
    double nearest = layout().pick_radius();
    std::optional<Target> found;
    double depth = 0;
    for (std::uint32_t v = 0; v < std::min<std::size_t>(shape.points.size(), relief_.lists.vertex_limit()); ++v) {
        const auto seen = camera_.project(relief_.lists.position(v));
        if (!seen) continue;
        const double away = glm::distance(*seen, Point2(pointer.x, pointer.y)), ahead = -glm::dot(relief_.lists.position(v), camera_.backward());
        // Of points that are seen in one place the front one is meant.
        if (away > nearest || (found && away > nearest - 1 && ahead > depth)) continue;
        nearest = away;
        depth = ahead;
        found.emplace();
        found->vertex = Vertex(v);
    }
    return found;
}

void ReliefTool::act(const Target& target, const Pointer& pointer)
{
    if (!target.vertex || target.vertex->index >= plane_.tile().points.size()) return;
    const std::string& name = plane_.tile().points[target.vertex->index].name;
    std::set<std::string> names = pointer.shift || pointer.ctrl ? plane_.selected() : std::set<std::string>();
    const bool was = names.erase(name) > 0;
    if (!pointer.ctrl && !(pointer.shift && was)) names.insert(name);
    plane_.select(std::move(names));
}

bool ReliefTool::take_box(const Point2& low, const Point2& high, const Pointer& end)
{
    const ShownTile& shape = plane_.tile();
    if (!shape.thickness || relief_.lists.vertex_limit() < shape.points.size()) return true; // there is nothing to select
    std::set<std::string> names = end.shift || end.ctrl ? plane_.selected() : std::set<std::string>();
    for (std::uint32_t v = 0; v < shape.points.size(); ++v) {
        const auto seen = camera_.project(relief_.lists.position(v));
        if (!seen || seen->x < low.x || seen->y < low.y || seen->x > high.x || seen->y > high.y) continue;
        if (end.ctrl) names.erase(shape.points[v].name);
        else names.insert(shape.points[v].name);
    }
    plane_.select(std::move(names));
    return true;
}

std::unique_ptr<Gesture> ReliefTool::press(const Pointer& start, const ShowTarget& show)
{
    const auto target = under(start);
    if (!target) return Tool::press(start, show);
    return std::make_unique<Raise>(*this, *target, start);
}

void ReliefTool::add_marks(Overlay& overlay) const
{
    constexpr std::size_t most_dots = 1500;
    constexpr Colour dot{0xff, 0xff, 0xff}, rim{0x1c, 0x1d, 0x20}, together{0x7d, 0xe0, 0xff};
    const ShownTile& shape = plane_.tile();
    if (!shape.thickness || !relief_.is_shown || relief_.lists.vertex_limit() < shape.points.size()) return;
    std::set<int> orbits;
    for (const TilePoint& p : shape.points)
        if (p.orbit >= 0 && plane_.selected().contains(p.name)) orbits.insert(p.orbit);
    for (std::uint32_t v = 0; v < shape.points.size(); ++v) {
        const TilePoint& p = shape.points[v];
        const bool here = plane_.selected().contains(p.name), with_it = !here && p.orbit >= 0 && orbits.contains(p.orbit);
        if (!here && !with_it && shape.points.size() > most_dots) continue;
        const Point at = relief_.lists.position(v);
        const double size = layout().scale * (here || with_it ? 11 : 6);
        overlay.lines.push_back({at, at, rim, size + 3 * layout().scale, 1});
        overlay.lines.push_back({at, at, here ? overlay.highlight : with_it ? together : dot, size, 1});
    }
    if (relief_.thinnest) {
        const Colour colour = relief_.trouble.empty() ? Colour{0xe8, 0xa3, 0x3d} : overlay.error;
        overlay.lines.push_back({relief_.thinnest_top, relief_.thinnest_bottom, colour, 3 * layout().scale, 1});
        overlay.lines.push_back({relief_.thinnest_top, relief_.thinnest_top, colour, 7 * layout().scale, 1});
    }
}

std::string ReliefTool::hint() const
{
    if (!plane_.tile().type) return "choose a type of tile";
    if (!plane_.tile().thickness) return "Extrude gives the tile its thickness; then its points can be raised";
    return "click or Shift-click points, B and a drag boxes them; drag them up and down; drag beside them turns the view";
}

ReliefTool::Raise::Raise(ReliefTool& tool, const Target& target, const Pointer& start) : tool_(tool), target_(target), start_(start)
{
    const Point at = tool_.relief_.lists.position(target.vertex->index);
    const double unit = 1e-3 * tool_.camera_.distance();
    const auto foot = tool_.camera_.project(at), head = tool_.camera_.project(at + Vector(0, 0, unit));
    if (foot && head) up_ = (*head - *foot) / unit;
}

void ReliefTool::Raise::move(const Pointer& p)
{
    const Point2 by(p.x - start_.x, p.y - start_.y);
    if (!moved_ && glm::length(by) < layout().click_slop()) return;
    const double length2 = glm::dot(up_, up_), per_pixel = tool_.camera_.unit_per_pixel();
    if (std::sqrt(length2) * per_pixel < flattest) {
        tool_.session_.say(Message::Kind::note, "seen from above there is no up and down: turn the view first");
        if (tool_.session_.on_change) tool_.session_.on_change();
        return;
    }
    if (!moved_) {
        if (tool_.step_ && tool_.step_->is_waiting()) return;
        const std::string& name = tool_.plane_.tile().points[target_.vertex->index].name;
        if (!tool_.plane_.selected().contains(name)) tool_.act(target_, start_);
        if (!tool_.plane_.selected().contains(name)) return;
        points_ = tool_.plane_.selected_text();
        tool_.step_.emplace(tool_.session_);
        tool_.is_raising_ = true;
        moved_ = true;
    }
    // To a tenth of what a pixel is, so that commands can be read.
    const double step = std::pow(10, std::floor(std::log10(0.2 * per_pixel))), wanted = glm::dot(by, up_) / length2;
    const double height = step < 1 ? std::round(wanted / step) / std::round(1 / step) : std::round(wanted / step) * step;
    tool_.step_->send(fmt::format("tile.height points={} add={}", points_, height + 0.0));
}

void ReliefTool::Raise::release(const Pointer& p)
{
    if (moved_) move(p); // or it would be lost where it came together with the release
    else tool_.act(target_, p);
}

void ReliefTool::Raise::cancel()
{
    if (!moved_ || !tool_.step_) return;
    tool_.step_->cancel();
    tool_.step_.reset();
}

} // namespace druse::ui
