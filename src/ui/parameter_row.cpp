#include "ui/parameter_row.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/number_row.h"
#include "ui/text_rows.h"
#include "ui/theme.h"

#include <FL/Fl.H>
#include <FL/Fl_Menu_Item.H>
#include <FL/fl_draw.H>

#include <vector>

namespace druse::ui {

ParameterRow::ParameterRow(const Control& control, int x, int y, int w) : Panel(x, y, w, layout().row_height()), control_(control)
{
    copy_tooltip(control_.help.c_str());
    color(theme().window);
}

void ParameterRow::follow(const Control& control)
{
    if (control.help == control_.help) return;
    control_.help = control.help;
    copy_tooltip(control_.help.c_str());
}

int ParameterRow::control_x() const { return x() + layout().label_width(); }

void ParameterRow::draw()
{
    fl_color(theme().window);
    fl_rectf(x(), y(), w(), h());
    fl_font(FL_HELVETICA, layout().font());
    draw_text(control_.label + (control_.required ? " *" : ""), x(), y(), layout().label_width() - layout().gap(), layout().control_height(),
              is_default_ ? theme().faint_text : theme().text);
    draw_children();
}

void ParameterRow::set(const std::string& text)
{
    if (on_set) on_set(text);
}

void ParameterRow::pick(const std::string& text)
{
    if (on_pick) on_pick(text);
}

int ParameterRow::handle(int event)
{
    const bool on_label = Fl::event_inside(x(), y(), layout().label_width(), h());
    if (event == FL_PUSH && Fl::event_button() == 3) {
        open_menu();
        return 1;
    }
    if (event == FL_PUSH && on_label) {
        if (Fl::event_clicks() > 0) set({});
        return 1;
    }
    return Panel::handle(event);
}

void ParameterRow::open_menu()
{
    const std::string initial = "Default" + (control_.initial.empty() ? std::string() : ": " + control_.initial);
    const auto item = [](const char* text, int flags) { return Fl_Menu_Item{text, 0, nullptr, nullptr, flags, 0, 0, 0, 0}; };
    std::vector<Fl_Menu_Item> items{item("Type a value", 0)};
    // Where there is no list of them beside the field.
    const std::vector<std::string> words = control_.kind == Control::Kind::number ? control_.words : std::vector<std::string>();
    for (const std::string& word : words) items.push_back(item(word.c_str(), 0));
    items.push_back(item(initial.c_str(), FL_MENU_DIVIDER));
    items.push_back(item("Copy as command", 0));
    items.push_back(item(nullptr, 0));
    const Fl_Menu_Item* picked = items.data()->popup(Fl::event_x(), Fl::event_y());
    if (!picked) return;
    const auto place = static_cast<std::size_t>(picked - items.data());
    if (place == 0) edit();
    else if (place <= words.size()) pick(words[place - 1]);
    else if (place == words.size() + 1) pick({});
    else if (on_copy) on_copy();
}

std::unique_ptr<ParameterRow> make_row(const Control& control, int x, int y, int w)
{
    switch (control.kind) {
    case Control::Kind::number: return std::make_unique<NumberRow>(control, x, y, w);
    case Control::Kind::toggle: return std::make_unique<ToggleRow>(control, x, y, w);
    case Control::Kind::choice: return std::make_unique<ChoiceRow>(control, x, y, w);
    case Control::Kind::field:
    case Control::Kind::selector:
    case Control::Kind::colour:
    case Control::Kind::file:
    case Control::Kind::solid: break;
    }
    return std::make_unique<TextRow>(control, x, y, w);
}

} // namespace druse::ui
