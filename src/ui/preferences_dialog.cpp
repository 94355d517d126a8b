#include "ui/preferences_dialog.h"

#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/Fl.H>
#include <FL/Fl_Box.H>
#include <FL/Fl_Button.H>
#include <FL/Fl_Choice.H>
#include <FL/Fl_Double_Window.H>
#include <FL/Fl_Return_Button.H>

#include <algorithm>
#include <array>

namespace druse::ui {

namespace {

constexpr std::array<double, 4> scales{1, 1.25, 1.5, 2};
constexpr std::array<const char*, 4> units{"mm", "cm", "in", "units"};

/// A label and a choice, as one row.
class Row {
public:
    Row(const char* label, int y)
        : choice(layout().px(140), y, layout().px(160), layout().button_height(), label)
    {
        choice.color(theme().raised);
        choice.textsize(layout().font());
        choice.labelsize(layout().font());
    }
    Fl_Choice choice;
};

} // namespace

bool ask_for_preferences(Preferences& preferences)
{
    const Layout& l = layout();
    const int row = l.button_height() + l.gap();
    Fl_Group::current(nullptr);
    Fl_Double_Window window(l.px(320), 5 * row + 3 * l.margin(), "Preferences");
    window.color(theme().window);
    Row unit("unit of length", l.margin()), scale("size of widgets", l.margin() + row), look("colours", l.margin() + 2 * row);
    for (const char* name : units) unit.choice.add(name);
    for (const char* name : {"1", "1.25", "1.5", "2"}) scale.choice.add(name);
    for (const char* name : {"dark", "light"}) look.choice.add(name);
    Fl_Box note(l.margin(), l.margin() + 3 * row, window.w() - 2 * l.margin(), l.button_height(), "Size and colours count from the next start.");
    note.labelcolor(theme().faint_text);
    note.labelsize(l.small_font());
    note.align(FL_ALIGN_LEFT | FL_ALIGN_INSIDE);
    Fl_Return_Button ok(window.w() - l.margin() - l.px(90), l.margin() + 4 * row + l.gap(), l.px(90), l.button_height(), "OK");
    Fl_Button cancel(ok.x() - l.gap() - l.px(90), ok.y(), l.px(90), l.button_height(), "Cancel");
    window.end();

    const auto place = [](const auto& list, const auto& value) { return int(std::find(list.begin(), list.end(), value) - list.begin()); };
    unit.choice.value(place(units, preferences.unit) % int(units.size()));
    scale.choice.value(place(scales, preferences.ui_scale) % int(scales.size()));
    look.choice.value(preferences.dark ? 0 : 1);

    bool accepted = false;
    ok.callback([](Fl_Widget* button, void* flag) {
        *static_cast<bool*>(flag) = true;
        button->window()->hide();
    }, &accepted);
    cancel.callback([](Fl_Widget* button, void*) { button->window()->hide(); });
    window.set_modal();
    window.hotspot(&ok);
    window.show();
    while (window.shown()) Fl::wait();
    if (!accepted) return false;
    preferences.unit = units[std::size_t(unit.choice.value())];
    preferences.ui_scale = scales[std::size_t(scale.choice.value())];
    preferences.dark = look.choice.value() == 0;
    return true;
}

} // namespace druse::ui
