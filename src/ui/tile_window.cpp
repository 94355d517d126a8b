#include "ui/tile_window.h"

#include "ui/dialogs.h"
#include "ui/help_window.h"
#include "ui/layout.h"
#include "ui/operator_tree.h"
#include "ui/relief_tool.h"
#include "ui/theme.h"
#include "ui/tile_dialogs.h"
#include "ui/tile_source.h"
#include "ui/type_chooser.h"

#include "dlfl/errors.h"
#include "render/png.h"
#include "tile/tile_solid.h"

#include <FL/Fl.H>
#include <FL/Fl_Input_.H>
#include <FL/fl_draw.H>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace druse::ui {

namespace {

// Seconds.
constexpr double tile_progress_tick = 0.1, tile_frame_time = 1.0 / 60;
constexpr double quick_relief = 0.006; // one that takes longer to make and to draw follows a drag in the plane when that pauses
constexpr double relief_delay = 0.15;
constexpr double settle_delay = 0.1; // panels follow a drag when it has ended

double now_in_seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

} // namespace

TileWindow::TileWindow(const Registry& registry, Preferences& preferences, bool test, int w, int h)
    : EditorWindow(w, h, "Tile editor"), preferences_(preferences), test_(test), session_(registry), files_(session_), plane_(session_), space_(session_),
      pictures_([this](const Mesh& solid, int size) { return viewport_.picture_of(solid, size); }), canvas_(
          plane_, [this](bool dark, double scale, Image& image) { drawing_.draw(plane_, dark, scale, image); }, 0, 0, 10, 10),
      viewport_(session_, space_, 0, 0, 10, 10), neighbours_label_(0, 0, 1, 1, "neighbours"), neighbours_(0, 0, 1, 1), history_(session_, 0, 0, 1, 1), history_section_("History", history_), operator_choice_(0, 0, 1, 1),
      parameters_(session_, pictures_, 0, 0, 1, 1), history_divider_(true), status_(session_, 0, 0, 1, 1), show_progress_([this] {
          status_.update_progress();
          if (session_.is_working()) show_progress_.start(tile_progress_tick);
      }),
      animate_([this] { space_.animate(now_in_seconds()); }), follow_relief_([this] { follow_relief(); }), settle_([this] { refresh_panels(); }), right_width_(layout().tile_side_width()), history_height_(layout().px(180))
{
    end();
    Fl_Group::current(nullptr);
    for (const Operator& op : registry.operators())
        if (op.family() == "tile") operators_.push_back(&op);
    files_.usual_extension = ".tile";
    session_.leave_out_sources();
    actions_ = make_actions();
    menu_ = std::make_unique<Menu>(no_operators_, actions_, 0, 0, w, layout().menu_height());
    make_bar();
    for (Fl_Widget* part : std::initializer_list<Fl_Widget*>{menu_.get(), &bar_, &canvas_, &viewport_, &neighbours_label_, &neighbours_, &history_section_, &operator_choice_, &parameters_, &middle_,
                                                             &right_divider_, &history_divider_, &status_})
        add(part);
    resizable(nullptr);
    size_range(layout().least_width(), layout().least_height());
    color(theme().window);
    box(FL_FLAT_BOX);
    space_.set_animated(!test);
    callback([](Fl_Widget*, void* p) {
        if (Fl::event() == FL_SHORTCUT && Fl::event_key() == FL_Escape) return;
        static_cast<TileWindow*>(p)->close();
    }, this);

    operator_choice_.color(theme().raised);
    operator_choice_.textsize(layout().font());
    operator_choice_.tooltip("What to do with the tile as a whole");
    operator_choice_.add("Choose an operator");
    for (const Operator* op : operators_) operator_choice_.add(op->title().c_str());
    operator_choice_.value(0);
    operator_choice_.callback([](Fl_Widget*, void* p) {
        auto* self = static_cast<TileWindow*>(p);
        const int chosen = self->operator_choice_.value();
        if (chosen > 0) {
            const Operator& op = *self->operators_[std::size_t(chosen) - 1];
            if (self->on_event) self->on_event("choose " + op.name);
            self->choose(op);
        } else {
            self->session_.choose(nullptr);
        }
    }, this);

    neighbours_label_.labelsize(layout().small_font());
    neighbours_label_.align(FL_ALIGN_LEFT | FL_ALIGN_INSIDE);
    neighbours_.tooltip("The tiles around it in space: 0 hides them, 1 is touching");
    neighbours_.set_range(0, 1, 0.05);
    neighbours_.on_slide = [this](double value) { relief_.neighbours = value, follow_relief(); };
    space_.stand_in = [this]() -> const DrawLists* { return shows_mesh() ? nullptr : &relief_.lists; };
    auto tool = std::make_unique<ReliefTool>(session_, space_.camera(), plane_, relief_);
    relief_tool_ = tool.get();
    space_.use_tool(std::move(tool));

    session_.on_change = [this] { refresh(); };
    session_.on_event = [this](const std::string& line) {
        if (line.starts_with("opened ") || line.starts_with("saved ")) preferences_.remember(session_.file());
        if (on_event) on_event(line);
    };
    session_.wake = [this] {
        Fl::awake([](void* s) { static_cast<Session*>(s)->finish(); }, &session_);
    };
    session_.on_output = [](const std::string& title, const std::string& text) { show_text(title, text); };
    space_.on_event = [this](const std::string& line) {
        if (on_event) on_event(line);
    };
    plane_.on_select = [this] { take_selection(); };
    canvas_.on_pointer = [this] {
        if (panels_are_old_ && !plane_.is_dragging()) refresh_panels();
        update_hint();
    };
    viewport_.on_frame = [this](int frame) {
        if (on_event) on_event("frame " + std::to_string(frame));
        if (space_.is_animating()) animate_.start(tile_frame_time);
    };
    viewport_.on_drop = [this](const std::string& uris) { files_.drop(uris); };
    status_.parts = [this] { return facts(); };
    parameters_.on_help = [this] {
        if (session_.chosen()) show_operator_help(*session_.chosen());
    };
    history_section_.on_fold = [this] { arrange(), redraw(); };
    middle_.on_drag = [this](int x) { split_ = double(x) / std::max(1, this->w() - right_width_), arrange(), redraw(); };
    right_divider_.on_drag = [this](int x) { right_width_ = this->w() - x, arrange(), redraw(); };
    history_divider_.on_drag = [this](int y) { history_height_ = y - history_section_.y(), arrange(), redraw(); };
    arrange();
    refresh();
}

