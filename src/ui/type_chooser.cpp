#include "ui/type_chooser.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/picture_grid.h"
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

/// Types by a picture of each.
class TypeGrid : public PictureGrid {
public:
    TypeGrid(const std::string& current, int x, int y, int rows) : PictureGrid(x, y, columns, rows, cell_width(), cell_height())
    {
        for (const IsohedralType& type : isohedral_types())
            if (type.name() == current) last_ = type.number;
    }

    void show_types(std::vector<int> numbers)
    {
        numbers_ = std::move(numbers);
        const auto place = std::ranges::find(numbers_, last_);
        set_cells(int(numbers_.size()), place == numbers_.end() ? 0 : int(place - numbers_.begin()));
    }

    const IsohedralType& marked_type()
    {
        last_ = numbers_[std::size_t(marked())];
        return isohedral_type(last_);
    }
    std::optional<std::string> chosen_name() const
    {
        return chosen() ? std::optional(isohedral_type(numbers_[std::size_t(*chosen())]).name()) : std::nullopt;
    }

private:
    static constexpr int columns = 9;
    static int picture_size() { return layout().px(84); }
    static int cell_width() { return picture_size() + 2 * layout().gap(); }
    static int cell_height() { return picture_size() + 2 * layout().gap() + layout().small_font() + layout().px(4); }

    void draw_cell(int cell, int left, int top, bool is_marked) override
    {
        const int number = numbers_[std::size_t(cell)];
        Image& image = pictures_[number];
        if (image.pixels.empty()) image = type_picture(isohedral_type(number), picture_size());
        fl_draw_image(&image.pixels.front().red, left + layout().gap(), top + layout().gap(), image.width, image.height, int(sizeof(Pixel)));
        draw_text(isohedral_type(number).name(), left, top + layout().gap() + picture_size(), cell_width(), layout().small_font() + layout().px(6),
                  is_marked ? theme().on_accent : theme().text, FL_ALIGN_CENTER);
    }
    const char* nothing() const override { return "No type does that."; }

    std::vector<int> numbers_;
    int last_ = 0; // the number that is marked, or was before others were shown
    std::map<int, Image> pictures_;
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

    grid.on_mark = [&] { facts.copy_label(description(grid.marked_type()).c_str()); };
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
    return grid.chosen_name();
}

} // namespace druse::ui
