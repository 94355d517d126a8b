#include "ui/tile_view.h"

#include "ui/tile_source.h"

#include "render/png.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace druse::ui {

namespace {

/// Are the copies around the tile, and what lies below them, as they were?
bool same_backdrop(const ShownTile& a, const ShownTile& b)
{
    if (a.type != b.type || a.size != b.size || a.parameters != b.parameters || a.outline != b.outline || !(a.look == b.look)) return false;
    return std::equal(a.points.begin(), a.points.begin() + a.outline, b.points.begin(), [](const TilePoint& p, const TilePoint& q) { return p.at == q.at; });
}

} // namespace

// --- following the session ------------------------------------------------------------------------------------------------------------

void TileView::session_changed()
{
    const Scene* scene = session_.scene();
    if (scene && session_.document_version() != tile_version_) {
        tile_version_ = session_.document_version();
        ShownTile next = shown_tile(layered_tile(*scene));
        if (!same_backdrop(next, tile_)) ++backdrop_;
        tile_ = std::move(next);
        load_picture();
        std::erase_if(selected_, [this](const std::string& name) { return tile_.find(name) < 0; });
        hovered_.reset();
        if (!tile_.type) is_framed_ = false;
        else if (!is_framed_ && plane_.width > 1) frame();
        if (gesture_ != Gesture::none && gesture_ != Gesture::pan && (!tile_.type || grabbed_.copy >= tile_.copies.size())) gesture_ = Gesture::none;
    }
    if (step_) {
        if (is_dragging() && dragged_ == Dragged::point && is_refused() && !step_->is_waiting() && pointer_)
            refused_ = RefusedPlace{grabbed_.copy, grabbed_.point, inverse(tile_.copies[grabbed_.copy].map)(plane_.plane(*pointer_)) + grip_};
        else refused_.reset();
        step_->go_on();
    }
    redraw();
}

void TileView::load_picture()
{
    const std::string name = tile_.look.trace ? tile_.look.trace->image : std::string();
    if (name == picture_name_) return;
    picture_name_ = name;
    picture_ = Image();
    ++backdrop_;
    if (name.empty()) return;
    try {
        picture_ = read_png(name);
    } catch (const std::exception& e) { // the tile is none the worse for it
        session_.say(Message::Kind::note, std::string("no picture behind the tile: ") + e.what());
    }
}

void TileView::try_trace(const std::optional<TileTrace>& trace)
{
    tile_.look.trace = trace;
    ++backdrop_;
    load_picture();
    redraw();
}

std::optional<PlaneEditor::Line> TileView::framed() const
{
    if (!tile_.type) return {};
    const Point2 low = tile_.low(), high = tile_.high(), margin = 0.45 * (high - low); // for what is around it
    return Line(low - margin, high + margin);
}

std::string TileView::invitation() const { return tile_.type ? "" : "Choose a type of tile at the top left, or open a tile."; }

void TileView::set_shown(const Shown& shown)
{
    shown_ = shown;
    ++backdrop_;
    redraw();
}

// --- what is under the pointer --------------------------------------------------------------------------------------------------------

TileHit TileView::hit(const Point2& picture) const
{
    TileHit found;
    const Point2 p = plane_.plane(picture);
    const std::size_t copies = shown_.neighbours ? tile_.copies.size() : std::min<std::size_t>(1, tile_.copies.size());
    // Of copies only those that the place is near to.
    const Point2 low = tile_.low() - reach(), high = tile_.high() + reach();
    std::vector<std::pair<std::size_t, Point2>> near;
    for (std::size_t c = 0; c < copies; ++c)
        if (const Point2 back = inverse(tile_.copies[c].map)(p); back.x >= low.x && back.y >= low.y && back.x <= high.x && back.y <= high.y) near.emplace_back(c, back);

    double nearest = reach();
    for (const auto& [c, back] : near) // itself first: of points that coincide its own is meant
        for (std::size_t i = 0; i < tile_.points.size(); ++i)
            if (const double d = glm::distance(back, tile_.points[i].at); d < nearest * (1 - 1e-9)) nearest = d, found = {c, int(i), -1, false, back};
    if (found.point >= 0) return found;
    for (const auto& [c, back] : near)
        for (int i = 0; i < tile_.outline; ++i) {
            const Point2 &a = tile_.points[std::size_t(i)].at, &b = tile_.points[std::size_t((i + 1) % tile_.outline)].at;
            if (const double d = glm::distance(back, foot_on_piece(back, a, b)); d < nearest * (1 - 1e-9)) nearest = d, found = {c, -1, i, false, back};
        }
    if (found.edge >= 0) return found;
    for (const auto& [c, back] : near)
        if (tile_.holds(back)) return {c, -1, -1, true, back};
    found.at = p;
    return found;
}

