#include "ui/skew_widget.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/theme.h"

#include "dlfl/errors.h"
#include "ops/text.h"

#include <FL/Fl.H>
#include <FL/fl_draw.H>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace druse::ui {

namespace {

constexpr std::array<Colour, 3> axis_colours{{{0xe2, 0x5c, 0x5c}, {0x7c, 0xb9, 0x4c}, {0x5a, 0x96, 0xe6}}}; // as those of the cross in the view

std::string entry_text(double value) { return fmt::format("{:.5g}", value + 0.0); }

void draw_line(const Point2& a, const Point2& b)
{
    fl_begin_line();
    fl_vertex(a.x, a.y);
    fl_vertex(b.x, b.y);
    fl_end_line();
}

} // namespace

SkewWidget::SkewWidget(Session& session, const Camera& camera) : Panel(0, 0, 1, 1), session_(session), camera_(camera), reset_(0, 0, 1, 1, "Reset")
{
    end();
    Fl_Group::current(nullptr);
    box(FL_NO_BOX);
    for (int entry = 0; entry < 9; ++entry) {
        auto& field = fields_[static_cast<std::size_t>(entry)];
        field = std::make_unique<Fl_Input>(0, 0, 1, 1);
        field->textsize(layout().small_font());
        field->when(FL_WHEN_ENTER_KEY | FL_WHEN_RELEASE | FL_WHEN_NOT_CHANGED);
        field->copy_tooltip(fmt::format("{} of the skew", skew_entry_name(entry)).c_str());
        field->callback([](Fl_Widget* widget, void* p) {
            auto* self = static_cast<SkewWidget*>(p);
            for (int e = 0; e < 9; ++e)
                if (self->fields_[static_cast<std::size_t>(e)].get() == widget) self->typed(e);
        }, this);
        add(*field);
    }
    reset_.tooltip("Back to no skew");
    reset_.labelsize(layout().small_font());
    reset_.color(theme().raised);
    reset_.clear_visible_focus();
    reset_.callback([](Fl_Widget*, void* p) { static_cast<SkewWidget*>(p)->session_.run("cell.skew reset=true"); }, this);
    add(reset_);
    show_numbers();
}

int SkewWidget::picture_width() const
{
    const Layout& l = layout();
    return std::max(1, std::min(h() + l.px(30), w() - 3 * l.px(46) - l.px(16) - 2 * l.margin()));
}

void SkewWidget::arrange()
{
    const Layout& l = layout();
    const int left = x() + picture_width() + l.px(16), room = x() + w() - l.margin() - left, width = std::clamp(room / 3, 1, l.px(74));
    const int height = l.control_height(), step = height + l.gap(), top = y() + std::max(0, (h() - 4 * step) / 2);
    for (int entry = 0; entry < 9; ++entry)
        fields_[static_cast<std::size_t>(entry)]->resize(left + entry % 3 * width, top + entry / 3 * step, std::max(1, width - l.px(3)), height);
    reset_.resize(left, top + 3 * step, std::min(room, l.px(70)), height);
}

void SkewWidget::show_matrix(const std::optional<CellMatrix>& matrix)
{
    if (matrix == matrix_) return;
    matrix_ = matrix;
    show_numbers();
    redraw();
}

void SkewWidget::show_numbers()
{
    for (std::size_t entry = 0; entry < 9; ++entry) {
        Fl_Input& field = *fields_[entry];
        const std::string text = matrix_ ? entry_text((*matrix_)[entry]) : "";
        if (text != field.value()) field.value(text.c_str());
        matrix_ ? field.activate() : field.deactivate();
    }
    matrix_ ? reset_.activate() : reset_.deactivate();
}

void SkewWidget::typed(int entry)
{
    if (!matrix_) return;
    const double now = (*matrix_)[static_cast<std::size_t>(entry)];
    const std::string text = fields_[static_cast<std::size_t>(entry)]->value();
    if (text == entry_text(now)) return;
    try {
        if (parse_number(text) != now) session_.run(fmt::format("cell.skew entry={} value={}", skew_entry_name(entry), text));
    } catch (const CommandError& e) {
        session_.say(Message::Kind::error, e.what());
        if (session_.on_change) session_.on_change();
    }
    show_numbers(); // what is refused is not there
}

// --- handles ------------------------------------------------------------------------------------------------------------------------------

SkewHandles::Place SkewWidget::place() const
{
    return SkewHandles::fitting(*matrix_, camera_, Point2(x() + 0.5 * picture_width(), y() + 0.5 * h()), picture_width(), h());
}

std::string SkewWidget::places() const
{
    std::string text;
    if (!matrix_) return text;
    const SkewHandles all = handles();
    for (int entry = 0; entry < 9; ++entry)
        text += fmt::format("{}{} {:.0f},{:.0f}", entry == 0 ? "" : " ", skew_entry_name(entry), all.handle(entry).place.x, all.handle(entry).place.y);
    return text;
}

std::string SkewWidget::hint() const
{
    const std::optional<int>& entry = dragged_ ? dragged_ : hovered_;
    if (!matrix_ || !entry) return "drag a handle to scale or shear the cell, and space with it; or type a number";
    const std::string value = fmt::format("{} = {}", skew_entry_name(*entry), entry_text((*matrix_)[static_cast<std::size_t>(*entry)]));
    return value + (dragged_ ? "; Escape takes it back" : *entry % 4 == 0 ? ": drag to scale" : ": drag to shear");
}

