#include "ui/solid_gallery.h"

#include "ui/dialogs.h"
#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/picture_grid.h"
#include "ui/theme.h"

#include "dlfl/errors.h"
#include "ops/solid.h"

#include <FL/Fl.H>
#include <FL/Fl_Box.H>
#include <FL/Fl_Button.H>
#include <FL/Fl_Double_Window.H>
#include <FL/fl_draw.H>

#include <algorithm>
#include <functional>
#include <utility>

namespace druse::ui {

namespace {

/// The solids by a picture of each.
class SolidGrid : public PictureGrid {
public:
    SolidGrid(Pictures& pictures, const std::vector<std::string>& solids, const std::string& current, int x, int y)
        : PictureGrid(x, y, columns(), (int(solids.size()) + columns() - 1) / columns(), cell_width(), cell_height()), pictures_(pictures), solids_(solids)
    {
        const auto here = std::ranges::find(solids_, current);
        set_cells(int(solids_.size()), here == solids_.end() ? 0 : int(here - solids_.begin()));
    }

    const std::string& marked_solid() const { return solids_[std::size_t(marked())]; }
    std::optional<std::string> chosen_solid() const { return chosen() ? std::optional(solids_[std::size_t(*chosen())]) : std::nullopt; }

private:
    static int columns() { return layout().gallery_columns(); }
    static int cell_width() { return layout().picture() + layout().px(32); }
    static int cell_height() { return layout().picture() + 2 * layout().gap() + 2 * layout().small_font(); }

    void draw_cell(int cell, int left, int top, bool is_marked) override
    {
        const std::string& name = solids_[std::size_t(cell)];
        if (Fl_RGB_Image* picture = pictures_.find(name, layout().picture())) picture->draw(left + (cell_width() - picture->w()) / 2, top + layout().gap());
        draw_name(name, left + layout().gap() / 2, top + layout().gap() + layout().picture(), cell_width() - layout().gap(),
                  is_marked ? theme().on_accent : theme().text);
    }

    /// In two lines, where it has two words.
    static void draw_name(std::string name, int x, int y, int w, Fl_Color colour)
    {
        const std::size_t middle = name.find('_');
        std::ranges::replace(name, '_', ' ');
        const int line = layout().small_font() + 1;
        if (middle == std::string::npos) {
            draw_text(name, x, y, w, line, colour, FL_ALIGN_CENTER);
        } else {
            draw_text(name.substr(0, middle), x, y, w, line, colour, FL_ALIGN_CENTER);
            draw_text(name.substr(middle + 1), x, y + line, w, line, colour, FL_ALIGN_CENTER);
        }
    }

    Pictures& pictures_;
    const std::vector<std::string>& solids_;
};

} // namespace

std::vector<std::string> gallery_solids()
{
    std::vector<std::string> names;
    for (const std::string& name : solid_names()) {
        if (!name.ends_with(":N")) {
            names.push_back(name);
            continue;
        }
        for (int n = 3; n <= 6; ++n) try {
                const std::string member = name.substr(0, name.size() - 1) + std::to_string(n);
                make_solid(member, 1.0);
                names.push_back(member);
            } catch (const CommandError&) { // the family has none with so many sides
            }
    }
    return names;
}

std::optional<std::string> choose_solid(Pictures& pictures, const std::string& current)
{
    const Layout& l = layout();
    Fl_Group::current(nullptr);
    Fl_Double_Window window(1, 1, "Solids");
    const std::vector<std::string> solids = gallery_solids();
    SolidGrid grid(pictures, solids, current, l.margin(), l.margin());
    window.size(grid.w() + 2 * l.margin(), grid.h() + 3 * l.margin() + l.button_height());
    Fl_Button file(l.margin(), window.h() - l.margin() - l.button_height(), l.px(90), l.button_height(), "File…");
    Fl_Button cancel(window.w() - l.margin() - l.px(90), file.y(), l.px(90), l.button_height(), "Cancel");
    Fl_Box name(file.x() + file.w(), file.y(), cancel.x() - file.x() - file.w(), file.h());
    window.end();
    window.color(theme().window);
    grid.on_mark = [&] { name.copy_label(grid.marked_solid().c_str()); }; // there is more room for it than in the grid
    grid.on_mark();
    for (Fl_Button* button : {&file, &cancel}) button->color(theme().raised);
    file.tooltip("A closed solid in a mesh file");

    bool ask_for_file = false;
    file.callback([](Fl_Widget* button, void* flag) {
        *static_cast<bool*>(flag) = true;
        button->window()->hide();
    }, &ask_for_file);
    cancel.callback([](Fl_Widget* button, void*) { button->window()->hide(); });

    const auto redraw_window = std::exchange(pictures.on_ready, [&grid] { grid.redraw(); });
    window.set_modal();
    if (const Fl_Window* main = Fl::first_window())
        window.position(main->x_root() + (main->w() - window.w()) / 2, main->y_root() + (main->h() - window.h()) / 2);
    window.show();
    grid.take_focus();
    while (window.shown()) Fl::wait();
    Fl::flush(); // the display lets the window go before what was chosen has any effect
    pictures.on_ready = redraw_window;
    if (redraw_window) redraw_window();

    if (!ask_for_file) return grid.chosen_solid();
    const auto path = ask_for_model("A solid");
    return path ? std::optional(path->string()) : std::nullopt;
}

} // namespace druse::ui
