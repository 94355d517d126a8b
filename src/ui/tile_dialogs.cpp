#include "ui/tile_dialogs.h"

#include "ui/dialogs.h"
#include "ui/layout.h"
#include "ui/question.h"
#include "ui/slider.h"
#include "ui/theme.h"

#include "app/command.h"
#include "render/png.h"

#include <FL/Fl.H>
#include <FL/Fl_Box.H>
#include <FL/Fl_Button.H>
#include <FL/Fl_Choice.H>
#include <FL/Fl_Double_Window.H>
#include <FL/Fl_Input.H>
#include <FL/Fl_Native_File_Chooser.H>
#include <FL/Fl_Return_Button.H>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

namespace druse::ui {

namespace {

std::optional<std::string> ask_for_picture()
{
    Fl_Native_File_Chooser chooser(Fl_Native_File_Chooser::BROWSE_FILE);
    chooser.title("Tracing image");
    chooser.filter("PNG picture\t*.png");
    if (chooser.show() != 0) return {};
    try {
        read_png(chooser.filename());
        return std::filesystem::absolute(chooser.filename()).lexically_normal().string();
    } catch (const std::exception& e) {
        show_failure(e.what());
        return {};
    }
}

/// How a picture lies that is neither mirrored nor slanted.
struct Laid {
    double width = 1, turn = 0; // units, degrees
    Point2 centre{0.0};