TileWindow::~TileWindow()
{
    session_.on_change = nullptr;
    session_.on_event = nullptr;
    session_.on_output = nullptr;
    session_.wake = nullptr;
    plane_.on_select = nullptr;
    plane_.on_redraw = nullptr;
    space_.on_event = nullptr;
    hide();
    closing_ = true;
    while (children() > 0) remove(0);
}

void TileWindow::show()
{
    const bool first = !shown();
    EditorWindow::show();
    if (first) viewport_.show();
    canvas_.take_focus();
}

// --- where everything is --------------------------------------------------------------------------------------------------------------

void TileWindow::resize(int x, int y, int w, int h)
{
    EditorWindow::resize(x, y, w, h);
    arrange();
}

void TileWindow::arrange()
{
    const Layout& l = layout();
    const int bar = l.button_height() + 2 * l.gap(), top = l.menu_height() + bar, bottom = h() - l.status_height(), line = l.divider();
    right_width_ = std::clamp(right_width_, l.least_side_width(), std::max(l.least_side_width(), w() / 3));
    const int room = w() - right_width_ - 2 * line;
    const int left = std::clamp(static_cast<int>(split_ * room), std::min(l.px(240), room / 2), std::max(room - l.px(240), room / 2));
    menu_->resize(0, 0, w(), l.menu_height());
    bar_.resize(0, l.menu_height(), w(), bar);
    canvas_.resize(0, top, left, bottom - top);
    middle_.resize(left, top, line, bottom - top);
    const int strip = bottom - l.row_height(), label = l.px(84), pad = l.margin();
    viewport_.resize(left + line, top, room - left, strip - top);
    neighbours_label_.resize(left + line + pad, strip, label, l.row_height());
    neighbours_.resize(left + line + pad + label, strip, std::max(1, std::min(l.px(220), room - left - label - 2 * pad)), l.row_height());
    const int side = w() - right_width_;
    right_divider_.resize(side - line, top, line, bottom - top);
    history_height_ = std::clamp(history_height_, l.px(90), std::max(l.px(90), bottom - top - l.px(220)));
    const int history = history_section_.is_open() ? history_height_ : l.header_height();
    history_section_.resize(side, top, right_width_, history);
    history_divider_.resize(side, top + history, right_width_, line);
    const int choice = top + history + line + l.gap();
    operator_choice_.resize(side + l.margin(), choice, right_width_ - 2 * l.margin(), l.button_height());
    parameters_.resize(side, choice + l.button_height() + l.gap(), right_width_, bottom - choice - l.button_height() - l.gap());
    status_.resize(0, bottom, w(), l.status_height());
}

