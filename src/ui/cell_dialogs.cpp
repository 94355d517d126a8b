#include "ui/cell_dialogs.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/picture_grid.h"
#include "ui/question.h"
#include "ui/theme.h"

#include "app/command.h"

#include <FL/Fl.H>
#include <FL/Fl_Choice.H>
#include <FL/Fl_Input.H>
#include <FL/Fl_Return_Button.H>
#include <FL/fl_ask.H>
#include <FL/fl_draw.H>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace druse::ui {

namespace {

constexpr std::array cell_kinds{CellKind::bcc, CellKind::fcc, CellKind::cube, CellKind::hexprism, CellKind::elongated};

/// A flat picture of a parallelohedron, its visible panes in shades. It needs no context of OpenGL.
void draw_cell_picture(CellKind kind, int x, int y, int size)
{
    const Parallelohedron cell = make_parallelohedron(kind, 1, 1);
    const Vector back = glm::normalize(Vector(0.42, -0.8, 0.45)), right = glm::normalize(glm::cross(Vector(0, 0, 1), back)), up = glm::cross(back, right);
    const auto seen = [&](const Point& p) { return Point2(glm::dot(p, right), -glm::dot(p, up)); };
    double radius = 0;
    for (const Parallelohedron::Corner& corner : cell.corners)
        for (const LatticeStep& step : corner.members) radius = std::max(radius, glm::length(seen(corner.place + cell.at(step))));
    const double scale = 0.5 * size / radius;
    const Point2 middle(x + 0.5 * size, y + 0.5 * size);
    for (const CellPane& pane : cell.panes)
        for (const bool far : {false, true}) {
            const double facing = (far ? -1 : 1) * glm::dot(pane.normal, back);
            if (facing <= 1e-6) continue;
            const Vector light = glm::normalize(Vector(0.1, -0.5, 0.9));
            const double shade = 0.45 + 0.5 * std::max(0.0, (far ? -1 : 1) * glm::dot(pane.normal, light));
            const auto corner = [&](const OrbitMember& c) { return middle + scale * seen(cell.corner(c) - (far ? cell.at(pane.translation) : Vector(0.0))); };
            const auto channel = [&](int full) { return static_cast<uchar>(std::lround(shade * full)); };
            fl_color(fl_rgb_color(channel(0xd9), channel(0xa0), channel(0x5e)));
            fl_begin_polygon(); // convex
            for (const OrbitMember& c : pane.corners) fl_vertex(corner(c).x, corner(c).y);
            fl_end_polygon();
            fl_color(fl_rgb_color(0x14, 0x15, 0x1a));
            fl_begin_loop();
            for (const OrbitMember& c : pane.corners) fl_vertex(corner(c).x, corner(c).y);
            fl_end_loop();
        }
}

/// The cells by a picture of each.
class CellGrid : public PictureGrid {
public:
    CellGrid(std::optional<CellKind> current, int x, int y) : PictureGrid(x, y, int(cell_kinds.size()), 1, cell_width(), cell_height())
    {
        const auto here = current ? std::ranges::find(cell_kinds, *current) : cell_kinds.begin();
        set_cells(int(cell_kinds.size()), int(here - cell_kinds.begin()));
    }
    std::optional<CellKind> chosen_kind() const { return chosen() ? std::optional(cell_kinds[std::size_t(*chosen())]) : std::nullopt; }
    CellKind marked_kind() const { return cell_kinds[std::size_t(marked())]; }

private:
    static int picture_size() { return layout().px(96); }
    static int cell_width() { return picture_size() + layout().px(40); }
    static int cell_height() { return picture_size() + 3 * layout().gap() + 2 * layout().small_font(); }

    void draw_cell(int cell, int left, int top, bool is_marked) override
    {
        const CellKind kind = cell_kinds[std::size_t(cell)];
        draw_cell_picture(kind, left + (cell_width() - picture_size()) / 2, top + layout().gap(), picture_size());
        const std::string title = cell_title(kind);
        const std::size_t middle = title.find(' ');
        const int line = layout().small_font() + 1, below = top + 2 * layout().gap() + picture_size();
        const Fl_Color colour = is_marked ? theme().on_accent : theme().text;
        draw_text(title.substr(0, middle), left, below, cell_width(), line, colour, FL_ALIGN_CENTER);
        if (middle != std::string::npos) draw_text(title.substr(middle + 1), left, below + line, cell_width(), line, colour, FL_ALIGN_CENTER);
    }
};

} // namespace

const char* cell_title(CellKind kind)
{
    switch (kind) {
    case CellKind::bcc: return "Truncated octahedron";
    case CellKind::fcc: return "Rhombic dodecahedron";
    case CellKind::cube: return "Cube";
    case CellKind::hexprism: return "Hexagonal prism";
    case CellKind::elongated: break;
    }
    return "Elongated dodecahedron";
}

