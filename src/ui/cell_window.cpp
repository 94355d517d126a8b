#include "ui/cell_window.h"

#include "ui/cell_dialogs.h"
#include "ui/cell_drawing.h"
#include "ui/dialogs.h"
#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/Fl.H>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace druse::ui {

namespace {

// Seconds.
constexpr double cell_frame_time = 1.0 / 60;
constexpr double quick_picture = 0.006; // one that takes longer to make and to draw follows a drag in the pane when that pauses
constexpr double picture_delay = 0.15;
constexpr double faults_delay = 0.3; // after the last edit

double cell_clock() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Where a camera sees the ends of the smallest ball about the centre that holds the cell: framed, the cell is seen whole from whichever side.
std::array<Point, 4> around(const CellSolid& solid, const Camera& camera)
{
    double radius = 0;
    for (const Point& p : solid.points) radius = std::max(radius, glm::length(p));
    const Vector right = radius * camera.right(), up = radius * camera.up();
    return {right, -right, up, -up};
}

void make_label(Fl_Box& label)
{
    label.labelsize(layout().small_font());
    label.align(FL_ALIGN_LEFT | FL_ALIGN_INSIDE);
}

} // namespace

CellWindow::CellWindow(const Registry& registry, Preferences& preferences, bool test, int w, int h)
    : SourceWindow(registry, preferences, test, "cell", "Cell editor", [this](const Mesh& solid, int size) { return near_port_.picture_of(solid, size); }, w, h),
      plane_(session_), near_(session_), far_(session_), link_(near_, far_), bar_("The cell: a click begins another one", "Cell…", 168),
      canvas_(plane_, [this](bool dark, double scale, Image& image) { draw_pane(plane_, dark, scale, image); }, 0, 0, 10, 10),
      near_port_(session_, near_, 0, 0, 10, 10), far_port_(session_, far_, 0, 0, 10, 10), neighbours_label_(0, 0, 1, 1, "neighbours"),
      shells_label_(0, 0, 1, 1, "shells"), neighbours_(0, 0, 1, 1), shells_(0, 0, 1, 1), skew_(session_, near_.camera()), facts_panel_(0, 0, 1, 1),
      skew_section_("Skew", skew_), facts_section_("Cell", facts_panel_), strip_divider_(true), animate_([this] {
          near_.animate(cell_clock());
          far_.animate(cell_clock());
      }),
      follow_picture_([this] { follow_picture(); }), look_for_faults_([this] { faults_.follow(cell()); }), strip_height_(layout().px(196))
{
    actions_ = make_actions();
    make_bar();
    add_parts({&bar_, &canvas_, &near_port_, &far_port_, &neighbours_label_, &neighbours_, &shells_label_, &shells_, &skew_section_, &facts_section_, &middle_,
               &strip_divider_});
    make_view(near_, near_port_, near_tool_);
    make_view(far_, far_port_, far_tool_);

    make_label(neighbours_label_);
    make_label(shells_label_);
    neighbours_.tooltip("The cells around it: 0 hides them, 1 is touching");
    neighbours_.set_range(0, 1, 0.05);
    neighbours_.on_slide = [this](double value) { set_neighbours(value); };
    for (const char* count : {"1", "2", "3"}) shells_.add(count);
    shells_.value(0);
    shells_.color(theme().raised);
    shells_.textsize(layout().small_font());
    shells_.tooltip("How many times around");
    shells_.callback([](Fl_Widget*, void* p) {
        auto* self = static_cast<CellWindow*>(p);
        self->set_neighbours(self->neighbours_.value());
    }, this);

    selection_.on_change = [this] {
        pass_selection();
        std::set<std::string> names;
        for (const CellSelection::Pick& pick : selection_.picks()) names.insert(pick.name.text());
        plane_.mark(std::move(names)); // the same points, in the pane
        redraw_views();
        update_status();
        tell_selection();
    };
    plane_.on_select = [this] { update_status(); };
    plane_.on_box = [this] { forget_boxes(); };
    faults_.wake = [this] {
        Fl::awake([](void* faults) { static_cast<CellFaults*>(faults)->finish(); }, &faults_);
    };
    faults_.on_change = [this] {
        facts_panel_.show_facts(cell_facts());
        update_status();
        if (faults_.found()) event(faults_.found()->trouble.empty() ? "cell fits" : "cell " + faults_.found()->trouble);
    };
    canvas_.on_pointer = [this] {
        settle();
        update_hint();
        // What is pointed at in the pane is marked in space, with its partners.
        if (const std::pair now(plane_.hovered_orbit(), plane_.hovered_edge()); now != pointed_at_) pointed_at_ = now, redraw_views();
    };
    for (Section* section : {&history_section_, &skew_section_, &facts_section_})
        section->on_fold = [this, section] { // they lie side by side
            for (Section* other : {&history_section_, &skew_section_, &facts_section_}) other->set_open(section->is_open());
            place_parts(), redraw();
        };
    middle_.on_drag = [this](int x) { split_ = double(x) / std::max(1, this->w()), place_parts(), redraw(); };
    strip_divider_.on_drag = [this](int y) { strip_height_ = this->h() - layout().status_height() - y, place_parts(), redraw(); };
    start();
}

