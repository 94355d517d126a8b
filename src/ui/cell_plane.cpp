#include "ui/cell_plane.h"

#include "ui/cell_match.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

namespace druse::ui {

namespace {

bool is_same_thing(const PaneHit& a, const PaneHit& b) { return a.point == b.point && a.rim == b.rim && a.line == b.line && a.inside == b.inside; }

} // namespace

// --- following the session ------------------------------------------------------------------------------------------------------------

void CellPlane::session_changed()
{
    const Scene* scene = session_.scene();
    if (scene && session_.document_version() != cell_version_) {
        cell_version_ = session_.document_version();
        const CellTile* held = std::get_if<CellTile>(&*scene->source);
        const bool is_same_kind = held && cell_ && held->cell().kind == cell_->cell().kind, has_other_size = held && cell_ && held->cell().volume() != cell_->cell().volume();
        if (!selected_.empty()) follow_selected(is_same_kind ? held : nullptr);
        const auto grabbed = has_point_pressed() && is_same_kind ? CellMatch(*cell_, *held).now(CellPointName::parse(grabbed_point_.name)) : std::nullopt;
        cell_ = held ? std::optional(*held) : std::nullopt;
        shown_pane_ = is_same_kind && shown_pane_.pane >= 0 ? ui::shown_pane(*cell_, shown_pane_.pane) : ShownPane();
        hovered_.reset();
        if (shown_pane_.pane < 0 || !shown_pane_.is_flat) take_back();
        else if (has_point_pressed()) grab_again(grabbed ? grabbed->text() : std::string());
        else if (gesture_ == Gesture::click) grab(hit(pressed_));
        if (has_other_size) frame();
        if (pointer_ && gesture_ == Gesture::none && shown_pane_.pane >= 0) hovered_ = hit(*pointer_);
    }
    if (step_) {
        if (is_dragging() && is_refused() && !step_->is_waiting() && pointer_) refused_ = Refused{grabbed_.point, plane_.plane(*pointer_) + grip_};
        else refused_.reset();
        step_->go_on();
    }
    redraw();
}

/// The same points stay selected, whatever they are called in the cell that is there now.
void CellPlane::follow_selected(const CellTile* now)
{
    if (!now) return selected_.clear();
    const CellMatch match(*cell_, *now);
    if (match.keeps_names()) return;
    std::set<std::string> names;
    for (const std::string& text : selected_)
        if (const auto name = match.now(CellPointName::parse(text))) names.insert(name->text());
    selected_ = std::move(names);
}

void CellPlane::grab(const PaneHit& what)
{
    grabbed_ = what;
    if (grabbed_.point >= 0) grabbed_point_ = shown_pane_.points[static_cast<std::size_t>(grabbed_.point)];
}

/// A point was pressed, and nothing came of it yet: something else may have been done to the cell since.
bool CellPlane::has_point_pressed() const
{
    if (grabbed_.point < 0) return false;
    return gesture_ == Gesture::click || gesture_ == Gesture::constrain || (gesture_ == Gesture::edit && step_ && !step_->is_made());
}

/// The point that is pressed, by what it is called now; it may be gone.
void CellPlane::grab_again(const std::string& name)
{
    const auto found = std::ranges::find(shown_pane_.points, name, &PanePoint::name);
    if (found == shown_pane_.points.end()) {
        take_back();
        return;
    }
    PaneHit there = grabbed_;
    there.point = static_cast<int>(found - shown_pane_.points.begin());
    grab(there);
    if (gesture_ == Gesture::edit && step_->is_waiting()) drag_to(last_);
}

void CellPlane::show_pane(int pane)
{
    if (pane == shown_pane_.pane || (pane >= 0 && (!cell_ || pane >= cell_->pane_count()))) return;
    take_back();
    select({});
    hovered_.reset();
    shown_pane_ = pane >= 0 ? ui::shown_pane(*cell_, pane) : ShownPane();
    frame();
}

void CellPlane::set_shown(const Shown& shown)
{
    shown_ = shown;
    redraw();
}

void CellPlane::mark(std::set<std::string> names)
{
    marked_ = std::move(names);
    redraw();
}

std::optional<PlaneEditor::Line> CellPlane::framed() const
{
    if (shown_pane_.pane < 0) return {};
    const Point2 low = shown_pane_.low(), high = shown_pane_.high(), margin = 0.12 * (high - low);
    return Line(low - margin, high + margin);
}

// --- what is under the pointer --------------------------------------------------------------------------------------------------------

PaneHit CellPlane::hit(const Point2& picture) const
{
    PaneHit found;
    found.at = plane_.plane(picture);
    found.point = point_near(found.at, reach());
    if (found.point >= 0) return found;
    const auto& points = shown_pane_.points;
    double nearest = reach();
    const auto is_nearer = [&](PaneMesh::Index a, PaneMesh::Index b) {
        const double d = glm::distance(found.at, foot_on_piece(found.at, points[a].at, points[b].at));
        if (d >= nearest) return false;
        nearest = d;
        return true;
    };
    for (std::size_t i = 0; i < shown_pane_.rim.size(); ++i)
        if (is_nearer(shown_pane_.rim[i], shown_pane_.rim[(i + 1) % shown_pane_.rim.size()])) found.rim = int(i);
    if (found.rim >= 0) return found;
    for (std::size_t i = 0; i < shown_pane_.lines.size(); ++i)
        if (is_nearer(shown_pane_.lines[i].ends[0], shown_pane_.lines[i].ends[1])) found.line = int(i);
    found.inside = shown_pane_.holds(found.at);
    return found;
}

int CellPlane::point_near(const Point2& place, double nearest) const
{
    int found = -1;
    for (std::size_t i = 0; i < shown_pane_.points.size(); ++i)
        if (const double d = glm::distance(place, shown_pane_.points[i].at); d < nearest) nearest = d, found = int(i);
    return found;
}

int CellPlane::hovered_orbit() const { return hovered_ && hovered_->point >= 0 ? shown_pane_.points[std::size_t(hovered_->point)].orbit : -1; }

int CellPlane::hovered_edge() const
{
    if (!hovered_ || hovered_->rim < 0) return -1;
    return shown_pane_.sides[std::size_t(shown_pane_.rim_sides[std::size_t(hovered_->rim)])].edge.orbit;
}

std::string CellPlane::invitation() const
{
    if (!cell_) return "Choose a kind of cell at the top left, or open one.";
    return shown_pane_.pane < 0 ? "Right click a pane of the cell to edit it here." : "";
}

std::string CellPlane::hint() const
{
    using Kind = PanePoint::Kind;
    if (!cell_) return "choose a kind of cell";
    if (shown_pane_.pane < 0) return "right click a pane of the cell to edit it";
    if (!shown_pane_.is_flat) return "this pane has its shape: roll it back to edit it";
    if (box_next_ || gesture_ == Gesture::box) return "drag a box around points; Shift adds, Ctrl removes";
    if (constrain_next_ || gesture_ == Gesture::constrain) return "drag from one point to another";
    if (!hovered_) return "wheel zooms, right drag moves the plane";
    if (hovered_->point >= 0) {
        const PanePoint& p = shown_pane_.points[std::size_t(hovered_->point)];
        switch (p.kind) {
        case Kind::interior: return fmt::format("{} at {:.4g}, {:.4g}: drag moves, Delete removes, c and a drag constrains", p.name, p.at.x, p.at.y);
        case Kind::edge: return fmt::format("{} stays on its edge: {}a drag to another point constrains", p.name, shown_pane_.may_edit_sides ? "Delete removes it there, " : "");
        case Kind::corner:
        case Kind::split: return p.name + " stays where it is: a drag to another point constrains";
        }
    }
    if (hovered_->rim >= 0)
        return shown_pane_.may_edit_sides ? fmt::format("click adds a point to edge {}, wherever it is", hovered_edge()) : "points of edges come and go only while all panes are flat";
    if (hovered_->line >= 0) return selected_.empty() ? "click adds a point to the line, Delete removes the line" : "click adds a point to the line";
    return hovered_->inside ? "click adds a point" : "drag moves the plane, wheel zooms";
}

// --- the mouse ------------------------------------------------------------------------------------------------------------------------

bool CellPlane::may_edit()
{
    if (!shown_pane_.is_flat) note("roll the pane back to edit it");
    return shown_pane_.is_flat;
}

PlaneEditor::Gesture CellPlane::begin(const Pointer&)
{
    PaneHit what = hit(pressed_);
    if (constrain_next_ && what.point < 0) {
        constexpr double generous = 3; // times as far as a point is reached otherwise: nothing else is meant now
        what.point = point_near(what.at, generous * reach());
        if (what.point < 0) {
            note("a line begins at a point");
            return Gesture::none;
        }
    }
    grab(what);
    if (box_next_) return Gesture::box;
    return constrain_next_ && grabbed_.point >= 0 ? Gesture::constrain : Gesture::click;
}

PlaneEditor::Gesture CellPlane::begin_drag(const Pointer&)
{
    if (grabbed_.point < 0 || !may_edit()) return Gesture::pan;
    if (grabbed_point_.kind != PanePoint::Kind::interior) return Gesture::constrain; // it does not move, so that is what is meant
    grip_ = grabbed_point_.at - grabbed_.at;
    return Gesture::edit;
}

void CellPlane::drag_to(const Point2& picture)
{
    step_->send(fmt::format("cell.point_move point={} to={}", grabbed_point_.name, place_text(plane_.plane(picture) + grip_)));
}

void CellPlane::click(const Pointer& p)
{
    if (grabbed_.point < 0 && grabbed_.rim < 0 && !grabbed_.inside) return select({});
    if (!may_edit()) return;
    if (grabbed_.point >= 0) {
        select_clicked(grabbed_point_.name, p);
    } else if (p.shift || p.ctrl) {
        return;
    } else if (grabbed_.rim >= 0) {
        add_edge_point(grabbed_);
    } else if (grabbed_.line >= 0 && std::size_t(grabbed_.line) < shown_pane_.lines.size()) {
        const auto& ends = shown_pane_.lines[std::size_t(grabbed_.line)].ends;
        const Point2 at = foot_on_piece(grabbed_.at, shown_pane_.points[ends[0]].at, shown_pane_.points[ends[1]].at); // on the line to the last bit
        session_.run(fmt::format("cell.point_add pane={} at={},{}", shown_pane_.pane, at.x, at.y));
    } else {
        session_.run(fmt::format("cell.point_add pane={} at={}", shown_pane_.pane, place_text(grabbed_.at)));
    }
}

/// At the foot of the pointer on the side, between the points that are beside it there. Steps of the grid are counted along the side from the foot of the pane's
/// middle, where an axis crosses it if it runs along the other one. In decimals of some tenth of a pixel.
void CellPlane::add_edge_point(const PaneHit& at)
{
    const auto& rim = shown_pane_.rim;
    const auto i = std::size_t(at.rim);
    if (i >= rim.size()) return; // the pane is another by now
    const std::size_t k = std::size_t(shown_pane_.rim_sides[i]);
    const Point2 from = shown_pane_.outline[k], to = shown_pane_.outline[(k + 1) % shown_pane_.outline.size()];
    const double length = glm::distance(from, to);
    const auto along = [&](const Point2& p) { return glm::dot(p - from, to - from) / length; };
    const double low = along(shown_pane_.points[rim[i]].at), high = along(shown_pane_.points[rim[(i + 1) % rim.size()]].at);
    double place = along(at.at);
    if (snaps()) {
        const double foot = along(Point2(0.0)), snapped = foot + std::round((place - foot) / grid()) * grid();
        if (snapped > low + cell_->snap() && snapped < high - cell_->snap()) place = snapped;
    }
    const double parts = std::pow(10, std::ceil(std::log10(5 * plane_.pixels * length))), t = std::clamp(place, low, high) / length;
    const CellSide& side = shown_pane_.sides[k];
    session_.run(fmt::format("cell.edge_add edge={} t={}", side.edge.orbit, std::round((side.reversed ? 1 - t : t) * parts) / parts));
}

std::optional<Point2> CellPlane::constraint_start() const { return grabbed_point_.at; }

void CellPlane::end_constraint(const Point2& picture)
{
    const int to = point_near(plane_.plane(picture), reach());
    if (to < 0) note("a line ends at a point; " + grabbed_point_.name + " stays where it is");
    if (to < 0 || to == grabbed_.point) return;
    const PanePoint& end = shown_pane_.points[std::size_t(to)];
    draw_line(fmt::format("cell.constrain pane={} from={} to={}", shown_pane_.pane, grabbed_point_.here.text(), end.here.text()), Line(grabbed_point_.at, end.at));
}

void CellPlane::select_box(const Point2& low, const Point2& high, const Pointer& p)
{
    std::set<std::string> names = p.shift || p.ctrl ? selected_ : std::set<std::string>();
    for (const PanePoint& point : shown_pane_.points) {
        if (point.at.x < low.x || point.at.y < low.y || point.at.x > high.x || point.at.y > high.y) continue;
        if (p.ctrl) names.erase(point.name);
        else names.insert(point.name);
    }
    select(std::move(names));
}

void CellPlane::select_all()
{
    std::set<std::string> names;
    for (const PanePoint& point : shown_pane_.points) names.insert(point.name);
    select(std::move(names));
}

void CellPlane::hover(const Pointer& p)
{
    pointer_ = Point2(p.x, p.y);
    if (gesture_ != Gesture::none || shown_pane_.pane < 0) return;
    const PaneHit found = hit(*pointer_);
    if (!hovered_ || !is_same_thing(*hovered_, found)) redraw();
    hovered_ = found;
}

void CellPlane::leave()
{
    pointer_.reset();
    hovered_.reset();
    redraw();
}

void CellPlane::forget_refused()
{
    PlaneEditor::forget_refused();
    refused_.reset();
}

void CellPlane::remove_chain(int chain)
{
    std::vector<std::string> names;
    for (const CellPointName& name : shown_pane_.chains[std::size_t(chain)]) names.push_back(name.text());
    if (names.size() == 2) session_.run(fmt::format("cell.unconstrain pane={} from={} to={}", shown_pane_.pane, names[0], names[1]));
    else session_.run(fmt::format("cell.unconstrain pane={} path={}", shown_pane_.pane, fmt::join(names, ",")));
}

void CellPlane::remove()
{
    if (shown_pane_.pane < 0 || gesture_ != Gesture::none) return;
    std::set<std::string> names = selected_;
    if (names.empty() && hovered_ && hovered_->point >= 0) names.insert(shown_pane_.points[std::size_t(hovered_->point)].name);
    const bool is_line = names.empty() && hovered_ && hovered_->line >= 0;
    if ((names.empty() && !is_line) || !may_edit()) return;
    if (is_line) return remove_chain(shown_pane_.lines[std::size_t(hovered_->line)].chain);
    std::vector<std::string> points;
    bool inside = false, of_edges = false;
    for (const std::string& text : names) {
        const CellPointName::Kind kind = CellPointName::parse(text).kind;
        inside = inside || kind == CellPointName::Kind::interior;
        of_edges = of_edges || kind == CellPointName::Kind::edge;
        if (kind == CellPointName::Kind::interior || (kind == CellPointName::Kind::edge && shown_pane_.may_edit_sides)) points.push_back(text);
    }
    if (points.empty()) return note(of_edges ? "points of edges come and go only while all panes are flat" : "corners stay");
    select({points.begin(), points.end()}); // they go when the command has run
    session_.run(fmt::format("cell.{}_remove point={}", inside ? "point" : "edge", fmt::join(points, ",")));
}

} // namespace druse::ui