// --- following the session ------------------------------------------------------------------------------------------------------------

/// The mesh, while it is what the last step made.
bool TileWindow::shows_mesh() const
{
    const Display& display = session_.display();
    if (display.done == 0) return false;
    const std::string& last = display.steps[display.done - 1];
    return last.starts_with("tile.solid") || last.starts_with("tile.assemble");
}

void TileWindow::refresh()
{
    relief_.is_shown = !shows_mesh();
    follow_tile();
    plane_.session_changed();
    relief_tool_->go_on();
    if (plane_.is_dragging() || relief_tool_->is_raising()) { // with each step only what is dragged is drawn
        panels_are_old_ = true;
        settle_.start(settle_delay);
        return;
    }
    refresh_panels();
}

void TileWindow::refresh_panels()
{
    if (plane_.is_dragging() || relief_tool_->is_raising()) {
        settle_.start(settle_delay);
        return;
    }
    settle_.stop();
    panels_are_old_ = false;
    space_.session_changed();
    copy_label((session_.title() + " - Tile editor").c_str());
    const ShownTile& tile = plane_.tile();
    bar_.set_type(tile.type ? tile.type->name() : std::string());
    bar_.refresh();
    const auto place = std::ranges::find(operators_, session_.chosen());
    operator_choice_.value(place == operators_.end() ? 0 : int(place - operators_.begin()) + 1);
    parameters_.refresh();
    history_.update();
    history_section_.set_note(fmt::format("{} of {}", session_.display().done, session_.display().steps.size()));
    status_.update(preferences_.unit);
    menu_->refresh();
    update_hint();
    if (session_.is_working()) show_progress_.start(tile_progress_tick);
    if (on_change) on_change();
}

/// The relief follows the tile; the camera frames what it has not shown yet.
void TileWindow::follow_tile()
{
    const Scene* scene = session_.scene();
    if (!scene || session_.document_version() == relief_version_) return;
    relief_version_ = session_.document_version();
    if (plane_.is_dragging() && relief_seconds_ + viewport_.frame_seconds() > quick_relief) follow_relief_.start(relief_delay);
    else follow_relief();
}

void TileWindow::follow_relief()
{
    const Scene* scene = session_.scene();
    if (!scene) {
        follow_relief_.start(relief_delay);
        return;
    }
    const double start = now_in_seconds();
    const LayeredTile* tile = layered_tile(*scene);
    relief_.follow(tile);
    relief_seconds_ = now_in_seconds() - start;
    if (!relief_tool_->is_raising()) status_.update(preferences_.unit);
    if (!tile) framed_ = false;
    else if (!framed_ || shows_mesh() || tile->is_extruded() != was_extruded_) space_.frame_all(), framed_ = true;
    was_extruded_ = tile && tile->is_extruded();
    viewport_.redraw();
}