CellWindow::~CellWindow()
{
    plane_.on_select = plane_.on_box = nullptr;
    plane_.on_redraw = nullptr;
    selection_.on_change = nullptr;
    faults_.wake = nullptr;
    faults_.on_change = nullptr;
    for (View* view : {&near_, &far_}) view->on_event = nullptr, view->on_menu = nullptr;
    dismantle();
}

void CellWindow::make_view(View& view, Viewport& port, CellTool*& tool)
{
    auto made = std::make_unique<CellTool>(session_, view.camera(), plane_, picture_, selection_);
    tool = made.get();
    tool->on_pane = [this, &view](int pane, bool far) { show_pane(pane, far != (&view == &far_)); }; // it turns to where it was clicked
    view.use_tool(std::move(made));
    view.set_animated(!test_);
    view.set_free_orbit(true);
    view.stand_in = [this]() -> const DrawLists* { return shows_solid() ? nullptr : &picture_.lists(); };
    view.on_event = [this, &view](const std::string& line) { event(&view == &far_ ? "opposite " + line : line); };
    view.on_menu = [this, tool](const Pointer& pointer) { shows_solid() ? show_cell_again() : tool->pick_pane(pointer); };
    tool->on_neighbour = [this] {
        session_.say(Message::Kind::note, "a neighbour is before the cell: the slider below makes it smaller");
        refresh();
    };
    tool->on_box = [this] { forget_boxes(); };
    port.on_frame = [this, &view](int frame) {
        if (&view == &near_) event("frame " + std::to_string(frame));
        skew_.redraw(); // it turns with the camera, which the other view may turn alone
        if (near_.is_animating() || far_.is_animating()) animate_.start(cell_frame_time);
    };
    port.on_drop = [this](const std::string& uris) { files_.drop(uris); };
}

void CellWindow::show()
{
    const bool first = !shown();
    SourceWindow::show();
    if (first) {
        for (Viewport* port : {&near_port_, &far_port_})
            if (!single_ || port == &first_port()) port->show();
    }
    canvas_.take_focus();
}

// --- where everything is --------------------------------------------------------------------------------------------------------------

void CellWindow::place_parts()
{
    const Layout& l = layout();
    const int bar = l.button_height() + 2 * l.gap(), top = l.menu_height() + bar, bottom = h() - l.status_height(), line = l.divider();
    menu_->resize(0, 0, w(), l.menu_height());
    bar_.resize(0, l.menu_height(), w(), bar);
    status_.resize(0, bottom, w(), l.status_height());
    strip_height_ = std::clamp(strip_height_, l.px(150), std::max(l.px(150), (bottom - top) / 2));
    const int strip = bottom - (history_section_.is_open() ? strip_height_ : l.header_height());
    const int left = std::clamp(static_cast<int>(split_ * w()), l.px(240), std::max(l.px(240), w() - l.px(400)));
    canvas_.resize(0, top, left, strip - top);
    middle_.resize(left, top, line, strip - top);
    place_views(left + line, top, w() - left - line, strip);
    strip_divider_.resize(0, strip, w(), line);
    place_strip(strip + line, bottom);
}

