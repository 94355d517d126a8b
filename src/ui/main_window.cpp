#include "ui/main_window.h"

#include "ui/cell_window.h"
#include "ui/context_menu.h"
#include "ui/dialogs.h"
#include "ui/help_window.h"
#include "ui/layout.h"
#include "ui/main_actions.h"
#include "ui/paint_tool.h"
#include "ui/palette.h"
#include "ui/preferences_dialog.h"
#include "ui/theme.h"
#include "ui/tile_window.h"

#include "io/tile_file.h"
#include "render/png.h"

#include <FL/Fl.H>
#include <FL/Fl_Input_.H>
#include <FL/fl_draw.H>

#include <algorithm>

namespace druse::ui {

namespace {

constexpr double facts_delay = 0.25; // seconds after which the facts of a large mesh are counted
constexpr double failed_face_time = 2;
constexpr double progress_tick = 0.1;
constexpr double frame_time = 1.0 / 60;

double seconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool is_text_field(const Fl_Widget* widget) { return dynamic_cast<const Fl_Input_*>(widget) != nullptr; }

} // namespace

MainWindow::MainWindow(Session& session, Preferences& preferences, const Options& options, int w, int h)
    : EditorWindow(w, h, "Druse"), session_(session), preferences_(preferences), options_(options), view_(session),
      files_(session), pictures_([this](const Mesh& solid, int size) { return viewport_.picture_of(solid, size); }),
      tree_(session, pictures_, 0, 0, 1, 1), parameters_(session, pictures_, 0, 0, 1, 1), view_bar_(session, view_, 0, 0, 1, 1),
      no_view_(0, 0, 1, 1), viewport_(session, view_, 0, 0, 10, 10), history_(session, 0, 0, 1, 1), groups_(session, view_, 0, 0, 1, 1),
      facts_(0, 0, 1, 1), history_section_("History", history_), groups_section_("Groups", groups_),
      facts_section_("Print check", facts_), tree_divider_(true), status_(session, 0, 0, 1, 1), show_progress_([this] {
          status_.update_progress();
          if (session_.is_working() || view_.smooth().is_computing()) show_progress_.start(progress_tick);
      }),
      count_facts_([this] { session_.count_facts(); }), forget_failed_([this] {
          session_.forget_failed_faces();
          viewport_.redraw();
      }),
      animate_([this] { view_.animate(seconds()); }), give_up_view_([this] { show_missing_view(); }), left_width_(layout().left_width(w)),
      right_width_(layout().right_width(w)), tree_height_(layout().tree_height())
{
    end();
    Fl_Group::current(nullptr);
    actions_ = main_actions(*this);
    menu_ = std::make_unique<Menu>(session.registry(), actions_, 0, 0, w, layout().menu_height());
    const std::initializer_list<Fl_Widget*> parts{menu_.get(),      &tree_,           &parameters_,    &view_bar_,     &no_view_,       &viewport_,
                                                  &history_section_, &groups_section_, &facts_section_, &left_divider_, &right_divider_, &tree_divider_,
                                                  &status_};
    for (Fl_Widget* part : parts) add(part);
    resizable(nullptr);
    size_range(layout().least_width(), layout().least_height());
    color(theme().window);
    box(FL_FLAT_BOX);
    no_view_.box(FL_FLAT_BOX);
    no_view_.color(theme().sunken);
    no_view_.labelcolor(theme().amber);
    no_view_.align(FL_ALIGN_INSIDE | FL_ALIGN_WRAP);
    no_view_.hide();
    view_.set_animated(!options.test);

    callback([](Fl_Widget*, void* p) {
        if (Fl::event() == FL_SHORTCUT && Fl::event_key() == FL_Escape) return;
        static_cast<MainWindow*>(p)->quit();
    }, this);

    session_.on_change = [this] { refresh(); };
    session_.on_event = [this](const std::string& line) { event(line); };
    session_.wake = [this] {
        Fl::awake([](void* s) { static_cast<Session*>(s)->finish(); }, &session_);
    };
    session_.on_output = [](const std::string& title, const std::string& text) { show_text(title, text); };
    view_.on_event = [this](const std::string& line) { event(line); };
    view_.smooth().wake = [this] {
        Fl::awake([](void* smooth) { static_cast<SmoothPreview*>(smooth)->finish(); }, &view_.smooth());
    };
    view_.smooth().on_change = [this] { smooth_changed(); };
    view_.crust().wake = [this] {
        Fl::awake([](void* crust) { static_cast<CrustGuide*>(crust)->finish(); }, &view_.crust());
    };
    view_.crust().on_change = [this] { parameters_.refresh(), viewport_.redraw(); };
    parameters_.fit = [this](Control& control) { view_.crust().fit(control); };
    status_.side_work = [this]() -> std::optional<SideWork> {
        SmoothPreview& smooth = view_.smooth();
        if (!smooth.is_computing()) return {};
        return SideWork{"smoothing", smooth.fraction(), [&smooth] { smooth.set_on(false); }};
    };
    groups_.list().on_carry = [this](GroupList::Carry what, int group) { carry(what, group); };
    groups_.on_change = [this] { update_hint(), viewport_.redraw(), status_.redraw(); };
    viewport_.on_frame = [this](int frame) {
        event("frame " + std::to_string(frame));
        if (view_.is_animating()) animate_.start(frame_time);
    };
    view_.on_menu = [this](const Pointer& pointer) { show_context_menu(*this, pointer); };
    files_.open_elsewhere = [this](const std::filesystem::path& file) { return open_in_editor(file, nullptr); };
    viewport_.on_drop = [this](const std::string& uris) { files_.drop(uris); };
    pictures_.on_ready = [this] { tree_.redraw(), parameters_.redraw(); };
    menu_->on_operator = [this](const Operator& op) { choose(op); };
    parameters_.on_help = [this] { show_help(); };

    for (Section* section : {&history_section_, &groups_section_, &facts_section_}) section->on_fold = [this] { arrange(), redraw(); };
    left_divider_.on_drag = [this](int x) { left_width_ = x, arrange(), redraw(); };
    right_divider_.on_drag = [this](int x) { right_width_ = this->w() - x, arrange(), redraw(); };
    tree_divider_.on_drag = [this](int y) { tree_height_ = y - layout().menu_height(), arrange(), redraw(); };
    left_divider_.on_fold = [this] { left_open_ = !left_open_, arrange(), redraw(); };
    right_divider_.on_fold = [this] { right_open_ = !right_open_, arrange(), redraw(); };
    arrange();
    refresh();
}

MainWindow::~MainWindow()
{
    session_.on_change = nullptr;
    session_.on_event = nullptr;
    session_.on_output = nullptr;
    session_.wake = nullptr;
    view_.on_event = nullptr;
    view_.smooth().wake = nullptr;
    view_.smooth().on_change = nullptr;
    view_.crust().wake = nullptr;
    view_.crust().on_change = nullptr;
    view_.on_menu = nullptr;
    hide();
    // As its parts go one by one, FLTK looks for another to give the pointer to: there is none from here on.
    closing_ = true;
    while (children() > 0) remove(0);
}

// --- where everything is ------------------------------------------------------------------------------------------------------

void MainWindow::resize(int x, int y, int w, int h)
{
    EditorWindow::resize(x, y, w, h);
    arrange();
}

void MainWindow::arrange()
{
    const Layout& l = layout();
    const int top = l.menu_height(), bottom = h() - l.status_height(), height = bottom - top, line = l.divider();
    const int most_side = std::max(l.least_side_width(), (w() - l.least_view_width()) / 2);
    left_width_ = std::clamp(left_width_, l.least_side_width(), most_side);
    right_width_ = std::clamp(right_width_, l.least_side_width(), most_side);
    tree_height_ = std::clamp(tree_height_, l.px(100), std::max(l.px(100), height - l.px(200)));
    const int left = left_open_ ? left_width_ : 0, right = right_open_ ? right_width_ : 0;

    menu_->resize(0, 0, w(), top);
    status_.resize(0, bottom, w(), l.status_height());

    for (Fl_Widget* widget : {static_cast<Fl_Widget*>(&tree_), static_cast<Fl_Widget*>(&parameters_), static_cast<Fl_Widget*>(&tree_divider_)})
        left_open_ ? widget->show() : widget->hide();
    tree_.resize(0, top, left, tree_height_);
    tree_divider_.resize(0, top + tree_height_, left, line);
    parameters_.resize(0, top + tree_height_ + line, left, height - tree_height_ - line);
    left_divider_.resize(left, top, line, height);

    const int view_x = left + line, view_w = w() - left - right - 2 * line;
    view_bar_.resize(view_x, top, view_w, l.header_height() + l.gap());
    const int view_y = top + view_bar_.h();
    no_view_.resize(view_x, view_y, view_w, bottom - view_y);
    viewport_.resize(view_x, view_y, view_w, bottom - view_y);

    right_divider_.resize(w() - right - line, top, line, height);
    arrange_right(w() - right, top, right, height);
}

/// Open sections share the column: print check as much as it has lines, history and groups the rest.
void MainWindow::arrange_right(int x, int y, int w, int h)
{
    const Layout& l = layout();
    const auto bar = l.header_height();
    int free = h - 3 * bar;
    const int facts = facts_section_.is_open() ? std::min(free / 2, 8 * l.line_height()) : 0;
    free -= facts;
    const bool history_open = history_section_.is_open(), groups_open = groups_section_.is_open();
    const int history = history_open ? (groups_open ? free / 2 : free) : 0;
    const int groups = groups_open ? free - history : 0;
    int at = y;
    for (const auto& [section, height] : {std::pair(&history_section_, history), std::pair(&groups_section_, groups), std::pair(&facts_section_, facts)}) {
        right_open_ ? section->show() : section->hide();
        section->resize(x, at, w, bar + height);
        at += bar + height;
    }
}

// --- following the session ----------------------------------------------------------------------------------------------------

void MainWindow::event(const std::string& line)
{
    if (line.starts_with("opened ") || line.starts_with("saved ")) preferences_.remember(session_.file());
    if (on_event) on_event(line);
}

void MainWindow::update_hint()
{
    const std::string& of_list = groups_.list().hint();
    status_.set_hint(of_list.empty() ? view_.hint() : of_list);
    const bool acts = session_.chosen() && acts_on_click(*session_.chosen());
    if (acts == cross_ || !viewport_.shown()) return;
    cross_ = acts;
    viewport_.cursor(acts ? FL_CURSOR_CROSS : FL_CURSOR_DEFAULT);
}

void MainWindow::refresh()
{
    view_.session_changed();
    frame_what_is_new();
    copy_label((session_.title() + " - Druse").c_str());
    tree_.refresh();
    parameters_.refresh();
    view_bar_.refresh();
    history_.update();
    groups_.update();
    facts_.show_facts(print_facts(session_.display(), preferences_.unit));
    history_section_.set_note(std::to_string(session_.display().done) + " of " + std::to_string(session_.display().steps.size()));
    status_.update(preferences_.unit);
    update_hint();
    later();
    if (on_change) on_change();
}

/// The smooth preview came, went, or is on its way.
void MainWindow::smooth_changed()
{
    viewport_.redraw();
    view_bar_.refresh();
    menu_->refresh();
    status_.update(preferences_.unit);
    if (view_.smooth().is_computing()) show_progress_.start(progress_tick);
}

void MainWindow::later()
{
    if (view_.smooth().is_computing()) show_progress_.start(progress_tick);
    if (!viewport_.reason().empty() && viewport_.visible()) give_up_view_.start(0);
    if (session_.is_working()) show_progress_.start(progress_tick);
    if (!session_.busy() && !session_.display().facts) count_facts_.start(facts_delay);
    if (!session_.failed_faces().empty()) forget_failed_.start(failed_face_time);
}

/// A file that was opened, and the first shape in an empty document, is framed; after that the camera is the person's.
void MainWindow::frame_what_is_new()
{
    const bool empty = session_.display().counts.vertices == 0;
    if (empty) {
        framed_ = false;
    } else if (!framed_ || session_.file() != framed_file_) {
        view_.frame_all();
        framed_ = true;
    }
    framed_file_ = session_.file();
}

void MainWindow::show_missing_view()
{
    no_view_.copy_label(viewport_.reason().c_str());
    viewport_.hide();
    no_view_.show();
    redraw();
}

// --- keys ---------------------------------------------------------------------------------------------------------------------

int MainWindow::handle(int event)
{
    if (closing_) return 0;
    if (event == FL_SHORTCUT) {
        if (Fl::event_key() == FL_Escape) {
            escape();
            return 1; // else it would close the window
        }
        if (EditorWindow::handle(event)) return 1;
        return other_key(Fl::event_key()) ? 1 : 0;
    }
    // Tab folds the side panels; between fields it goes from one to the next.
    if (event == FL_KEYBOARD && Fl::event_key() == FL_Tab && !is_text_field(Fl::focus()) && Fl::focus() == &viewport_) {
        fold_sides();
        return 1;
    }
    const int handled = EditorWindow::handle(event);
    const bool mouse = event == FL_MOVE || event == FL_DRAG || event == FL_RELEASE || event == FL_PUSH;
    if (mouse) update_hint();
    return handled;
}

void MainWindow::escape()
{
    const Selection& selection = *session_.display().selection;
    if (view_.cancel()) {
        update_hint();
        return;
    }
    if (session_.is_working()) session_.cancel();
    else if (view_.smooth().is_computing()) view_.smooth().set_on(false);
    else if (is_text_field(Fl::focus())) viewport_.take_focus();
    else if (session_.chosen()) session_.choose(nullptr);
    else if (!selection.faces.empty()) session_.run("select.faces faces=none");
    else if (!selection.edges.empty()) session_.run("select.edges edges=none");
    else if (!selection.vertices.empty()) session_.run("select.vertices vertices=none");
}

/// Second keys of actions that have one in the menu already.
bool MainWindow::other_key(int key)
{
    const bool ctrl = Fl::event_state(FL_CTRL) != 0;
    if (ctrl && key == 'y') session_.redo();
    else if (!ctrl && key == '/') show_palette(*this);
    else if (key == FL_KP + '1') view_.look({ctrl ? 180.0 : 0.0, 0});
    else if (key == FL_KP + '3') view_.look({ctrl ? -90.0 : 90.0, 0});
    else if (key == FL_KP + '7') view_.look({0, ctrl ? -90.0 : 90.0});
    else if (key == FL_KP + '5') view_.set_parallel(!view_.camera().parallel());
    else if (key == FL_KP + '+' || key == '=') view_.zoom(1.25);
    else if (key == FL_KP + '-') view_.zoom(0.8);
    else return false;
    return true;
}

/// A swatch of the palette, dragged beyond it: over the view it is a tool.
void MainWindow::carry(GroupList::Carry what, int group)
{
    using Carry = GroupList::Carry;
    if (what == Carry::cancel) {
        if (carrying_) view_.cancel();
        carrying_ = false;
        return;
    }
    Pointer p;
    p.x = Fl::event_x() - viewport_.x() + 0.5;
    p.y = Fl::event_y() - viewport_.y() + 0.5;
    p.button = 1;
    if (!carrying_) view_.carry(view_.make_tool<DropGroupTool>(group), p);
    carrying_ = what == Carry::move;
    carrying_ ? view_.drag(p) : view_.release(p);
    update_hint();
}

// --- what the menus do with the window ----------------------------------------------------------------------------------------

void MainWindow::choose(const Operator& op)
{
    if (op.parameters.empty()) {
        session_.run(op.name);
        return;
    }
    session_.choose(&op);
    tree_.reveal(op);
}

void MainWindow::fold_sides()
{
    left_open_ = right_open_ = sides_are_folded();
    arrange();
    redraw();
}

void MainWindow::full_screen()
{
    if (fullscreen_active()) fullscreen_off();
    else fullscreen();
}

void MainWindow::edit_preferences()
{
    if (!ask_for_preferences(preferences_)) return;
    if (!options_.test) preferences_.store();
    refresh();
}

void MainWindow::save_screenshot()
{
    std::filesystem::path proposal = session_.file().empty() ? std::filesystem::path("druse") : session_.file();
    const auto file = ask_where_to_save("Screenshot", proposal.replace_extension(".png"));
    if (!file) return;
    try {
        write_png(file->string(), viewport_.picture(2, false));
        session_.say(Message::Kind::note, "wrote " + file->filename().string());
    } catch (const std::exception& e) {
        session_.say(Message::Kind::error, e.what());
    }
    refresh();
}

void MainWindow::show_help()
{
    if (session_.chosen()) show_operator_help(*session_.chosen());
    else session_.say(Message::Kind::note, "choose an operator, and F1 tells about it"), refresh();
}

void MainWindow::show_log()
{
    std::string text;
    for (const Message& m : session_.log()) text += (m.kind == Message::Kind::error ? "error: " : "note: ") + m.text + "\n";
    show_text("Log", text.empty() ? "Nothing was said yet." : text);
}

template <class Editor>
Editor& MainWindow::show_editor(std::unique_ptr<Editor>& editor)
{
    if (!editor) {
        editor = std::make_unique<Editor>(session_.registry(), preferences_, options_.test, w(), h());
        SourceWindow& made = *editor;
        made.on_event = [this, mark = made.mark()](const std::string& line) { event(mark + line); };
        made.on_export = [this](Script script) {
            if (!options_.test && !files_.may_leave()) return;
            framed_ = false; // it is framed
            session_.run_script(std::move(script));
            if (shown()) show(); // in front
        };
        made.files().open_elsewhere = [this, &made](const std::filesystem::path& file) { return open_in_editor(file, &made); };
        if (on_editor) on_editor(made);
    }
    if (!editor->shown()) {
        editor->size(w(), h());
        editor->position(x_root(), y_root());
    }
    editor->show();
    return *editor;
}

TileWindow& MainWindow::tile_editor() { return show_editor(tile_editor_); }

CellWindow& MainWindow::cell_editor() { return show_editor(cell_editor_); }

SourceWindow& MainWindow::editor_for(const std::filesystem::path& file)
{
    if (is_cell_file(file)) return cell_editor();
    return tile_editor();
}

std::vector<SourceWindow*> MainWindow::editors() const
{
    std::vector<SourceWindow*> open;
    for (SourceWindow* editor : {static_cast<SourceWindow*>(tile_editor_.get()), static_cast<SourceWindow*>(cell_editor_.get())})
        if (editor) open.push_back(editor);
    return open;
}

/// @return false if it is no tile, or one for the editor that asks
bool MainWindow::open_in_editor(const std::filesystem::path& file, const SourceWindow* asks)
{
    if (file.extension() != ".tile") return false;
    if (asks && (asks == cell_editor_.get()) == is_cell_file(file)) return false;
    editor_for(file).open(file);
    return true;
}

bool MainWindow::is_in_view(int x, int y) const { return x >= viewport_.x() && x < viewport_.x() + viewport_.w() && y >= viewport_.y(); }

void MainWindow::open(const std::filesystem::path& file)
{
    if (!files_.open_elsewhere(file)) session_.open(file);
}

void MainWindow::quit()
{
    if (!options_.test) {
        for (SourceWindow* editor : editors())
            if (!editor->may_close()) return;
        if (!files_.may_leave()) return;
    }
    for (SourceWindow* editor : editors()) editor->hide();
    preferences_.x = x_root();
    preferences_.y = y_root();
    preferences_.width = w();
    preferences_.height = h();
    hide();
}

} // namespace druse::ui