std::optional<CellKind> choose_cell_kind(std::optional<CellKind> current)
{
    const Layout& l = layout();
    Fl_Group::current(nullptr);
    Fl_Double_Window window(1, 1, "Cell");
    CellGrid grid(current, l.margin(), l.margin());
    window.size(grid.w() + 2 * l.margin(), grid.h() + 3 * l.margin() + l.button_height());
    Fl_Button cancel(window.w() - l.margin() - l.px(90), grid.h() + 2 * l.margin(), l.px(90), l.button_height(), "Cancel");
    Fl_Box facts(l.margin(), cancel.y(), cancel.x() - 2 * l.margin(), cancel.h());
    window.end();
    window.color(theme().window);
    cancel.color(theme().raised);
    facts.align(FL_ALIGN_LEFT | FL_ALIGN_INSIDE | FL_ALIGN_CLIP);
    grid.on_mark = [&] {
        const Parallelohedron cell = make_parallelohedron(grid.marked_kind(), 1, 1);
        facts.copy_label(fmt::format("{}: {} pairs of panes, {} orbits of edges, {} of corners", name(grid.marked_kind()), cell.panes.size(), cell.edges.size(),
                                     cell.corners.size()).c_str());
    };
    grid.on_mark();
    cancel.callback([](Fl_Widget* button, void*) { button->window()->hide(); });
    window.set_modal();
    if (const Fl_Window* main = Fl::first_window())
        window.position(std::max(0, main->x_root() + (main->w() - window.w()) / 2), std::max(0, main->y_root() + (main->h() - window.h()) / 2));
    window.show();
    grid.take_focus();
    while (window.shown()) Fl::wait();
    Fl::flush();
    return grid.chosen_kind();
}

std::optional<TileExport> ask_how_to_export_cell(const std::vector<StatusPart>& facts)
{
    const Layout& l = layout();
    const int label = l.px(150), width = l.px(470), field = l.px(150), lines = int(facts.size());
    Fl_Group::current(nullptr);
    Question window(width, 3 + lines, "Export cell");
    for (int i = 0; i < lines; ++i) {
        Fl_Box* fact = Question::add_label(i, width - 2 * l.margin(), "");
        fact->copy_label(facts[std::size_t(i)].text.c_str());
        fact->labelcolor(facts[std::size_t(i)].warns ? theme().amber : theme().faint_text);
    }
    Question::add_label(lines, label, "clearance");
    Question::add_label(lines + 1, label, "method");
    Fl_Input clearance(l.margin() + label, Question::top(lines), field, l.button_height());
    Fl_Choice method(clearance.x(), Question::top(lines + 1), field, l.button_height());
    const int buttons = l.px(185), small = l.px(80);
    Fl_Return_Button ok(width - l.margin() - buttons, Question::top(lines + 2), buttons, l.button_height(), "To the main window");
    Fl_Button file(ok.x() - l.gap() - l.px(120), ok.y(), l.px(120), ok.h(), "To a file…"), cancel(file.x() - l.gap() - small, ok.y(), small, ok.h(), "Cancel");
    window.end();
    clearance.value("0");
    clearance.tooltip("How far joints open, in model units: 0.2 to 0.4 for prints of molten plastic");
    for (const char* word : {"inset", "shrink"}) method.add(word);
    method.value(0);
    method.color(theme().raised);
    method.tooltip("inset: the surface moves inside; shrink: the cell is scaled about its centre of mass, which is uneven");
    file.color(theme().raised);
    bool to_file = false;
    file.callback([](Fl_Widget* button, void* flag) {
        *static_cast<bool*>(flag) = true;
        button->window()->hide();
    }, &to_file);
    if (!window.ask(ok, cancel) && !to_file) return {};
    std::string command = "cell.solid";
    const std::string gap = clearance.value();
    if (!gap.empty() && gap != "0") command += " " + argument_text("clearance", gap);
    if (method.value() > 0) command += fmt::format(" method={}", method.text());
    return TileExport{command, to_file};
}

PaneShape shape_of(const CellTile& cell, int pane)
{
    PaneShape shape;
    for (int point = 0; point < cell.point_count(); ++point) {
        if (cell.pane_of(point) != pane) continue;
        if (cell.name(point).kind == CellPointName::Kind::split) ++shape.splits;
        else if (cell.moved(point) != Vector(0.0)) ++shape.moved;
    }
    for (const CellDetail& detail : cell.design().details) shape.flips += detail.kind == CellDetail::Kind::flip && detail.pane == pane;
    return shape;
}

std::string roll_back_question(int pane, const PaneShape& shape)
{
    const auto count = [](int n, const char* one, const char* more) { return fmt::format("\n{} {}", n, n == 1 ? one : more); };
    std::string text = fmt::format("Pane {} becomes flat again, to edit its points and lines.", pane);
    if (shape.moved > 0) text += count(shape.moved, "of its points was moved; begun anew, it forgets that.", "of its points were moved; begun anew, it forgets that.");
    if (shape.splits > 0) text += count(shape.splits, "point that a split made goes.", "points that splits made go.");
    if (shape.flips > 0) text += count(shape.flips, "edge that was flipped turns back.", "edges that were flipped turn back.");
    return text;
}

RollBack ask_how_to_roll_back(int pane, const PaneShape& shape)
{
    const std::string text = roll_back_question(pane, shape);
    const int answer = shape.moved > 0 ? fl_choice("%s", "Cancel", "Keep what was moved", "Begin anew", text.c_str()) : fl_choice("%s", "Cancel", "Make it flat", nullptr, text.c_str());
    return answer == 1 ? RollBack::keep : answer == 2 ? RollBack::anew : RollBack::cancel;
}

} // namespace druse::ui