void CellWindow::place_views(int x, int y, int w, int bottom)
{
    const Layout& l = layout();
    const int below = bottom - l.row_height(), pad = l.margin(), gap = 2 * l.divider(), half = (w - gap) / 2;
    Viewport &first = first_port(), &second = &first == &near_port_ ? far_port_ : near_port_;
    first.resize(x, y, single_ ? w : half, below - y);
    if (!single_) second.resize(x + half + gap, y, w - half - gap, below - y);
    const int label = l.px(84), shells = l.px(50), choice = l.px(56), room = w - label - shells - choice - 4 * pad;
    int at = x + pad;
    neighbours_label_.resize(at, below, label, l.row_height());
    neighbours_.resize(at += label, below, std::max(1, std::min(l.px(240), room)), l.row_height());
    shells_label_.resize(at = neighbours_.x() + neighbours_.w() + 2 * pad, below, shells, l.row_height());
    shells_.resize(at + shells, below + l.px(2), choice, l.control_height());
}

/// History, operators, skew and facts side by side.
void CellWindow::place_strip(int y, int bottom)
{
    const Layout& l = layout();
    const int height = bottom - y, history = static_cast<int>(0.24 * w()), operators = static_cast<int>(0.245 * w()), skew = static_cast<int>(0.295 * w());
    history_section_.resize(0, y, history, height);
    place_operators(history, y + (history_section_.is_open() ? l.gap() : l.divider()), operators, bottom);
    skew_section_.resize(history + operators, y, skew, height);
    const int left = history + operators + skew;
    facts_section_.resize(left, y, w() - left, height);
}

// --- following the session ------------------------------------------------------------------------------------------------------------

void CellWindow::follow_source()
{
    if (session_.scene() && session_.document_version() != picture_version_) shows_cell_again_ = false; // something else was done
    picture_.is_shown = !shows_solid();
    plane_.session_changed();
    follow_cell();
    near_tool_->go_on();
    far_tool_->go_on();
    skew_.go_on();
}

/// The picture follows the cell; the cameras frame what they have not shown yet.
void CellWindow::follow_cell()
{
    if (!session_.scene() || session_.document_version() == picture_version_) return;
    picture_version_ = session_.document_version();
    skew_.show_matrix(cell() ? std::optional(cell()->matrix()) : std::nullopt);
    if (plane_.is_dragging() && picture_seconds_ + near_port_.frame_seconds() > quick_picture) follow_picture_.start(picture_delay);
    else follow_picture();
    faults_.follow(nullptr);
    look_for_faults_.start(faults_delay);
}

void CellWindow::follow_picture()
{
    const double begun = cell_clock();
    const auto& drawn = picture_.cell();
    const bool is_another = drawn && cell() && (drawn->cell().kind != cell()->cell().kind || drawn->cell().volume() != cell()->cell().volume());
    picture_.follow(cell(), plane_.pane());
    picture_seconds_ = cell_clock() - begun;
    selection_.follow(cell());
    if (!cell()) {
        framed_ = false;
    } else if (!framed_ || is_another) {
        frame_views();
        framed_ = true;
        before_pane_.reset();
    }
    redraw_views();
}

void CellWindow::redraw_views()
{
    for (Viewport* port : {&near_port_, &far_port_})
        if (port->visible()) port->redraw();
}

void CellWindow::refresh_parts()
{
    near_.session_changed();
    far_.session_changed();
    if (shows_solid()) redraw_views();
    bar_.set_type(cell() ? cell_title(cell()->cell().kind) : std::string(), [](int) { return Image(); });
    facts_panel_.show_facts(cell_facts());
    skew_section_.set_note(cell() ? fmt::format("det {:.4g}", cell()->determinant()) : std::string());
    tell_selection();
    if (const std::string places = skew_.places(); places != told_skew_) told_skew_ = places, event("skew " + places);
}

