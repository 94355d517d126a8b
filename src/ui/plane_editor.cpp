#include "ui/plane_editor.h"

#include "ui/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace druse::ui {

namespace {

constexpr double grab_radius = 6; // pixels
constexpr double wheel_zoom = 1.15;

Point2 place_of(const Pointer& p) { return {p.x, p.y}; }

} // namespace

Point2 foot_on_piece(const Point2& p, const Point2& a, const Point2& b)
{
    const Point2 along = b - a;
    const double length2 = glm::dot(along, along);
    return a + (length2 > 0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0.0) * along;
}

void PlaneEditor::redraw()
{
    if (on_redraw) on_redraw();
}

void PlaneEditor::note(const std::string& text)
{
    session_.say(Message::Kind::note, text);
    if (session_.on_change) session_.on_change();
}

bool PlaneEditor::is_refused() const { return session_.message().kind == Message::Kind::error && !session_.message().text.empty(); }

// --- what is seen ---------------------------------------------------------------------------------------------------------------------

void PlaneEditor::resize(int width, int height)
{
    plane_.width = std::max(width, 1);
    plane_.height = std::max(height, 1);
    if (!is_framed_) frame();
    ++backdrop_;
    redraw();
}

void PlaneEditor::frame()
{
    if (const auto box = framed()) {
        plane_.fit(box->first, box->second, 0);
        is_framed_ = true;
        ++backdrop_;
    }
    redraw();
}

void PlaneEditor::zoom(double factor)
{
    plane_.zoom(factor, 0.5 * Point2(plane_.width, plane_.height));
    ++backdrop_;
    redraw();
}

void PlaneEditor::wheel(double notches, const Pointer& p)
{
    plane_.zoom(std::pow(wheel_zoom, -notches), place_of(p));
    ++backdrop_;
    redraw();
}

/// 1, 2 or 5 times a power of ten, so that lines are some 25 to 60 pixels apart.
double PlaneEditor::grid() const
{
    const double least = 25 * layout().scale / plane_.pixels, power = std::pow(10, std::floor(std::log10(least)));
    for (const double times : {1.0, 2.0, 5.0})
        if (times * power >= least) return times * power;
    return 10 * power;
}

double PlaneEditor::reach() const { return grab_radius * layout().scale / plane_.pixels; }

Point2 PlaneEditor::tidy(const Point2& p) const
{
    const double step = snaps() ? grid() : std::pow(10, std::floor(std::log10(0.2 / plane_.pixels)));
    // Divided by a whole number where the step is below 1, which gives the number nearest to the decimal.
    const auto rounded = [step](double x) { return step < 1 ? std::round(x / step) / std::round(1 / step) : std::round(x / step) * step; };
    return {rounded(p.x) + 0.0, rounded(p.y) + 0.0};
}

std::string PlaneEditor::place_text(const Point2& p) const
{
    const Point2 q = tidy(p);
    return fmt::format("{},{}", q.x, q.y);
}

std::string PlaneEditor::place_hint() const
{
    if (!pointer_ || !framed()) return {};
    const Point2 p = tidy(plane_.plane(*pointer_));
    return fmt::format("x {}  y {}  grid {}: ", p.x, p.y, grid());
}

std::optional<PlaneEditor::Line> PlaneEditor::box() const
{
    if (gesture_ != Gesture::box || !pointer_) return {};
    return Line(pressed_, *pointer_);
}

std::optional<PlaneEditor::Line> PlaneEditor::rubber() const
{
    if (gesture_ != Gesture::constrain || !pointer_) return {};
    const auto from = constraint_start();
    if (!from) return {};
    return Line(*from, plane_.plane(*pointer_));
}

// --- selection ------------------------------------------------------------------------------------------------------------------------

void PlaneEditor::select(std::set<std::string> names)
{
    if (names == selected_) return;
    selected_ = std::move(names);
    if (on_select) on_select();
    redraw();
}

void PlaneEditor::select_clicked(const std::string& name, const Pointer& p)
{
    std::set<std::string> names = p.shift || p.ctrl ? selected_ : std::set<std::string>();
    if (p.ctrl || (p.shift && names.contains(name))) names.erase(name);
    else names.insert(name);
    select(std::move(names));
}

// --- the mouse ------------------------------------------------------------------------------------------------------------------------

void PlaneEditor::press(const Pointer& p)
{
    pointer_ = place_of(p);
    if (gesture_ != Gesture::none) {
        take_back();
        return;
    }
    pressed_ = last_ = *pointer_;
    button_ = p.button;
    forget_refused();
    if (step_ && step_->is_waiting()) return; // the last drag is being worked on still
    step_.reset();
    gesture_ = p.button == 1 && framed() ? begin(p) : Gesture::pan;
    if (gesture_ == Gesture::edit) step_.emplace(session_);
    redraw();
}

void PlaneEditor::drag(const Pointer& p)
{
    pointer_ = place_of(p);
    Point2 by = *pointer_ - last_;
    last_ = *pointer_;
    if (gesture_ == Gesture::click && glm::distance(*pointer_, pressed_) >= layout().click_slop()) {
        gesture_ = begin_drag(p);
        by = *pointer_ - pressed_;
        if (gesture_ == Gesture::edit) step_.emplace(session_);
    }
    if (gesture_ == Gesture::pan) plane_.pan(by), ++backdrop_;
    if (gesture_ == Gesture::edit) drag_to(*pointer_);
    redraw();
}

void PlaneEditor::release(const Pointer& p)
{
    pointer_ = place_of(p);
    const Gesture gesture = std::exchange(gesture_, Gesture::none);
    switch (gesture) {
    case Gesture::click: click(p); break;
    case Gesture::pan:
        if (button_ == 1 && glm::distance(*pointer_, pressed_) < layout().click_slop()) select({});
        break;
    case Gesture::constrain:
        constrain_next_ = false;
        end_constraint(*pointer_);
        break;
    case Gesture::box: {
        box_next_ = false;
        const Point2 a = plane_.plane(pressed_), b = plane_.plane(*pointer_);
        select_box(glm::min(a, b), glm::max(a, b), p);
        if (on_box) on_box();
        break;
    }
    case Gesture::edit: // the last move may have come together with the release, and then there was no drag
        if (*pointer_ != last_) drag_to(*pointer_);
        end_drag();
        break;
    case Gesture::none: break;
    }
    hover(p);
    redraw();
}

void PlaneEditor::start_constraint()
{
    if (gesture_ != Gesture::none || !may_constrain()) return;
    box_next_ = false;
    constrain_next_ = true;
    redraw();
}

void PlaneEditor::start_box()
{
    if (gesture_ != Gesture::none || !framed()) return;
    constrain_next_ = false;
    box_next_ = true;
    redraw();
}

void PlaneEditor::draw_line(const std::string& command, const Line& line)
{
    session_.run(command);
    session_.wait();
    if (is_refused()) refused_line_ = line;
}

bool PlaneEditor::take_back()
{
    const bool was_next = std::exchange(constrain_next_, false) | std::exchange(box_next_, false);
    const Gesture gesture = std::exchange(gesture_, Gesture::none);
    forget_refused();
    if (gesture == Gesture::edit) {
        if (step_) step_->cancel();
        step_.reset();
        end_drag();
    }
    redraw();
    return gesture != Gesture::none || was_next;
}

bool PlaneEditor::cancel()
{
    if (take_back()) return true;
    if (selected_.empty()) return false;
    select({});
    return true;
}

} // namespace druse::ui
