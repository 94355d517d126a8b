#include "ui/solid_gallery.h"

#include "ui/dialogs.h"
#include "ui/draw.h"
#include "ui/layout.h"
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

/// The solids in rows; arrow keys go from one to the next, a click or Enter takes one.
class Grid : public Fl_Widget {
public:
    Grid(Pictures& pictures, const std::string& current, int x, int y)
        : Fl_Widget(x, y, 1, 1), pictures_(pictures), solids_(gallery_solids())
    {
        const auto here = std::ranges::find(solids_, current);
        marked_ = here == solids_.end() ? 0 : int(here - solids_.begin());
        const int rows = (int(solids_.size()) + columns() - 1) / columns();
        size(columns() * cell_width(), rows * cell_height());
        set_visible_focus();
    }

    std::optional<std::string> chosen;
    std::function<void()> on_mark;
    const std::string& marked() const { return solids_[std::size_t(marked_)]; }

    int handle(int event) override
    {
        switch (event) {
        case FL_ENTER:
        case FL_FOCUS:
        case FL_UNFOCUS: return 1;
        case FL_MOVE:
            if (const int cell = cell_at(Fl::event_x(), Fl::event_y()); cell >= 0) mark(cell);
            return 1;
        case FL_PUSH: return 1;
        case FL_RELEASE:
            if (const int cell = cell_at(Fl::event_x(), Fl::event_y()); cell >= 0) take(cell);
            return 1;
        case FL_KEYBOARD: return key(Fl::event_key()) ? 1 : 0;
        default: return Fl_Widget::handle(event);
        }
    }

private:
    static int columns() { return layout().gallery_columns(); }
    static int cell_width() { return layout().picture() + layout().px(32); }
    static int cell_height() { return layout().picture() + 2 * layout().gap() + 2 * layout().small_font(); }

    int cell_at(int px, int py) const
    {
        const int column = (px - x()) / cell_width(), row = (py - y()) / cell_height();
        if (px < x() || py < y() || column >= columns()) return -1;
        const int cell = row * columns() + column;
        return cell < int(solids_.size()) ? cell : -1;
    }

    void mark(int cell)
    {
        if (cell == marked_) return;
        marked_ = cell;
        redraw();
        if (on_mark) on_mark();
    }

    void take(int cell)
    {
        chosen = solids_[std::size_t(cell)];
        window()->hide();
    }

    bool key(int key)
    {
        const int last = int(solids_.size()) - 1;
        switch (key) {
        case FL_Home: mark(0); return true;
        case FL_End: mark(last); return true;
        case FL_Left: mark(std::max(marked_ - 1, 0)); return true;
        case FL_Right: mark(std::min(marked_ + 1, last)); return true;
        case FL_Up: mark(marked_ >= columns() ? marked_ - columns() : marked_); return true;
        case FL_Down: mark(marked_ + columns() <= last ? marked_ + columns() : marked_); return true;
        case FL_Enter:
        case FL_KP_Enter: take(marked_); return true;
        default: return false;
        }
    }

    void draw() override
    {
        fl_color(theme().sunken);
        fl_rectf(x(), y(), w(), h());
        fl_font(FL_HELVETICA, layout().small_font());
        for (int i = 0; i < int(solids_.size()); ++i) {
            const int left = x() + i % columns() * cell_width(), top = y() + i / columns() * cell_height();
            if (i == marked_) {
                fl_color(theme().accent);
                fl_rectf(left, top, cell_width(), cell_height());
            }
            const std::string& name = solids_[std::size_t(i)];
            if (Fl_RGB_Image* picture = pictures_.find(name, layout().picture()))
                picture->draw(left + (cell_width() - picture->w()) / 2, top + layout().gap());
            draw_name(name, left + layout().gap() / 2, top + layout().gap() + layout().picture(), cell_width() - layout().gap(),
                      i == marked_ ? theme().on_accent : theme().text);
        }
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
    std::vector<std::string> solids_;
    int marked_ = 0;
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
    Grid grid(pictures, current, l.margin(), l.margin());
    window.size(grid.w() + 2 * l.margin(), grid.h() + 3 * l.margin() + l.button_height());
    Fl_Button file(l.margin(), window.h() - l.margin() - l.button_height(), l.px(90), l.button_height(), "File…");
    Fl_Button cancel(window.w() - l.margin() - l.px(90), file.y(), l.px(90), l.button_height(), "Cancel");
    Fl_Box name(file.x() + file.w(), file.y(), cancel.x() - file.x() - file.w(), file.h());
    window.end();
    window.color(theme().window);
    grid.on_mark = [&] { name.copy_label(grid.marked().c_str()); }; // there is more room for it than in the grid
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

    if (!ask_for_file) return grid.chosen;
    const auto path = ask_for_model("A solid");
    return path ? std::optional(path->string()) : std::nullopt;
}

} // namespace druse::ui