std::vector<StatusPart> CellWindow::facts() const
{
    std::vector<StatusPart> parts;
    if (!cell()) return parts;
    parts.push_back({fmt::format("{}, size {:.4g} {}", name(cell()->cell().kind), cell()->size(), preferences_.unit)});
    parts.push_back({cell()->phase() == 1 ? "panes are flat" : fmt::format("{} orbits of points", cell()->point_count())});
    parts.push_back({fmt::format("volume {:.5g} {}³", cell()->volume(), preferences_.unit)});
    if (!faults_.failure().empty()) parts.push_back({faults_.failure(), true});
    if (const auto& found = faults_.found()) parts.push_back(found->trouble.empty() ? StatusPart{"fills space"} : StatusPart{found->trouble, true});
    if (!selection_.empty()) parts.push_back({fmt::format("sel {}", selection_.picks().size())});
    else if (!plane_.selected().empty()) parts.push_back({fmt::format("sel {}", plane_.selected().size())});
    return parts;
}

std::vector<Fact> CellWindow::cell_facts() const
{
    using Tone = Fact::Tone;
    if (!cell()) return {{"no cell yet", "", Tone::plain}};
    std::vector<Fact> list;
    const int pane = plane_.pane();
    list.push_back({"pane", pane < 0 ? "none shown" : fmt::format("{} of 0..{}", pane, cell()->pane_count() - 1), Tone::plain});
    if (pane >= 0) list.push_back({"triangles", std::to_string(cell()->mesh(pane).triangles.size()), Tone::plain});
    list.push_back({"orbits", std::to_string(cell()->point_count()), Tone::plain});
    const auto& found = faults_.found();
    list.push_back({"volume", fmt::format("{:.6g} {}³", found ? found->volume : cell()->volume(), preferences_.unit), Tone::plain});
    list.push_back({"lattice cell", fmt::format("{:.6g} {}³", cell()->volume(), preferences_.unit), Tone::plain});
    if (!found) {
        list.push_back({"fits neighbours", faults_.failure().empty() ? "…" : "unknown", faults_.failure().empty() ? Tone::plain : Tone::warning});
        if (!faults_.failure().empty()) list.push_back({"", faults_.failure(), Tone::warning});
        return list;
    }
    list.push_back({"self-crossing", found->pairs == 0 ? "no" : fmt::format("{} pair{} of triangles", found->pairs, found->pairs == 1 ? "" : "s"), found->pairs == 0 ? Tone::good : Tone::warning});
    list.push_back({"fits neighbours", found->trouble.empty() ? "yes" : found->where.empty() ? "no" : "no: " + found->where, found->trouble.empty() ? Tone::good : Tone::warning});
    if (!found->trouble.empty() && found->where.empty()) list.push_back({"", found->trouble, Tone::warning});
    return list;
}

std::string CellWindow::hint() const
{
    const Fl_Widget* below = Fl::belowmouse();
    if (below == &near_port_) return near_.hint();
    if (below == &far_port_) return far_.hint();
    if (below == &skew_) return skew_.hint();
    return plane_.place_hint() + plane_.hint();
}

/// Where the last picked point is, and where its partner is seen from the other side.
void CellWindow::tell_selection()
{
    std::string line = "selected " + (selection_.empty() ? std::string("nothing") : selection_.text());
    if (const CellSelection::Pick* last = selection_.last(); last && cell() && last->at.orbit < cell()->point_count()) {
        const auto tell = [&](const char* word, const std::optional<Point2>& seen, const Viewport& port) {
            if (seen) line += fmt::format(" {} {:.0f},{:.0f}", word, port.x() + seen->x, port.y() + seen->y);
        };
        const Point place = cell()->world(cell()->position(last->at.orbit));
        line += fmt::format(" at {:.6g},{:.6g},{:.6g}", place.x, place.y, place.z);
        tell("seen at", near_tool_->seen(last->at), near_port_);
        if (const auto arrow = near_tool_->arrow()) tell("arrow at", arrow->second, near_port_);
        for (const LatticeStep& step : cell()->members(last->at.orbit))
            if (const auto seen = far_tool_->seen({last->at.orbit, step})) {
                tell("opposite at", seen, far_port_);
                break;
            }
    }
    if (line == told_) return;
    told_ = line;
    event(line);
}

// --- commands -------------------------------------------------------------------------------------------------------------------------

/// The points that are picked, and the pane that is shown, are those that the panel is about.
void CellWindow::pass_selection()
{
    const Operator* op = session_.chosen();
    if (!op || op->family() != "cell") return;
    session_.let_go(); // the step that was made stays what it is
    if (op->name == "cell.move") session_.set("points", selection_.text());
    else if (op->find("pane") && plane_.pane() >= 0) session_.set("pane", std::to_string(plane_.pane()));
}

