#include "ui/source_window.h"

#include "ui/dialogs.h"
#include "ui/help_window.h"
#include "ui/layout.h"
#include "ui/operator_tree.h"
#include "ui/theme.h"

#include "dlfl/errors.h"

#include <FL/Fl.H>
#include <FL/Fl_Input_.H>

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <utility>

namespace druse::ui {

namespace {

// Seconds.
constexpr double source_progress_tick = 0.1;
constexpr double settle_delay = 0.1; // panels follow a drag when it has ended

} // namespace

SourceWindow::SourceWindow(const Registry& registry, Preferences& preferences, bool test, const char* word, const char* title, Pictures::Painter paint, int w, int h)
    : EditorWindow(w, h, title), preferences_(preferences), test_(test), session_(registry), files_(session_), pictures_(std::move(paint)),
      history_(session_, 0, 0, 1, 1), history_section_("History", history_), status_(session_, 0, 0, 1, 1), word_(word), title_(title),
      operator_choice_(0, 0, 1, 1), parameters_(session_, pictures_, 0, 0, 1, 1), show_progress_([this] {
          status_.update_progress();
          if (session_.is_working()) show_progress_.start(source_progress_tick);
      }),
      settle_([this] { refresh_panels(); })
{
    end();
    Fl_Group::current(nullptr);
    for (const Operator& op : registry.operators())
        if (op.family() == word_) operators_.push_back(&op);
    files_.usual_extension = ".tile";
    session_.leave_out_sources();
    resizable(nullptr);
    size_range(layout().least_width(), layout().least_height());
    color(theme().window);
    box(FL_FLAT_BOX);
    callback([](Fl_Widget*, void* p) {
        if (Fl::event() == FL_SHORTCUT && Fl::event_key() == FL_Escape) return;
        static_cast<SourceWindow*>(p)->close();
    }, this);

    operator_choice_.color(theme().raised);
    operator_choice_.textsize(layout().font());
    operator_choice_.copy_tooltip(("What to do with the " + word_ + " as a whole").c_str());
    operator_choice_.add("Choose an operator");
    for (const Operator* op : operators_) operator_choice_.add(op->title().c_str());
    operator_choice_.value(0);
    operator_choice_.callback([](Fl_Widget*, void* p) {
        auto* self = static_cast<SourceWindow*>(p);
        const int chosen = self->operator_choice_.value();
        if (chosen > 0) {
            const Operator& op = *self->operators_[std::size_t(chosen) - 1];
            self->event("choose " + op.name);
            self->choose(op);
        } else {
            self->session_.choose(nullptr);
        }
    }, this);

    session_.on_change = [this] { refresh(); };
    session_.on_event = [this](const std::string& line) {
        if (line.starts_with("opened ") || line.starts_with("saved ")) preferences_.remember(session_.file());
        event(line);
    };
    session_.wake = [this] {
        Fl::awake([](void* s) { static_cast<Session*>(s)->finish(); }, &session_);
    };
    session_.on_output = [](const std::string& about, const std::string& text) { show_text(about, text); };
    status_.parts = [this] { return facts(); };
    parameters_.on_help = [this] {
        if (session_.chosen()) show_operator_help(*session_.chosen());
    };
    history_section_.on_fold = [this] { place_parts(), redraw(); };
}

SourceWindow::~SourceWindow() { dismantle(); }

void SourceWindow::add_parts(std::initializer_list<Fl_Widget*> parts)
{
    menu_ = std::make_unique<Menu>(no_operators_, actions_, 0, 0, w(), layout().menu_height());
    add(*menu_);
    for (Fl_Widget* part : parts) add(part);
    for (Fl_Widget* part : std::initializer_list<Fl_Widget*>{&history_section_, &operator_choice_, &parameters_, &status_}) add(part);
}

void SourceWindow::start()
{
    place_parts();
    refresh();
}

void SourceWindow::dismantle()
{
    session_.on_change = nullptr;
    session_.on_event = nullptr;
    session_.on_output = nullptr;
    session_.wake = nullptr;
    hide();
    closing_ = true;
    while (children() > 0) remove(0);
}

void SourceWindow::resize(int x, int y, int w, int h)
{
    EditorWindow::resize(x, y, w, h);
    if (!closing_ && menu_) place_parts();
}

void SourceWindow::place_operators(int x, int y, int w, int bottom)
{
    const Layout& l = layout();
    operator_choice_.resize(x + l.margin(), y, w - 2 * l.margin(), l.button_height());
    const int top = y + l.button_height() + l.gap();
    parameters_.resize(x, top, w, std::max(1, bottom - top));
}

void SourceWindow::event(const std::string& line) const
{
    if (on_event) on_event(line);
}

// --- following the session ------------------------------------------------------------------------------------------------------------

bool SourceWindow::shows_mesh() const
{
    const Display& display = session_.display();
    if (display.done == 0) return false;
    const std::string& last = display.steps[display.done - 1];
    return last.starts_with(word_ + ".solid") || last.starts_with(word_ + ".assemble");
}

void SourceWindow::refresh()
{
    follow_source();
    if (is_dragging()) { // with each step only what is dragged is drawn
        panels_are_old_ = true;
        settle_.start(settle_delay);
        return;
    }
    refresh_panels();
}

void SourceWindow::settle()
{
    if (panels_are_old_ && !is_dragging()) refresh_panels();
}

void SourceWindow::refresh_panels()
{
    if (is_dragging()) {
        settle_.start(settle_delay);
        return;
    }
    settle_.stop();
    panels_are_old_ = false;
    refresh_parts();
    copy_label((session_.title() + " - " + title_).c_str());
    refresh_bar();
    const auto place = std::ranges::find(operators_, session_.chosen());
    operator_choice_.value(place == operators_.end() ? 0 : int(place - operators_.begin()) + 1);
    parameters_.refresh();
    history_.update();
    history_section_.set_note(fmt::format("{} of {}", session_.display().done, session_.display().steps.size()));
    update_status();
    menu_->refresh();
    update_hint();
    if (session_.is_working()) show_progress_.start(source_progress_tick);
    if (on_change) on_change();
}

void SourceWindow::update_hint() { status_.set_hint(hint()); }

// --- commands -------------------------------------------------------------------------------------------------------------------------

void SourceWindow::choose(const Operator& op)
{
    if (op.parameters.empty()) session_.run(op.name);
    else session_.choose(&op);
}

void SourceWindow::choose_by_name(const char* name)
{
    if (const Operator* op = session_.registry().find(name)) choose(*op);
}

Actions SourceWindow::file_actions(std::function<void()> make_new, std::function<void()> export_it, Actions exports)
{
    Actions list;
    list.push_back({"File/New " + word_ + "…", FL_CTRL + 'n', std::move(make_new)});
    list.push_back({"File/Open…", FL_CTRL + 'o', [this] { files_.open(); }});
    list.push_back({"File/Save", FL_CTRL + 's', [this] { files_.save(); }});
    list.push_back({.path = "File/Save as…", .shortcut = FL_CTRL + FL_SHIFT + 's', .run = [this] { files_.save_as(); }, .divider = true});
    list.push_back({"File/Export " + word_ + "…", FL_CTRL + 'e', std::move(export_it)});
    std::ranges::move(exports, std::back_inserter(list));
    list.back().divider = true;
    list.push_back({"File/Close", FL_CTRL + 'w', [this] { close(); }});
    list.push_back({"Edit/Undo", FL_CTRL + 'z', [this] { session_.undo(); }});
    list.push_back({.path = "Edit/Redo", .shortcut = FL_CTRL + FL_SHIFT + 'z', .run = [this] { session_.redo(); }, .divider = true});
    return list;
}

void SourceWindow::add_operator_actions(Actions& list, const char* menu)
{
    for (const Operator* op : operators_) list.push_back({menu + ("/" + op->title()), 0, [this, op] { choose(*op); }});
}

bool SourceWindow::make_solid(const std::string& command)
{
    const Display& display = session_.display();
    if (display.done > 0 && display.steps[display.done - 1] == command) return true;
    const std::size_t before = display.done;
    session_.run_chosen(command);
    session_.wait();
    return session_.display().done != before;
}

std::optional<std::filesystem::path> SourceWindow::ask_for_solid_file() const
{
    std::filesystem::path proposal = session_.file().empty() ? session_.folder() / word_ : session_.file();
    return ask_where_to_save("Export", proposal.replace_extension(".stl"));
}

void SourceWindow::export_solids(const std::vector<SolidFile>& solids)
{
    for (const SolidFile& solid : solids) {
        if (!make_solid(solid.command)) return;
        session_.export_to(solid.file);
        session_.wait();
        if (session_.message().kind == Message::Kind::error) return;
    }
    if (solids.size() < 2) return;
    session_.say(Message::Kind::note, fmt::format("exported {} and {} more", solids[0].file.filename().string(), solids.size() - 1));
    refresh();
}

void SourceWindow::hand_over()
{
    session_.wait(); // for an autosave, too
    try {
        event("handed over");
        if (on_export) on_export({"exported " + word_, {}, session_.folder(), session_.script()});
    } catch (const std::exception& e) {
        session_.say(Message::Kind::error, e.what());
        refresh();
    }
}

void SourceWindow::close()
{
    if (!test_) {
        if (!may_close()) return;
        if (session_.is_changed()) session_.start_over(); // it was discarded
    }
    hide();
}

// --- keys -----------------------------------------------------------------------------------------------------------------------------

int SourceWindow::handle(int event)
{
    if (closing_) return 0;
    if (event == FL_SHORTCUT && Fl::event_key() == FL_Escape) {
        escape();
        return 1; // else it would close the window
    }
    if (event == FL_SHORTCUT && (is_dragging() || (Fl::event_buttons() && Fl::pushed()))) return 1; // what has hold of something ends first
    if (event == FL_SHORTCUT) {
        if (EditorWindow::handle(event)) return 1;
        if (Fl::event_key() != 'y' || !Fl::event_state(FL_CTRL)) return other_key(Fl::event_key()) ? 1 : 0;
        session_.redo();
        return 1;
    }
    const int handled = EditorWindow::handle(event);
    if (event == FL_MOVE || event == FL_DRAG || event == FL_RELEASE || event == FL_PUSH) update_hint();
    return handled;
}

void SourceWindow::escape()
{
    if (!cancel_gesture()) {
        if (session_.is_working()) session_.cancel();
        else if (dynamic_cast<Fl_Input_*>(Fl::focus())) main_part().take_focus();
        else if (session_.chosen()) session_.choose(nullptr);
    }
    update_hint();
    refresh_bar();
}

} // namespace druse::ui
