#include "ui/type_chooser.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/list_view.h"
#include "ui/panel.h"
#include "ui/scroll_bar.h"
#include "ui/theme.h"
#include "ui/type_picture.h"

#include <FL/Fl.H>
#include <FL/Fl_Box.H>
#include <FL/Fl_Button.H>
#include <FL/Fl_Check_Button.H>
#include <FL/Fl_Choice.H>
#include <FL/Fl_Double_Window.H>
#include <FL/fl_draw.H>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <utility>

namespace druse::ui {

namespace {

struct RotationWord {
    int rotations;
    const char* label;
};
constexpr std::array<RotationWord, 6> rotation_words{{
    {0, "anything"}, {1, "nothing"}, {2, "half turns"}, {3, "thirds of a turn"}, {4, "quarter turns"}, {6, "sixths of a turn"}}};

/// The types in rows; arrow keys go from one to the next, a click or Enter takes one.
class TypeGrid : public Panel {
public:
    static constexpr int columns = 9;

    TypeGrid(const std::string& current, int x, int y, int rows) : Panel(x, y, columns * cell_width() + layout().scrollbar(), rows * cell_height())
    {
        end();
        bar_.callback([](Fl_Widget* bar, void*) { bar->parent()->redraw(); });
        bar_.color(theme().sunken);
        add(bar_);
        for (const IsohedralType& type : isohedral_types())
            if (type.name() == current) marked_ = type.number;
        set_visible_focus();
        arrange();
    }

    std::optional<std::string> chosen;
    std::function<void(const IsohedralType&)> on_mark;

    void show_types(std::vector<int> numbers)
    {
        numbers_ = std::move(numbers);
        if (!numbers_.empty() && std::ranges::find(numbers_, marked_) == numbers_.end()) marked_ = numbers_[0];
        bar_.set((int(numbers_.size()) + columns - 1) / columns * cell_height(), cell_height() / 3);
        bar_.is_needed() ? bar_.show() : bar_.hide();
        show_marked();
    }

    int handle(int event) override
    {
        switch (event) {
        case FL_ENTER:
        case FL_FOCUS:
        case FL_UNFOCUS: return 1;
        case FL_MOVE:
            if (const int cell = cell_at(Fl::event_x(), Fl::event_y()); cell >= 0) mark(cell, false);
            return Panel::handle(event), 1;
        case FL_PUSH:
            if (Panel::handle(event)) return 1;
            take_focus();
            return 1;
        case FL_RELEASE:
            if (const int cell = cell_at(Fl::event_x(), Fl::event_y()); cell >= 0 && Fl::event_is_click()) take(cell);
            return 1;
        case FL_MOUSEWHEEL: return bar_.handle(event);
        case FL_KEYBOARD: return key(Fl::event_key()) ? 1 : 0;
        default: return Panel::handle(event);
        }
    }

protected:
    void arrange() override { bar_.resize(x() + w() - layout().scrollbar(), y(), layout().scrollbar(), h()); }

private:
    static int picture_size() { return layout().px(84); }
    static int cell_width() { return picture_size() + 2 * layout().gap(); }
    static int cell_height() { return picture_size() + 2 * layout().gap() + layout().small_font() + layout().px(4); }

    int cell_at(int px, int py) const
    {
        if (px < x() || py < y() || px >= x() + columns * cell_width() || py >= y() + h()) return -1;
        const int cell = (py - y() + bar_.top()) / cell_height() * columns + (px - x()) / cell_width();
        return cell < int(numbers_.size()) ? cell : -1;
    }

    int marked_cell() const { return int(std::ranges::find(numbers_, marked_) - numbers_.begin()); }

    void mark(int cell, bool scroll)
    {
        if (numbers_.empty()) return;
        marked_ = numbers_[std::size_t(std::clamp(cell, 0, int(numbers_.size()) - 1))];
        if (scroll) show_marked();
        redraw();
        if (on_mark) on_mark(isohedral_type(marked_));
    }

    void show_marked()
    {
        if (numbers_.empty()) return redraw();
        const int top = marked_cell() / columns * cell_height();
        if (top < bar_.top()) bar_.set_top(top);
        else if (top + cell_height() > bar_.top() + h()) bar_.set_top(top + cell_height() - h());
        redraw();
        if (on_mark) on_mark(isohedral_type(marked_));
    }

    void take(int cell)
    {
        if (numbers_.empty()) return;
        chosen = isohedral_type(numbers_[std::size_t(cell)]).name();
        window()->hide();
    }

    bool key(int key)
    {
        const int here = marked_cell(), last = int(numbers_.size()) - 1;
        switch (key) {
        case FL_Home: mark(0, true); return true;
        case FL_End: mark(last, true); return true;
        case FL_Left: mark(here - 1, true); return true;
        case FL_Right: mark(here + 1, true); return true;
        case FL_Up: mark(here >= columns ? here - columns : here, true); return true;
        case FL_Down: mark(here + columns <= last ? here + columns : here, true); return true;
        case FL_Enter:
        case FL_KP_Enter: take(here); return true;
        default: return false;
        }
    }

    const Image& picture(int number)
    {
        Image& image = pictures_[number];
        if (image.pixels.empty()) image = type_picture(isohedral_type(number), picture_size());
        return image;
    }