void CellWindow::choose(const Operator& op)
{
    SourceWindow::choose(op);
    pass_selection();
}

/// Is there a cell? The status line says so if not.
bool CellWindow::has_cell()
{
    if (cell()) return true;
    session_.say(Message::Kind::note, "choose a cell first");
    refresh();
    return false;
}

bool CellWindow::is_pane_flat() const { return !cell() || (plane_.pane() >= 0 ? cell()->is_flat(plane_.pane()) : cell()->phase() == 1); }

void CellWindow::choose_kind()
{
    const auto kind = choose_cell_kind(cell() ? std::optional(cell()->cell().kind) : std::nullopt);
    if (!kind) return;
    constexpr double usual_size = 20;
    session_.run_chosen(fmt::format("cell.new cell={} size={}", name(*kind), cell() ? cell()->size() : usual_size));
    session_.wait();
    canvas_.take_focus();
}

/// Turns to a pane and opens it; −1: back to how the cell was seen before.
void CellWindow::show_pane(int pane, bool far)
{
    if (!cell() || pane >= cell()->pane_count()) return;
    if (pane >= 0) {
        if (!before_pane_) before_pane_ = {near_.camera().angles(), far_.camera().angles()};
        plane_.show_pane(pane);
        link_.look_at(normal_of(*cell(), {pane, far}));
        const Point2 middle = plane_.plane().picture(Point2(0.0));
        event(fmt::format("pane {} {} at {:.1f},{:.1f} by {:.6g}", pane, far ? "far" : "near", canvas_.x() + middle.x, canvas_.y() + middle.y, plane_.plane().pixels));
    } else {
        plane_.show_pane(-1);
        if (before_pane_) near_.look(before_pane_->first, pane_turn_seconds);
        if (before_pane_ && !link_.is_linked()) far_.look(before_pane_->second, pane_turn_seconds);
        before_pane_.reset();
        event("pane none");
    }
    picture_.follow(cell(), plane_.pane());
    pass_selection();
    redraw_views();
    refresh();
}

void CellWindow::step_pane(int by)
{
    if (!has_cell()) return;
    const int count = cell()->pane_count();
    show_pane(plane_.pane() < 0 ? (by > 0 ? 0 : count - 1) : (plane_.pane() + by + count) % count, false);
}

/// Phase I of the pane that is shown.
void CellWindow::go_to_panes()
{
    if (!has_cell() || is_pane_flat()) return;
    const int pane = plane_.pane();
    if (pane < 0) {
        session_.say(Message::Kind::note, "one pane goes back at a time: right click it in space first");
        refresh();
        return;
    }
    const PaneShape shape = shape_of(*cell(), pane);
    const RollBack answer = shape.empty() ? RollBack::keep : ask_how_to_roll_back(pane, shape);
    if (answer == RollBack::cancel) return;
    session_.run_chosen(fmt::format("cell.rollback pane={}{}", pane, answer == RollBack::anew ? " keep=false" : ""));
}

void CellWindow::go_to_shape()
{
    if (!has_cell()) return;
    bool some_flat = false;
    for (int pane = 0; pane < cell()->pane_count(); ++pane) some_flat = some_flat || cell()->is_flat(pane);
    if (some_flat) session_.run("cell.shape");
}

void CellWindow::set_mode(CellTool::Mode mode)
{
    for (CellTool* tool : {near_tool_, far_tool_}) tool->set_mode(mode);
    redraw_views();
    update_hint();
    bar_.refresh();
}

void CellWindow::set_along(CellTool::Along along)
{
    for (CellTool* tool : {near_tool_, far_tool_}) tool->set_along(along);
    redraw_views();
    tell_selection();
    bar_.refresh();
}

/// Cells that come into view are framed, and so is the cell alone when they go.
void CellWindow::set_neighbours(double shrink)
{
    const bool other_cells = (shrink > 0) != (picture_.neighbours() > 0) || (shrink > 0 && shells_.value() + 1 != picture_.shells());
    picture_.set_neighbours(shrink, shells_.value() + 1);
    if (other_cells) frame_views();
    redraw_views();
}

