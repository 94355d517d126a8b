#include "ui/tile_view.h"

#include "ui/layout.h"
#include "ui/tile_source.h"

#include "render/png.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace druse::ui {

namespace {

constexpr double grab_radius = 6; // pixels
constexpr double wheel_zoom = 1.15;

double distance_to_piece(const Point2& p, const Point2& a, const Point2& b)
{
    const Point2 along = b - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * along);
}

Point2 place_of(const Pointer& p) { return {p.x, p.y}; }

/// Are the copies around the tile, and what lies below them, as they were?
bool same_backdrop(const ShownTile& a, const ShownTile& b)
{
    if (a.type != b.type || a.size != b.size || a.parameters != b.parameters || a.outline != b.outline || !(a.look == b.look)) return false;
    return std::equal(a.points.begin(), a.points.begin() + a.outline, b.points.begin(), [](const TilePoint& p, const TilePoint& q) { return p.at == q.at; });
}

} // namespace

void TileView::redraw()
{
    if (on_redraw) on_redraw();
}

void TileView::note(const std::string& text)
{
    session_.say(Message::Kind::note, text);
    if (session_.on_change) session_.on_change();
}

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
        if (!tile_.type) framed_ = false;
        else if (!framed_ && plane_.width > 1) frame();
        if (gesture_ != Gesture::none && gesture_ != Gesture::pan && (!tile_.type || grabbed_.copy >= tile_.copies.size())) gesture_ = Gesture::none;
    }
    if (step_) {
        const bool failed = session_.message().kind == Message::Kind::error && !session_.message().text.empty();
        if (gesture_ == Gesture::move && failed && !step_->is_waiting() && pointer_)
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

void TileView::resize(int width, int height)
{
    plane_.width = std::max(width, 1);
    plane_.height = std::max(height, 1);
    if (!framed_ && tile_.type) frame();
    ++backdrop_;
    redraw();
}

void TileView::frame()
{
    plane_.fit(tile_.low(), tile_.high(), 0.45);
    framed_ = true;
    ++backdrop_;
    redraw();
}

void TileView::zoom(double factor)
{
    plane_.zoom(factor, 0.5 * Point2(plane_.width, plane_.height));
    ++backdrop_;
    redraw();
}

void TileView::set_shown(const Shown& shown)
{
    shown_ = shown;
    ++backdrop_;
    redraw();
}

/// 1, 2 or 5 times a power of ten, so that lines are some 25 to 60 pixels apart.
double TileView::grid() const
{
    const double least = 25 * layout().scale / plane_.pixels, power = std::pow(10, std::floor(std::log10(least)));
    for (const double times : {1.0, 2.0, 5.0})
        if (times * power >= least) return times * power;
    return 10 * power;
}

// --- what is under the pointer --------------------------------------------------------------------------------------------------------

TileHit TileView::hit(const Point2& picture) const
{
    TileHit found;
    const Point2 p = plane_.plane(picture);
    const std::size_t copies = shown_.neighbours ? tile_.copies.size() : std::min<std::size_t>(1, tile_.copies.size());
    const double reach = grab_radius * layout().scale / plane_.pixels;

    // Of copies only those that the place is near to.
    const Point2 low = tile_.low() - reach, high = tile_.high() + reach;
    std::vector<std::pair<std::size_t, Point2>> near;
    for (std::size_t c = 0; c < copies; ++c)
        if (const Point2 back = inverse(tile_.copies[c].map)(p); back.x >= low.x && back.y >= low.y && back.x <= high.x && back.y <= high.y) near.emplace_back(c, back);

    double nearest = reach;
    for (const auto& [c, back] : near) // itself first: of points that coincide its own is meant
        for (std::size_t i = 0; i < tile_.points.size(); ++i)
            if (const double d = glm::distance(back, tile_.points[i].at); d < nearest * (1 - 1e-9)) nearest = d, found = {c, int(i), -1, false, back};
    if (found.point >= 0) return found;
    for (const auto& [c, back] : near)
        for (int i = 0; i < tile_.outline; ++i) {
            const Point2 &a = tile_.points[std::size_t(i)].at, &b = tile_.points[std::size_t((i + 1) % tile_.outline)].at;
            if (const double d = distance_to_piece(back, a, b); d < nearest * (1 - 1e-9)) nearest = d, found = {c, -1, i, false, back};
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
    double nearest = grab_radius * layout().scale / plane_.pixels;
    int found = -1;
    for (std::size_t i = 0; i < tile_.points.size(); ++i)
        if (const double d = glm::distance(back, tile_.points[i].at); d < nearest) nearest = d, found = int(i);
    return found;
}

/// On the grid if that is asked for; else to a tenth of a pixel, so that commands can be read.
Point2 TileView::tidy(const Point2& p) const
{
    const double step = shown_.snap ? grid() : std::pow(10, std::floor(std::log10(0.2 / plane_.pixels)));
    // Divided by a whole number where the step is below 1, which gives the number nearest to the decimal.
    const auto rounded = [step](double x) { return step < 1 ? std::round(x / step) / std::round(1 / step) : std::round(x / step) * step; };
    return {rounded(p.x) + 0.0, rounded(p.y) + 0.0};
}

std::string TileView::place_text(const Point2& p) const
{
    const Point2 q = tidy(p);
    return fmt::format("{},{}", q.x, q.y);
}

// --- selection ------------------------------------------------------------------------------------------------------------------------

void TileView::select(std::set<std::string> names)
{
    if (names == selected_) return;
    selected_ = std::move(names);
    if (on_select) on_select();
    redraw();
}

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
    if (gesture_ == Gesture::trace) return "release to leave the picture here";
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

std::string TileView::place_hint() const
{
    if (!pointer_ || !tile_.type) return {};
    const Point2 p = tidy(plane_.plane(*pointer_));
    return fmt::format("x {}  y {}  grid {}: ", p.x, p.y, grid());
}

std::optional<TileView::Line> TileView::rubber() const
{
    if (gesture_ != Gesture::constrain || grabbed_.point < 0 || !pointer_) return {};
    return Line(tile_.copies[grabbed_.copy].map(grabbed_point_.at), plane_.plane(*pointer_));
}

std::optional<TileView::Line> TileView::box() const
{
    if (gesture_ != Gesture::box || !pointer_) return {};
    return Line(pressed_, *pointer_);
}

void TileView::set_tool(Tool tool)
{
    cancel();
    tool_ = tool;
    offset_.reset();
    redraw();
}

void TileView::press(const Pointer& p)
{
    pointer_ = place_of(p);
    if (gesture_ != Gesture::none) {
        cancel();
        return;
    }
    pressed_ = last_ = place_of(p);
    button_ = p.button;
    refused_.reset();
    refused_line_.reset();
    if (step_ && step_->is_waiting()) return; // the last drag is being worked on still
    step_.reset();
    if (p.button != 1 || !tile_.type) {
        gesture_ = Gesture::pan;
        return;
    }
    if (p.alt && tile_.look.trace) {
        gesture_ = Gesture::trace;
        grabbed_trace_ = *tile_.look.trace;
        step_.emplace(session_);
        return;
    }
    grabbed_ = hit(pressed_);
    if (grabbed_.point >= 0) grabbed_point_ = tile_.points[std::size_t(grabbed_.point)];
    if (tool_ == Tool::offset) {
        gesture_ = Gesture::offset;
        offset_start_ = tile_.stack.mode == TileStack::Mode::column ? Point2(0.0) : tile_.stack.offset;
        step_.emplace(session_);
    } else if (box_next_) {
        gesture_ = Gesture::box;
    } else if (constrain_next_ && grabbed_.point >= 0) {
        gesture_ = Gesture::constrain;
    } else {
        gesture_ = Gesture::click;
    }
    redraw();
}

void TileView::drag(const Pointer& p)
{
    pointer_ = place_of(p);
    const Point2 by = *pointer_ - last_;
    last_ = *pointer_;
    if (gesture_ == Gesture::click && glm::distance(*pointer_, pressed_) >= layout().click_slop()) {
        if (tool_ == Tool::heights) { // places in the plane are as they are
            gesture_ = Gesture::box;
            redraw();
            return;
        }
        if (grabbed_.point < 0) {
            gesture_ = Gesture::pan;
            plane_.pan(*pointer_ - pressed_);
            ++backdrop_;
            redraw();
            return;
        }
        gesture_ = Gesture::move;
        step_.emplace(session_);
        grip_ = grabbed_point_.at - grabbed_.at;
        if (!p.shift && !selected_.contains(grabbed_point_.name)) select({grabbed_point_.name});
    }
    if (gesture_ == Gesture::pan) plane_.pan(by), ++backdrop_;
    if (gesture_ == Gesture::trace) drag_trace(*pointer_);
    if (gesture_ == Gesture::move) move_to(*pointer_);
    if (gesture_ == Gesture::offset) drag_offset(*pointer_);
    redraw();
}

void TileView::release(const Pointer& p)
{
    pointer_ = place_of(p);
    const Gesture gesture = std::exchange(gesture_, Gesture::none);
    switch (gesture) {
    case Gesture::click: click(p); break;
    case Gesture::box: select_box(p); break;
    case Gesture::constrain: end_constraint(*pointer_); break;
    case Gesture::pan:
        if (button_ == 1 && glm::distance(*pointer_, pressed_) < layout().click_slop()) select({});
        break;
    case Gesture::offset: // the last move may have come together with the release, and then there was no drag
        if (*pointer_ != last_) drag_offset(*pointer_);
        offset_.reset();
        break;
    case Gesture::move:
        if (*pointer_ != last_) move_to(*pointer_);
        break;
    case Gesture::trace:
        if (*pointer_ != last_) drag_trace(*pointer_);
        break;
    case Gesture::none: break;
    }
    refused_.reset();
    hover(p);
    redraw();
}

/// What a click on a point, or beside all points, does.
void TileView::click(const Pointer& p)
{
    if (grabbed_.point >= 0) {
        const std::string& name = grabbed_point_.name;
        std::set<std::string> names = p.shift || p.ctrl ? selected_ : std::set<std::string>();
        if (p.shift && names.contains(name)) names.erase(name);
        else if (!p.ctrl) names.insert(name);
        else names.erase(name);
        select(std::move(names));
    } else if (p.shift || p.ctrl || tool_ == Tool::heights) {
        if (!p.shift) select({});
    } else {
        add_point(grabbed_);
    }
}

/// Of the tile itself: its copies show the same points.
void TileView::select_box(const Pointer& p)
{
    box_next_ = false;
    const Point2 a = plane_.plane(pressed_), b = plane_.plane(place_of(p)), low = glm::min(a, b), high = glm::max(a, b);
    std::set<std::string> names = p.shift || p.ctrl ? selected_ : std::set<std::string>();
    for (const TilePoint& point : tile_.points) {
        if (point.at.x < low.x || point.at.y < low.y || point.at.x > high.x || point.at.y > high.y) continue;
        if (p.ctrl) names.erase(point.name);
        else names.insert(point.name);
    }
    select(std::move(names));
}

void TileView::start_box()
{
    if (gesture_ != Gesture::none || !tile_.type) return;
    constrain_next_ = false;
    box_next_ = true;
    redraw();
}

void TileView::hover(const Pointer& p)
{
    pointer_ = place_of(p);
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

void TileView::wheel(double notches, const Pointer& p)
{
    plane_.zoom(std::pow(wheel_zoom, -notches), place_of(p));
    ++backdrop_;
    redraw();
}

bool TileView::cancel()
{
    const bool was_next = std::exchange(constrain_next_, false) | std::exchange(box_next_, false);
    const Gesture gesture = std::exchange(gesture_, Gesture::none);
    refused_.reset();
    refused_line_.reset();
    if ((gesture == Gesture::move || gesture == Gesture::offset || gesture == Gesture::trace) && step_) {
        step_->cancel();
        step_.reset();
    }
    offset_.reset();
    redraw();
    if (gesture != Gesture::none || was_next) return true;
    if (tool_ == Tool::offset) {
        tool_ = Tool::edit;
        return true;
    }
    if (selected_.empty()) return false;
    select({});
    return true;
}

} // namespace druse::ui