    void draw() override
    {
        fl_push_clip(x(), y(), w(), h());
        fl_color(theme().sunken);
        fl_rectf(x(), y(), w(), h());
        fl_font(FL_HELVETICA, layout().small_font());
        for (int i = 0; i < int(numbers_.size()); ++i) {
            const int left = x() + i % columns * cell_width(), top = y() + i / columns * cell_height() - bar_.top();
            if (top + cell_height() <= y() || top >= y() + h()) continue;
            const int number = numbers_[std::size_t(i)];
            const bool here = number == marked_;
            if (here) {
                fl_color(theme().accent);
                fl_rectf(left, top, cell_width(), cell_height());
            }
            const Image& image = picture(number);
            fl_draw_image(&image.pixels.front().red, left + layout().gap(), top + layout().gap(), image.width, image.height, int(sizeof(Pixel)));
            draw_text(isohedral_type(number).name(), left, top + layout().gap() + picture_size(), cell_width(), layout().small_font() + layout().px(6),
                      here ? theme().on_accent : theme().text, FL_ALIGN_CENTER);
        }
        if (numbers_.empty()) {
            fl_font(FL_HELVETICA, layout().font());
            draw_text("No type does that.", x(), y(), w(), h(), theme().faint_text, FL_ALIGN_CENTER);
        }
        fl_pop_clip();
        if (bar_.visible()) draw_child(bar_);
    }

    std::vector<int> numbers_;
    int marked_ = 0;
    std::map<int, Image> pictures_;
    ScrollBar bar_;
};

/// `IH79: triangle, edges a+ b+ ar, group p4, 4 tiles in a cell`.
std::string description(const IsohedralType& type)
{
    constexpr std::array<const char*, 7> shapes{"", "", "", "triangle", "quadrilateral", "pentagon", "hexagon"};
    std::string text = fmt::format("{}: {}, edges {}, group {}, {} {} in a cell", type.name(), shapes[std::size_t(type.corners)], type.edge_text(),
                                   name(type.placed, type.start), type.aspects(), type.aspects() == 1 ? "tile" : "tiles");
    if (!type.parameters.empty()) text += fmt::format(", {} free {}", type.parameters.size(), type.parameters.size() == 1 ? "coordinate" : "coordinates");
    if (type.has_mirrored_aspects()) text += ", some mirrored";
    return text;
}

} // namespace

std::vector<int> types_that_pass(const TypeFilter& filter)
{
    std::vector<int> numbers;
    for (const IsohedralType& type : isohedral_types())
        if ((filter.rotations == 0 || rotations_of(type) == filter.rotations) && !(filter.no_mirrored && type.has_mirrored_aspects()))
            numbers.push_back(type.number);
    return numbers;
}

std::optional<std::string> choose_tile_type(const std::string& current)
{
    const Layout& l = layout();
    Fl_Group::current(nullptr);
    Fl_Double_Window window(1, 1, "Tile type");
    const int row = l.button_height(), top = l.margin() + row + l.margin(), label = l.px(150);
    constexpr int rows = 5;
    TypeGrid grid(current, l.margin(), top, rows);
    window.size(grid.w() + 2 * l.margin(), top + grid.h() + 2 * l.margin() + row);
    Fl_Box question(l.margin(), l.margin(), label, row, "What should rotate?");
    Fl_Choice rotations(question.x() + label, l.margin(), l.px(180), row);
    Fl_Check_Button plain(rotations.x() + rotations.w() + 2 * l.margin(), l.margin(), l.px(260), row, "no mirrored tiles");
    Fl_Button cancel(window.w() - l.margin() - l.px(90), window.h() - l.margin() - row, l.px(90), row, "Cancel");
    Fl_Box facts(l.margin(), cancel.y(), cancel.x() - 2 * l.margin(), row);
    window.end();
    window.color(theme().window);
    cancel.color(theme().raised);
    rotations.color(theme().raised);
    rotations.textsize(l.font());
    plain.down_box(FL_DOWN_BOX);
    plain.color(theme().sunken);
    plain.selection_color(theme().accent);
    for (Fl_Widget* text : std::initializer_list<Fl_Widget*>{&question, &facts}) text->align(FL_ALIGN_LEFT | FL_ALIGN_INSIDE | FL_ALIGN_CLIP);
    for (const RotationWord& word : rotation_words) rotations.add(word.label);
    rotations.value(0);
    question.tooltip("About some points the whole pattern turns into itself");
    plain.tooltip("Only types whose tiles can all be laid without turning one over");

    grid.on_mark = [&](const IsohedralType& type) { facts.copy_label(description(type).c_str()); };
    std::function<void()> filter = [&] {
        const TypeFilter asked{rotation_words[std::size_t(std::max(rotations.value(), 0))].rotations, plain.value() != 0};
        grid.show_types(types_that_pass(asked));
    };
    const auto refilter = [](Fl_Widget*, void* run) { (*static_cast<std::function<void()>*>(run))(); };
    rotations.callback(refilter, &filter);
    plain.callback(refilter, &filter);
    cancel.callback([](Fl_Widget* button, void*) { button->window()->hide(); });
    filter();

    window.set_modal();
    if (const Fl_Window* main = Fl::first_window())
        window.position(std::max(0, main->x_root() + (main->w() - window.w()) / 2), std::max(0, main->y_root() + (main->h() - window.h()) / 2));
    window.show();
    grid.take_focus();
    while (window.shown()) Fl::wait();
    Fl::flush();
    return grid.chosen;
}

} // namespace druse::ui