std::vector<StatusPart> TileWindow::facts() const
{
    std::vector<StatusPart> parts;
    const ShownTile& tile = plane_.tile();
    if (!tile.type) return parts;
    parts.push_back({fmt::format("{}, size {:.4g} {}", tile.type->name(), tile.size, preferences_.unit)});
    parts.push_back({fmt::format("outline {}, inside {}", tile.outline, tile.points.size() - std::size_t(tile.outline))});
    if (tile.thickness) {
        if (!relief_.trouble.empty()) parts.push_back({relief_.trouble, true});
        else if (relief_.thinnest) parts.push_back({fmt::format("thickness {:.4g}, least {:.4g}", *tile.thickness, *relief_.thinnest)});
        if (relief_.volume) parts.push_back({fmt::format("volume {:.5g} {}³", *relief_.volume, preferences_.unit)});
        if (relief_.trouble.empty() && relief_.solids > 1) parts.push_back({fmt::format("fills space with {} solids", relief_.solids)});
        else if (relief_.trouble.empty() && relief_.solids == 1) parts.push_back({"fills space"});
    }
    if (!plane_.selected().empty()) parts.push_back({fmt::format("sel {}", plane_.selected().size())});
    return parts;
}

void TileWindow::update_hint()
{
    const bool over_space = Fl::belowmouse() == &viewport_;
    status_.set_hint(over_space ? space_.hint() : plane_.place_hint() + plane_.hint());
}

/// The heights of what is selected are those that the panel is about.
void TileWindow::pass_selection()
{
    if (session_.chosen() && session_.chosen()->name == "tile.height" && !plane_.selected().empty()) session_.set("points", plane_.selected_text());
}

void TileWindow::take_selection()
{
    pass_selection();
    plane_.forget_box(); // what was to be done by one is done
    space_.forget_box();
    viewport_.redraw();
    status_.update(preferences_.unit);
    if (!on_event) return;
    std::string line = "selected " + (plane_.selected().empty() ? "nothing" : plane_.selected_text());
    if (const int point = plane_.selected().size() == 1 ? plane_.tile().find(*plane_.selected().begin()) : -1;
        point >= 0 && std::uint32_t(point) < relief_.lists.vertex_limit())
        if (const auto seen = space_.camera().project(relief_.lists.position(std::uint32_t(point))))
            line += fmt::format(" seen at {:.0f},{:.0f}", viewport_.x() + seen->x, viewport_.y() + seen->y);
    on_event(line);
}

// --- commands -------------------------------------------------------------------------------------------------------------------------

void TileWindow::open(const std::filesystem::path& file) { files_.open(file); }

void TileWindow::choose(const Operator& op)
{
    if (op.parameters.empty()) {
        session_.run(op.name);
        return;
    }
    session_.choose(&op);
    pass_selection();
}

void TileWindow::choose_by_name(const char* name)
{
    if (const Operator* op = session_.registry().find(name)) choose(*op);
}

void TileWindow::choose_type()
{
    const ShownTile& tile = plane_.tile();
    const auto type = choose_tile_type(tile.type ? tile.type->name() : std::string());
    if (!type) return;
    constexpr double usual_size = 20;
    session_.run_chosen(tile.type ? "tile.type type=" + *type : fmt::format("tile.new type={} size={}", *type, usual_size));
    session_.wait();
    plane_.frame();
    canvas_.take_focus();
}

void TileWindow::select_all(bool outline, bool inside)
{
    std::set<std::string> names;
    const ShownTile& tile = plane_.tile();
    for (std::size_t k = 0; k < tile.points.size(); ++k)
        if (int(k) < tile.outline ? outline : inside) names.insert(tile.points[k].name);
    plane_.select(std::move(names));
}

void TileWindow::set_tool(TileView::Tool tool)
{
    plane_.set_tool(tool);
    if (tool == TileView::Tool::heights && plane_.tile().type && !plane_.tile().thickness) choose_by_name("tile.extrude");
    update_hint();
    bar_.refresh();
}