void CellWindow::frame_views()
{
    if (!cell()) return;
    for (View* view : {&near_, &far_}) {
        if (link_.is_linked() && view != (&first_port() == &near_port_ ? &near_ : &far_)) continue; // it follows
        if (shows_solid() || picture_.neighbours() > 0) view->frame_all();
        else view->frame(around(picture_.solid(), view->camera()));
    }
}

/// The mesh that was made is left aside, until there is another one.
void CellWindow::show_cell_again()
{
    shows_cell_again_ = true;
    picture_.is_shown = true;
    event("shows the cell");
    near_.leave(), far_.leave(); // what was under the pointer was the mesh's
    redraw_views();
    refresh();
}

/// Escape. @return false if there is nothing to take back
bool CellWindow::cancel_gesture()
{
    if (skew_.cancel()) {
        canvas_.take_focus();
        return true;
    }
    const bool is_gesturing = near_.is_gesturing() || far_.is_gesturing() || plane_.is_gesturing();
    if (!is_gesturing && (plane_.is_box_next() || near_.is_box_next() || far_.is_box_next())) {
        forget_boxes(); // the next drag is none, in whichever part
        update_hint();
        return true;
    }
    if (near_.cancel() || far_.cancel() || plane_.cancel()) return true;
    if (selection_.empty()) return false;
    selection_.clear();
    return true;
}

/// Points of the pane while it is flat, or those in space.
void CellWindow::select_all()
{
    if (!has_cell()) return;
    if (plane_.pane() >= 0 && is_pane_flat()) return plane_.select_all();
    if (cell()->phase() == 1) return;
    std::vector<OrbitMember> points;
    for (int point = 0; point < cell()->point_count(); ++point)
        if (const int pane = cell()->pane_of(point); pane < 0 || !cell()->is_flat(pane)) points.push_back({point, {}}); // those in a flat pane stay in its plane
    selection_.pick(*cell(), points);
}

/// The next drag is a box, in the part that the pointer is in; where it is in none, as after a menu, in the first that takes one.
void CellWindow::start_box()
{
    const Fl_Widget* below = Fl::belowmouse();
    const bool anywhere = below != &canvas_ && below != &near_port_ && below != &far_port_;
    forget_boxes();
    if (anywhere || below == &canvas_) plane_.start_box();
    if (anywhere || below == &near_port_) near_.start_box_select();
    if (anywhere || below == &far_port_) far_.start_box_select();
    update_hint();
}

void CellWindow::forget_boxes()
{
    plane_.forget_box();
    near_.forget_box();
    far_.forget_box();
}

/// Turns the first view and the other one with it, or that which the pointer is in where they turn by themselves.
void CellWindow::look(ViewAngles angles)
{
    const bool far = link_.is_linked() ? &first_port() == &far_port_ : Fl::belowmouse() == &far_port_;
    (far ? far_ : near_).look(angles);
    animate_.start(cell_frame_time); // the view may be hidden, and then no frame of its own starts it
}

/// Of what the pointer is in.
void CellWindow::zoom(double factor)
{
    if (Fl::belowmouse() == &near_port_) near_.zoom(factor);
    else if (Fl::belowmouse() == &far_port_) far_.zoom(factor);
    else plane_.zoom(factor);
}

void CellWindow::set_single(bool single)
{
    single_ = single;
    Viewport &first = first_port(), &second = &first == &near_port_ ? far_port_ : near_port_;
    first.show();
    single ? second.hide() : second.show();
    place_parts();
    redraw();
    menu_->refresh();
}

void CellWindow::export_cell()
{
    if (!has_cell()) return;
    const auto asked = ask_how_to_export_cell(facts());
    if (!asked) return;
    if (!asked->to_files) {
        if (make_solid(asked->command)) hand_over();
    } else if (const auto file = ask_for_solid_file()) {
        export_solids({{asked->command, *file}});
    }
}

bool CellWindow::is_in_view(int, int y) const { return y >= canvas_.y() && y < canvas_.y() + canvas_.h(); }

bool CellWindow::other_key(int key)
{
    if (key != FL_BackSpace) return false;
    plane_.remove();
    return true;
}

} // namespace druse::ui
