#include "ui/source_bar.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/fl_draw.H>

#include <algorithm>
#include <utility>

namespace druse::ui {

SourceBar::SourceBar(const char* tip, const char* invitation, int width) : Panel(0, 0, 1, 1), type_(invitation), type_width_(width)
{
    end();
    type_.tooltip(tip);
    type_.clear_visible_focus();
    type_.callback([](Fl_Widget*, void* p) {
        if (const auto& act = static_cast<SourceBar*>(p)->on_type) act();
    }, this);
    add(type_);
}

void SourceBar::add_button(const char* label, const char* tip, std::function<void()> press, std::function<bool()> is_on, bool apart, bool at_end)
{
    Fl_Group::current(nullptr);
    items_.push_back({std::make_unique<Fl_Button>(0, 0, 1, 1, label), std::move(press), std::move(is_on), apart, at_end});
    Fl_Button& button = *items_.back().button;
    button.tooltip(tip);
    button.labelsize(layout().small_font());
    button.clear_visible_focus();
    button.callback([](Fl_Widget* widget, void* p) {
        auto* bar = static_cast<SourceBar*>(p);
        for (const Item& item : bar->items_)
            if (item.button.get() == widget) {
                item.press();
                break;
            }
        bar->refresh();
    }, this);
    add(button);
}

void SourceBar::set_type(const std::string& name, const std::function<Image(int height)>& make_picture) { type_.set_type(name, make_picture); }

void SourceBar::refresh()
{
    for (const Item& item : items_) {
        const bool on = item.is_on && item.is_on(), main = item.at_end;
        item.button->color(on || main ? theme().accent : theme().raised);
        item.button->labelcolor(on || main ? theme().on_accent : theme().text);
    }
    redraw();
}

void SourceBar::arrange()
{
    const Layout& l = layout();
    fl_font(FL_HELVETICA, l.small_font());
    const int height = l.button_height(), top = y() + (h() - height) / 2;
    // In a narrow window labels have less room around them, and the type has no more than is left.
    const auto room_for = [&](int pad) {
        int room = 2 * l.margin() + l.px(type_width_);
        for (const Item& item : items_) room += static_cast<int>(fl_width(item.button->label())) + 2 * pad + (item.at_end ? 2 * l.gap() : item.apart ? pad + l.gap() : 0);
        return room;
    };
    int pad = l.margin();
    while (pad > l.px(2) && room_for(pad) > w()) --pad;
    type_.resize(x() + l.margin(), top, std::clamp(l.px(type_width_) - (room_for(pad) - w()), l.px(70), l.px(type_width_)), height);
    int left = type_.x() + type_.w(), right = x() + w() - l.margin();
    for (const Item& item : items_) {
        const int width = static_cast<int>(fl_width(item.button->label())) + 2 * pad;
        if (item.at_end) {
            item.button->resize(right - width, top, width, height);
            right -= width + l.gap();
        } else {
            if (item.apart) left += pad + l.gap();
            item.button->resize(left, top, width, height);
            left += width - 1; // neighbours share a border
        }
    }
}

void SourceBar::draw()
{
    fl_color(theme().header);
    fl_rectf(x(), y(), w(), h());
    fl_color(theme().border);
    fl_xyline(x(), y() + h() - 1, x() + w() - 1);
    draw_children();
}

void SourceBar::TypeButton::set_type(const std::string& name, const std::function<Image(int height)>& make_picture)
{
    if (name == name_) return;
    name_ = name;
    picture_ = name.empty() ? Image() : make_picture(layout().button_height() - 4);
    redraw();
}

void SourceBar::TypeButton::draw()
{
    draw_box(value() ? FL_DOWN_BOX : FL_UP_BOX, theme().raised);
    int left = x() + layout().gap();
    if (picture_.width > 0) {
        fl_draw_image(&picture_.pixels.front().red, x() + 2, y() + 2, picture_.width, picture_.height, int(sizeof(Pixel)), 0);
        left = x() + 2 + picture_.width + layout().gap();
    }
    fl_font(FL_HELVETICA, layout().font());
    const int arrow = layout().px(14);
    draw_text(name_.empty() ? invitation_ : name_, left, y(), x() + w() - left - arrow, h(), theme().text);
    draw_chevron(x() + w() - arrow - layout().px(2), y() + (h() - layout().px(12)) / 2, layout().px(12), true, theme().faint_text);
}

} // namespace druse::ui