    /// `height`: of the picture, in its widths.
    static Laid of(const std::array<double, 6>& p, double height)
    {
        const Point2 across(p[0], p[3]), up(p[1], p[4]);
        return {glm::length(across), std::atan2(across.y, across.x) * (180 / std::numbers::pi), Point2(p[2], p[5]) + 0.5 * across + 0.5 * height * up};
    }
    std::array<double, 6> place(double height) const
    {
        const double a = turn * (std::numbers::pi / 180);
        const Point2 across = width * Point2(std::cos(a), std::sin(a)), up(-across.y, across.x);
        const Point2 corner = centre - 0.5 * across - 0.5 * height * up;
        return {across.x, up.x, corner.x, across.y, up.y, corner.y};
    }
};

/// What a command says of it. Files in the folder of the document are named from there.
std::string trace_command(const TileTrace& trace, const std::filesystem::path& folder)
{
    const std::filesystem::path near = std::filesystem::path(trace.image).lexically_proximate(std::filesystem::absolute(folder).lexically_normal());
    const std::string name = near.begin() == near.end() || *near.begin() == ".." ? trace.image : near.string();
    std::string place;
    for (const double x : trace.place) place += fmt::format("{}{:.6g}", place.empty() ? "" : ",", x + 0.0);
    return fmt::format("tile.trace {} place={} opacity={:.3g}", argument_text("image", name), place, trace.opacity);
}

} // namespace

std::optional<std::string> ask_for_trace(TileView& view, const std::filesystem::path& folder)
{
    const ShownTile& shape = view.tile();
    const Point2 low = shape.low(), high = shape.high();
    const double size = std::max(1e-6, std::max(high.x - low.x, high.y - low.y));
    const std::optional<TileTrace> before = shape.look.trace;
    TileTrace trace = before.value_or(TileTrace());
    const auto height = [&view] { return view.picture() ? double(view.picture()->height) / view.picture()->width : 1.0; };
    if (!before) {
        const auto file = ask_for_picture();
        if (!file) return {};
        trace.image = *file;
        view.try_trace(trace); // which says how high it is
        trace.place = Laid{size, 0, 0.5 * (low + high)}.place(height());
        view.try_trace(trace);
    }
    Laid laid = Laid::of(trace.place, height());

    const Layout& l = layout();
    const int label = l.px(80), width = l.px(360);
    Fl_Group::current(nullptr);
    Question window(width, 5, "Tracing image");
    Question::add_label(0, label, "opacity");
    Question::add_label(1, label, "width");
    Question::add_label(2, label, "turn");
    const auto slider_at = [&](int line) { return std::make_unique<Slider>(l.margin() + label, Question::top(line), width - 2 * l.margin() - label, l.button_height()); };
    const auto opacity = slider_at(0), scale = slider_at(1), turn = slider_at(2);
    Fl_Button other(l.margin(), Question::top(3), l.px(100), l.button_height(), "File…"), none(other.x() + other.w() + l.gap(), other.y(), l.px(100), other.h(), "No image");
    const int buttons = l.px(90);
    Fl_Return_Button ok(width - l.margin() - buttons, Question::top(4), buttons, l.button_height(), "OK");
    Fl_Button cancel(ok.x() - l.gap() - buttons, ok.y(), buttons, ok.h(), "Cancel");
    window.end();
    opacity->set_range(0, 1, 0.05);
    scale->set_range(0.2 * size, 5 * size, 0.05 * size);
    turn->set_range(-180, 180, 5);
    opacity->value(trace.opacity);
    scale->value(laid.width);
    turn->value(laid.turn);
    const auto lay = [&] { trace.place = laid.place(height()), view.try_trace(trace); };
    opacity->on_slide = [&](double value) { trace.opacity = std::clamp(value, 0.0, 1.0), view.try_trace(trace); };
    scale->on_slide = [&](double value) { laid.width = std::max(value, 1e-3 * size), lay(); };
    turn->on_slide = [&](double value) { laid.turn = value, lay(); };
    for (Fl_Button* button : {&other, &none}) button->color(theme().raised);
    std::function<void()> change = [&] {
        if (const auto file = ask_for_picture()) trace.image = *file, view.try_trace(trace), lay();
    };
    other.callback([](Fl_Widget*, void* run) { (*static_cast<std::function<void()>*>(run))(); }, &change);
    bool removed = false;
    none.callback([](Fl_Widget* button, void* flag) {
        *static_cast<bool*>(flag) = true;
        button->window()->hide();
    }, &removed);
    const bool accepted = window.ask(ok, cancel);
    view.try_trace(before);
    if (removed && before) return "tile.trace on=false";
    if (removed || !accepted || (before && trace == *before)) return {};
    return trace_command(trace, folder);
}

std::optional<TileExport> ask_how_to_export(const std::vector<StatusPart>& facts, std::size_t solids)
{
    const Layout& l = layout();
    const int label = l.px(150), width = l.px(470), field = l.px(150), lines = int(facts.size());
    Fl_Group::current(nullptr);
    Question window(width, 4 + lines, "Export tile");
    for (int i = 0; i < lines; ++i) {
        Fl_Box* fact = Question::add_label(i, width - 2 * l.margin(), "");
        fact->copy_label(facts[std::size_t(i)].text.c_str());
        fact->labelcolor(facts[std::size_t(i)].warns ? theme().amber : theme().faint_text);
    }
    Question::add_label(lines, label, "bottom");
    Question::add_label(lines + 1, label, "clearance");
    Question::add_label(lines + 2, label, "warn if thinner than");
    Fl_Choice bottom(l.margin() + label, Question::top(lines), field, l.button_height());
    Fl_Input clearance(bottom.x(), Question::top(lines + 1), field, l.button_height()), least(bottom.x(), Question::top(lines + 2), field, l.button_height());
    const int buttons = l.px(160), small = l.px(80);
    Fl_Return_Button ok(width - l.margin() - buttons, Question::top(lines + 3), buttons, l.button_height(), "To the main window");
    const std::string files_label = solids == 1 ? "To a file…" : fmt::format("To {} files…", solids);
    Fl_Button files(ok.x() - l.gap() - l.px(120), ok.y(), l.px(120), ok.h(), files_label.c_str()), cancel(files.x() - l.gap() - small, ok.y(), small, ok.h(), "Cancel");
    window.end();
    for (const char* word : {"carved", "column", "flat"}) bottom.add(word);
    bottom.value(0);
    bottom.color(theme().raised);
    bottom.tooltip("carved: fits the layer below; column: the relief of its own top; flat: fits nothing");
    clearance.value("0");
    clearance.tooltip("How far joints open, in model units: 0.2 to 0.4 for prints of molten plastic");
    least.value("0.4");
    files.color(theme().raised);
    files.tooltip("A file for each different solid: what is mirrored, and all that a free stack needs");
    bool to_files = false;
    files.callback([](Fl_Widget* button, void* flag) {
        *static_cast<bool*>(flag) = true;
        button->window()->hide();
    }, &to_files);
    if (!window.ask(ok, cancel) && !to_files) return {};
    // What is as by default is left out, as in every command that the window makes.
    std::string command = "tile.solid";
    if (bottom.value() > 0) command += fmt::format(" bottom={}", bottom.text());
    const std::string gap = clearance.value(), wall = least.value();
    if (!gap.empty() && gap != "0") command += " " + argument_text("clearance", gap);
    if (!wall.empty() && wall != "0.4") command += " " + argument_text("min_thickness", wall);
    return TileExport{command, to_files};
}

} // namespace druse::ui
