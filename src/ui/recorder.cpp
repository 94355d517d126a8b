#include "ui/recorder.h"

#include "ui/key_names.h"
#include "ui/list_view.h"
#include "ui/main_window.h"
#include "ui/source_window.h"

#include "dlfl/errors.h"

#include <FL/Fl.H>
#include <FL/Fl_Button.H>
#include <FL/Fl_Choice.H>
#include <FL/Fl_Group.H>

#include <fmt/format.h>

#include <string_view>

namespace druse::ui {

namespace {

/// `shift ctrl alt twice`, those that hold, each after a blank.
std::string held()
{
    std::string text;
    if (Fl::event_state(FL_SHIFT)) text += " shift";
    if (Fl::event_state(FL_CTRL)) text += " ctrl";
    if (Fl::event_state(FL_ALT)) text += " alt";
    return text;
}

/// The innermost widget at a place of the window. FLTK's own, `belowmouse`, lags behind a pointer that jumps.
const Fl_Widget* widget_at(const Fl_Group& group, int x, int y)
{
    for (int i = group.children() - 1; i >= 0; --i) {
        Fl_Widget& child = *group.child(i);
        if (!child.visible() || x < child.x() || y < child.y() || x >= child.x() + child.w() || y >= child.y() + child.h()) continue;
        const Fl_Group* inner = child.as_group();
        if (!inner) return &child;
        return child.as_window() ? widget_at(*inner, x - child.x(), y - child.y()) : widget_at(*inner, x, y);
    }
    return &group;
}

/// Would a press on it open a menu or a dialog? Their labels end in dots, as in menus, or in the mark of a list.
bool opens_something(const Fl_Widget* widget)
{
    const std::string_view label = widget && widget->label() ? widget->label() : "";
    if (const auto* list = dynamic_cast<const ListView*>(widget); list && list->asks()) return true;
    return dynamic_cast<const Fl_Choice*>(widget) || (dynamic_cast<const Fl_Button*>(widget) && (label.ends_with("…") || label == "@#2>"));
}

/// Would the key open a dialog?
bool asks(const EditorWindow& window, int key, int state)
{
    for (const Action& action : window.actions())
        if (action.shortcut == (key | (state & (FL_CTRL | FL_ALT | FL_SHIFT))) && action.path.ends_with("…")) return true;
    return false;
}

} // namespace

Recorder* Recorder::only_ = nullptr;

Recorder::Recorder(MainWindow& window, const std::string& file) : window_(window), out_(file)
{
    if (!out_) throw InputError(file, "cannot be written");
    only_ = this;
    Fl::event_dispatch(dispatch);
    watch(window_);
}

Recorder::~Recorder()
{
    window_.menu().on_pick = nullptr;
    for (SourceWindow* editor : window_.editors()) editor->menu().on_pick = nullptr;
    Fl::event_dispatch(nullptr);
    only_ = nullptr;
}

void Recorder::watch(EditorWindow& window)
{
    window.menu().on_pick = [this, &window](const std::string& path) {
        if (Fl::event() != FL_SHORTCUT && Fl::event() != FL_KEYBOARD && !path.ends_with("…")) write(window, "menu " + path);
    };
}

void Recorder::write(EditorWindow& window, const std::string& line)
{
    const auto* editor = dynamic_cast<const SourceWindow*>(&window);
    out_ << (editor ? editor->mark() : "") << line << std::endl;
}

int Recorder::dispatch(int event, Fl_Window* to)
{
    // What goes to menus and dialogs is theirs.
    if (to && !Fl::grab() && !Fl::modal()) {
        const auto look = [&](EditorWindow& window) {
            if (to == &window || to->window() == &window) only_->record(event, window);
        };
        look(only_->window_);
        for (SourceWindow* editor : only_->window_.editors()) look(*editor);
    }
    return Fl::handle_(event, to);
}

void Recorder::record(int event, EditorWindow& window)
{
    const int x = Fl::event_x_root() - window.x_root(), y = Fl::event_y_root() - window.y_root();
    switch (event) {
    case FL_PUSH:
        if (y < window.menu().h() || (Fl::event_button() == 3 && !window.is_in_view(x, y)) || opens_something(widget_at(window, x, y))) break;
        pressed_ = true;
        write(window, fmt::format("push {} {} {}{}{}", x, y, Fl::event_button(), held(), Fl::event_clicks() > 0 ? " twice" : ""));
        break;
    case FL_MOVE: // FLTK makes a drag of it later
    case FL_DRAG:
        if (pressed_) write(window, fmt::format("drag {} {}{}", x, y, held()));
        break;
    case FL_RELEASE:
        if (pressed_) write(window, fmt::format("release {} {}{}", x, y, held()));
        pressed_ = false;
        break;
    case FL_MOUSEWHEEL: write(window, fmt::format("wheel {} {} {}{}", x, y, Fl::event_dy(), held())); break;
    case FL_KEYBOARD: {
        const std::string name = key_text({Fl::event_key(), Fl::event_state() & (FL_CTRL | FL_ALT | FL_SHIFT)});
        if (!name.empty() && !asks(window, Fl::event_key(), Fl::event_state())) write(window, "key " + name);
        break;
    }
    default: break;
    }
}

void Recorder::follow(const std::string& line)
{
    std::string mark; // of the editor whose line it is
    for (const SourceWindow* editor : window_.editors())
        if (line.starts_with(editor->mark())) mark = editor->mark();
    const std::string_view rest = std::string_view(line).substr(mark.size());
    for (const char* event : {"opened ", "saved ", "exported ", "set ", "preset ", "run ", "choose ", "handed over"}) {
        if (!rest.starts_with(event)) continue;
        std::string verb = event;
        for (const auto& [done, present] : {std::pair("opened ", "open "), std::pair("saved ", "save "), std::pair("exported ", "export "), std::pair("handed over", "hand over")})
            if (verb == done) verb = present;
        out_ << mark << verb << rest.substr(std::string_view(event).size()) << std::endl;
    }
}

} // namespace druse::ui