/// Is there a tile? The status line says so if not.
bool TileWindow::has_tile()
{
    if (plane_.tile().type) return true;
    session_.say(Message::Kind::note, "choose a type of tile first");
    refresh();
    return false;
}

void TileWindow::ask_for_picture()
{
    if (!has_tile()) return;
    if (const auto command = ask_for_trace(plane_, session_.folder())) session_.run_chosen(*command);
    bar_.refresh();
}

void TileWindow::export_drawing()
{
    if (!has_tile()) return;
    std::filesystem::path proposal = session_.file().empty() ? session_.folder() / "tiling" : session_.file();
    if (const auto file = ask_where_to_save("Export drawing", proposal.replace_extension(".svg"))) session_.export_to(*file);
}

void TileWindow::export_tile()
{
    if (!has_tile()) return;
    const Scene* scene = session_.scene();
    if (!scene) return;
    const LayeredTile tile = *layered_tile(*scene); // as it is now: what is exported runs commands
    const auto asked = ask_how_to_export(facts(), tile_parts(tile).size());
    if (!asked) return;
    if (asked->to_files) export_solids(tile, asked->command);
    else if (make_solid(asked->command)) hand_over();
}

/// Runs the command, if it is not what was done last. @return false if it is refused: the status line says why
bool TileWindow::make_solid(const std::string& command)
{
    const Display& display = session_.display();
    if (display.done > 0 && display.steps[display.done - 1] == command) return true;
    const std::size_t before = display.done;
    session_.run_chosen(command);
    session_.wait();
    return session_.display().done != before;
}

/// Each one in a file of its own.
void TileWindow::export_solids(const LayeredTile& tile, const std::string& command)
{
    std::filesystem::path proposal = session_.file().empty() ? session_.folder() / "tile" : session_.file();
    const auto file = ask_where_to_save("Export", proposal.replace_extension(".stl"));
    if (!file) return;
    const std::vector<SolidFile> solids = solid_files(tile, command, *file);
    for (const SolidFile& solid : solids) {
        if (!make_solid(solid.command)) return;
        session_.export_to(solid.file);
        session_.wait();
        if (session_.message().kind == Message::Kind::error) return;
    }
    if (solids.size() > 1) session_.say(Message::Kind::note, fmt::format("exported {} and {} more", file->filename().string(), solids.size() - 1)), refresh();
}

void TileWindow::hand_over()
{
    try {
        if (on_event) on_event("handed over");
        if (on_export) on_export({"exported tile", {}, session_.folder(), session_.script()});
    } catch (const CommandError& e) {
        session_.say(Message::Kind::error, e.what());
        refresh();
    }
}

bool TileWindow::is_in_view(int x, int y) const
{
    return y >= canvas_.y() && y < canvas_.y() + canvas_.h() && x < viewport_.x() + viewport_.w();
}

void TileWindow::close()
{
    if (!test_ && !may_close()) return;
    hide();
}

// --- keys -----------------------------------------------------------------------------------------------------------------------------

int TileWindow::handle(int event)
{
    if (closing_) return 0;
    if (event == FL_SHORTCUT && Fl::event_key() == FL_Escape) {
        escape();
        return 1; // else it would close the window
    }
    if (event == FL_SHORTCUT) {
        if (EditorWindow::handle(event)) return 1;
        if (Fl::event_key() == 'y' && Fl::event_state(FL_CTRL)) session_.redo();
        else if (Fl::event_key() == FL_BackSpace) plane_.remove();
        else return 0;
        return 1;
    }
    const int handled = EditorWindow::handle(event);
    if (event == FL_MOVE || event == FL_DRAG || event == FL_RELEASE || event == FL_PUSH) update_hint();
    return handled;
}

void TileWindow::escape()
{
    if (!space_.cancel() && !plane_.cancel()) {
        if (session_.is_working()) session_.cancel();
        else if (dynamic_cast<Fl_Input_*>(Fl::focus())) canvas_.take_focus();
        else if (session_.chosen()) session_.choose(nullptr);
    }
    update_hint();
    bar_.refresh();
}

} // namespace druse::ui