int TileView::point_near(const Point2& place, std::size_t copy) const
{
    const Point2 back = inverse(tile_.copies[copy].map)(place);
    double nearest = reach();
    int found = -1;
    for (std::size_t i = 0; i < tile_.points.size(); ++i)
        if (const double d = glm::distance(back, tile_.points[i].at); d < nearest) nearest = d, found = int(i);
    return found;
}

// --- selection ------------------------------------------------------------------------------------------------------------------------

std::string TileView::selected_text() const
{
    // Many at once have a word where there is one for them.
    constexpr std::size_t many = 8;
    const std::size_t outline = std::size_t(tile_.outline), inside = tile_.points.size() - outline;
    if (selected_.size() > many) {
        const auto chosen = std::ranges::count_if(tile_.points.begin(), tile_.points.begin() + tile_.outline, [this](const TilePoint& p) { return selected_.contains(p.name); });
        if (selected_.size() == outline + inside) return "all";
        if (std::size_t(chosen) == outline && selected_.size() == outline) return "outline";
        if (chosen == 0 && selected_.size() == inside) return "interior";
    }
    std::string text;
    for (const TilePoint& p : tile_.points)
        if (selected_.contains(p.name)) text += (text.empty() ? "" : ",") + p.name;
    return text;
}

// --- the mouse ------------------------------------------------------------------------------------------------------------------------

std::string TileView::hint() const
{
    if (!tile_.type) return "choose a type of tile";
    if (tool_ == Tool::offset && !offset_) return "drag the layer above over the tiling; Escape ends";
    if (tool_ == Tool::offset) {
        const char* rest = offset_->is_allowed ? "release to stack the layers so" : "here the layers would not be all alike: go on to where it is attracted";
        return fmt::format("offset {:.4g}, {:.4g}: {}", offset_->at.x, offset_->at.y, rest);
    }
    if (box_next_ || gesture_ == Gesture::box) return "drag a box around points; Shift adds, Ctrl removes";
    if (constrain_next_ || gesture_ == Gesture::constrain) return "drag from one point to another";
    if (is_dragging() && dragged_ == Dragged::trace) return "release to leave the picture here";
    if (!hovered_) return tile_.look.trace ? "wheel zooms, right drag moves the plane, Alt and a drag the picture" : "wheel zooms, right drag moves the plane";
    if (tool_ == Tool::heights) {
        if (!tile_.thickness) return "Extrude gives the tile its thickness; then its points can be raised";
        if (hovered_->point < 0) return "click points or drag a box around them; drag them up and down in space";
        const TilePoint& p = tile_.points[std::size_t(hovered_->point)];
        return fmt::format("{} has height {:.4g}: click selects, Shift adds", p.name, p.height);
    }
    if (hovered_->point >= 0) {
        const TilePoint& p = tile_.points[std::size_t(hovered_->point)];
        const std::string where = fmt::format("{} at {:.4g}, {:.4g}", p.name, p.at.x, p.at.y);
        if (p.kind == TilePoint::Kind::middle) return where + ": the middle of a path stays where it is";
        if (p.kind == TilePoint::Kind::corner)
            return where + (tile_.type->parameters.empty() ? ": corners of " + tile_.type->name() + " are fixed" : ": drag to change the parameters");
        return where + ": drag moves, Delete removes, c and a drag constrains";
    }
    if (hovered_->edge >= 0) return "click adds a point to the outline";
    return hovered_->inside ? "click adds a point inside" : "drag moves the plane, wheel zooms";
}