void SkewWidget::drag()
{
    if (!dragged_ || !pressed_handles_) return;
    const Point2 by = Point2(Fl::event_x(), Fl::event_y()) - pressed_at_;
    if (!step_) {
        if (glm::length(by) < layout().click_slop()) return;
        step_.emplace(session_);
        sent_ = false;
    }
    const double value = stopped_skew(pressed_, *dragged_, pressed_handles_->dragged(*dragged_, by));
    if (!sent_ && value == pressed_[static_cast<std::size_t>(*dragged_)]) return; // it has not moved yet
    sent_ = true;
    step_->send(fmt::format("cell.skew entry={} value={}", skew_entry_name(*dragged_), value));
}

bool SkewWidget::cancel()
{
    if (!dragged_) {
        const bool typing = std::ranges::any_of(fields_, [](const auto& field) { return Fl::focus() == field.get(); });
        if (typing) show_numbers(); // or what was typed would be taken when the field loses the focus
        return typing;
    }
    dragged_.reset();
    if (step_) step_->cancel();
    step_.reset();
    redraw();
    return true;
}

int SkewWidget::handle(int event)
{
    const bool in_picture = Fl::event_x() < x() + picture_width();
    switch (event) {
    case FL_ENTER: // else FLTK tells of no moves
        Panel::handle(event);
        return 1;
    case FL_MOVE: {
        const auto under = matrix_ && in_picture ? handles().at(Point2(Fl::event_x(), Fl::event_y())) : std::nullopt;
        if (under != hovered_) hovered_ = under, redraw();
        Panel::handle(event);
        return 1;
    }
    case FL_LEAVE:
        if (hovered_) hovered_.reset(), redraw();
        return Panel::handle(event);
    case FL_PUSH: {
        if (dragged_) { // a second button
            cancel();
            return 1;
        }
        if (!matrix_ || !in_picture || Fl::event_button() != 1 || session_.is_working()) return Panel::handle(event);
        const SkewHandles now = handles();
        hovered_ = now.at(Point2(Fl::event_x(), Fl::event_y()));
        if (!hovered_) return 1;
        place_ = place();
        pressed_ = *matrix_;
        pressed_at_ = Point2(Fl::event_x(), Fl::event_y());
        pressed_handles_ = now;
        step_.reset();
        dragged_ = hovered_;
        redraw();
        return 1;
    }
    case FL_DRAG:
        if (!dragged_) return Panel::handle(event);
        drag();
        return 1;
    case FL_RELEASE:
        if (!dragged_) return Panel::handle(event);
        drag(); // the last move may have come together with it
        dragged_.reset();
        redraw();
        return 1;
    default: return Panel::handle(event);
    }
}

void SkewWidget::draw()
{
    const Layout& l = layout();
    fl_color(theme().window);
    fl_rectf(x(), y(), w(), h());
    fl_push_clip(x(), y(), picture_width(), h());
    if (matrix_) {
        const SkewHandles all = handles();
        for (const int axis : all.order()) {
            const Fl_Color colour = fl_colour(axis_colours[static_cast<std::size_t>(axis)]);
            fl_line_style(FL_SOLID, l.px(3));
            fl_color(colour);
            draw_line(all.origin(), all.tip(axis));
            fl_line_style(FL_SOLID, l.px(1.4));
            for (int row = 0; row < 3; ++row) {
                const SkewHandles::Handle& handle = all.handle(3 * row + axis);
                fl_color(handle.can_move ? fl_colour(axis_colours[static_cast<std::size_t>(row)]) : theme().border);
                draw_line(all.tip(axis), handle.place);
            }
            fl_line_style(0);
            for (int row = 0; row < 3; ++row) {
                const int entry = 3 * row + axis;
                const SkewHandles::Handle& handle = all.handle(entry);
                if (!handle.can_move) continue;
                const bool hot = dragged_ ? dragged_ == entry : hovered_ == entry;
                const int r = l.px(hot ? 6 : 4.5), left = static_cast<int>(std::lround(handle.place.x)) - r, top = static_cast<int>(std::lround(handle.place.y)) - r;
                fl_color(hot ? theme().on_accent : fl_colour(axis_colours[static_cast<std::size_t>(row)]));
                if (row == axis) fl_rectf(left, top, 2 * r, 2 * r);
                else fl_pie(left, top, 2 * r, 2 * r, 0, 360);
            }
            fl_font(FL_HELVETICA, l.small_font());
            fl_color(theme().text);
            const Point2 out = all.tip(axis) - all.origin();
            if (glm::length(out) < l.px(20)) continue;
            const Point2 across = Point2(-out.y, out.x) / glm::length(out), at = all.origin() + 0.55 * out + double(l.px(9)) * across;
            const char letter[2] = {static_cast<char>('x' + axis), '\0'};
            fl_draw(letter, static_cast<int>(at.x) - l.px(3), static_cast<int>(at.y) + l.px(4));
        }
    }
    fl_pop_clip();
    fl_font(FL_HELVETICA, l.small_font());
    for (int row = 0; row < 3; ++row) {
        const Fl_Input& field = *fields_[static_cast<std::size_t>(3 * row)];
        const char letter[2] = {static_cast<char>('X' + row), '\0'};
        draw_text(letter, field.x() - l.px(14), field.y(), l.px(12), field.h(), fl_colour(axis_colours[static_cast<std::size_t>(row)]));
    }
    draw_children();
}

} // namespace druse::ui