std::optional<Point2> TileView::constraint_start() const
{
    if (grabbed_.copy >= tile_.copies.size()) return {};
    return tile_.copies[grabbed_.copy].map(grabbed_point_.at);
}

void TileView::set_tool(Tool tool)
{
    cancel();
    tool_ = tool;
    offset_.reset();
    redraw();
}

PlaneEditor::Gesture TileView::begin(const Pointer& p)
{
    if (p.alt && tile_.look.trace) {
        dragged_ = Dragged::trace;
        grabbed_trace_ = *tile_.look.trace;
        return Gesture::edit;
    }
    grabbed_ = hit(pressed_);
    if (grabbed_.point >= 0) grabbed_point_ = tile_.points[std::size_t(grabbed_.point)];
    if (tool_ == Tool::offset) {
        dragged_ = Dragged::offset;
        offset_start_ = tile_.stack.mode == TileStack::Mode::column ? Point2(0.0) : tile_.stack.offset;
        return Gesture::edit;
    }
    if (box_next_) return Gesture::box;
    return constrain_next_ && grabbed_.point >= 0 ? Gesture::constrain : Gesture::click;
}

PlaneEditor::Gesture TileView::begin_drag(const Pointer& p)
{
    if (tool_ == Tool::heights) return Gesture::box; // places in the plane are as they are
    if (grabbed_.point < 0) return Gesture::pan;
    dragged_ = Dragged::point;
    grip_ = grabbed_point_.at - grabbed_.at;
    if (!p.shift && !selected_.contains(grabbed_point_.name)) select({grabbed_point_.name});
    return Gesture::edit;
}

void TileView::drag_to(const Point2& picture)
{
    switch (dragged_) {
    case Dragged::point: move_to(picture); break;
    case Dragged::offset: drag_offset(picture); break;
    case Dragged::trace: drag_trace(picture); break;
    }
}

void TileView::end_drag()
{
    offset_.reset();
    refused_.reset();
}

void TileView::forget_refused()
{
    PlaneEditor::forget_refused();
    refused_.reset();
}

/// What a click on a point, or beside all points, does.
void TileView::click(const Pointer& p)
{
    if (grabbed_.point >= 0) {
        select_clicked(grabbed_point_.name, p);
    } else if (p.shift || p.ctrl || tool_ == Tool::heights) {
        if (!p.shift) select({});
    } else {
        add_point(grabbed_);
    }
}

/// Of the tile itself: its copies show the same points.
void TileView::select_box(const Point2& low, const Point2& high, const Pointer& p)
{
    std::set<std::string> names = p.shift || p.ctrl ? selected_ : std::set<std::string>();
    for (const TilePoint& point : tile_.points) {
        if (point.at.x < low.x || point.at.y < low.y || point.at.x > high.x || point.at.y > high.y) continue;
        if (p.ctrl) names.erase(point.name);
        else names.insert(point.name);
    }
    select(std::move(names));
}

void TileView::hover(const Pointer& p)
{
    pointer_ = Point2(p.x, p.y);
    if (gesture_ != Gesture::none || !tile_.type) return;
    const TileHit found = hit(*pointer_);
    if (!hovered_ || hovered_->copy != found.copy || hovered_->point != found.point || hovered_->edge != found.edge || hovered_->inside != found.inside) redraw();
    hovered_ = found;
}

void TileView::leave()
{
    pointer_.reset();
    hovered_.reset();
    redraw();
}

bool TileView::cancel()
{
    if (take_back()) return true;
    if (tool_ != Tool::offset) return PlaneEditor::cancel();
    tool_ = Tool::edit;
    redraw();
    return true;
}

} // namespace druse::ui
