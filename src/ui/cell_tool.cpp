#include "ui/cell_tool.h"

#include "ui/cell_match.h"
#include "ui/layout.h"

#include "render/picking.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace druse::ui {

namespace {

constexpr double least_arrow = 0.15; // of its length, that the arrow must have in the picture for a drag along it

double arrow_length() { return 76 * layout().scale; } // pixels, seen from the side
double arrow_reach() { return 6 * layout().scale; }   // how far the pointer may be from it
double arrow_start() { return 11 * layout().scale; }  // nearer to the point than that, the point is meant
double side_reach() { return 5 * layout().scale; }

bool is_end_on(const std::pair<Point2, Point2>& arrow) { return glm::distance(arrow.first, arrow.second) < least_arrow * arrow_length(); }

double distance_to_piece(const Point2& p, const Point2& a, const Point2& b) { return glm::distance(p, foot_on_piece(p, a, b)); }

/// What remains of a vector where the shortest turn brings the direction `from` to `to`, both of length 1 and not opposite.
Vector turned_by_least(const Vector& v, const Vector& from, const Vector& to)
{
    const Vector axis = glm::cross(from, to), across = glm::cross(axis, v);
    return v + across + glm::cross(axis, across) / (1 + glm::dot(from, to));
}

/// To a power of ten below a fraction of `unit`, so that commands can be read.
double tidy_move(double x, double unit)
{
    const double step = std::pow(10, std::floor(std::log10(0.2 * unit)));
    return (step < 1 ? std::round(x / step) / std::round(1 / step) : std::round(x / step) * step) + 0.0;
}

} // namespace

const char* name(CellTool::Along along)
{
    switch (along) {
    case CellTool::Along::radial: return "radial";
    case CellTool::Along::normal: return "normal";
    case CellTool::Along::x: return "x";
    case CellTool::Along::y: return "y";
    case CellTool::Along::z: return "z";
    }
    return "";
}

// --- what is under the pointer ------------------------------------------------------------------------------------------------------------

bool CellTool::is_hidden(const Point& place) const
{
    const auto seen = camera_.project(place);
    if (!seen) return true;
    const Ray ray = camera_.ray(seen->x, seen->y);
    const auto hit = pick_face(picture_.lists(), ray);
    return hit && hit->distance < glm::dot(place - ray.origin, ray.direction) - 1e-6 * camera_.distance();
}

bool CellTool::is_seen(Vertex v) const { return picture_.facing(camera_)[v.index] && !is_hidden(place(v)); }

std::optional<Point2> CellTool::seen(const OrbitMember& member) const
{
    const auto vertex = picture_.vertex_of(member);
    return vertex && is_seen(*vertex) ? camera_.project(place(*vertex)) : std::nullopt;
}

std::optional<Vertex> CellTool::vertex_under(const Pointer& p) const
{
    std::vector<std::pair<double, Vertex>> near;
    const std::vector<bool> facing = picture_.facing(camera_);
    for (std::uint32_t v = 0; v < facing.size(); ++v) {
        if (!facing[v]) continue;
        const auto seen = camera_.project(place(Vertex(v)));
        if (!seen) continue;
        if (const double away = glm::distance(*seen, Point2(p.x, p.y)); away <= layout().pick_radius()) near.emplace_back(away, Vertex(v));
    }
    std::ranges::sort(near);
    for (const auto& [away, v] : near)
        if (!is_hidden(place(v))) return v;
    return {};
}

std::optional<CellTool::Spot> CellTool::spot_under(const Pointer& p) const
{
    const auto hit = pick_face(picture_.lists(), camera_.ray(p.x, p.y));
    if (!hit || hit->copy > 0) return {};
    const CellSolid::Side side = picture_.pane_of(hit->face);
    Spot spot;
    spot.side = side;
    spot.face = hit->face;
    spot.at = hit->point;
    spot.triangle = picture_.triangle_of(hit->face);
    const auto& corners = picture_.solid().triangles[hit->face.index];
    for (std::size_t k = 0; k < 3; ++k) spot.corners[k] = Vertex(corners[k]);
    spot.points = picture_.cell()->mesh(side.pane).triangles[static_cast<std::size_t>(spot.triangle)];
    if (side.far) std::swap(spot.points[1], spot.points[2]);
    double nearest = side_reach();
    for (int k = 0; k < 3; ++k) {
        const auto a = camera_.project(place(spot.corners[static_cast<std::size_t>(k)])), b = camera_.project(place(spot.corners[static_cast<std::size_t>((k + 1) % 3)]));
        if (!a || !b) continue;
        if (const double away = distance_to_piece({p.x, p.y}, *a, *b); away <= nearest) nearest = away, spot.nearest_side = k;
    }
    return spot;
}

void CellTool::pick_pane(const Pointer& p) const
{
    if (!is_drawn() || !on_pane) return;
    const auto hit = pick_face(picture_.lists(), camera_.ray(p.x, p.y));
    if (!hit) on_pane(-1, false);
    else if (hit->copy == 0) on_pane(picture_.pane_of(hit->face).pane, picture_.pane_of(hit->face).far);
    else if (on_neighbour) on_neighbour();
}

std::optional<Target> CellTool::under(const Pointer& p) const
{
    if (!is_shaped()) return {};
    Target target;
    if (mode_ == Mode::select) {
        if (!p.shift && !p.ctrl && is_on_arrow(p)) {
            target.name = "arrow";
            return target;
        }
        target.vertex = vertex_under(p);
        if (target.vertex) return target;
        if (!p.twice) return {};
    }
    const auto spot = spot_under(p);
    if (!spot || (mode_ == Mode::flip && spot->nearest_side < 0)) return {};
    if (spot->nearest_side >= 0) {
        const auto k = static_cast<std::size_t>(spot->nearest_side);
        target.edge = picture_.edge_between(spot->corners[k], spot->corners[(k + 1) % 3]);
    } else {
        target.face = spot->face;
        target.faces = {spot->face};
    }
    return target;
}

// --- clicks -------------------------------------------------------------------------------------------------------------------------------

void CellTool::act(const Target& target, const Pointer& p)
{
    if (!is_shaped()) return;
    if (target.vertex) {
        if (target.vertex->index >= picture_.solid().points.size()) return; // it went since it was pressed
        selection_.click(*picture_.cell(), picture_.orbit_of(*target.vertex), p.shift, p.ctrl);
    } else if (const auto spot = target.name.empty() ? spot_under(p) : std::nullopt) {
        if (mode_ == Mode::flip) flip(*spot);
        else split(*spot);
    }
}

void CellTool::act_on_nothing()
{
    if (is_shaped() && mode_ == Mode::select) selection_.clear();
}

void CellTool::split(const Spot& spot)
{
    const CellTile& cell = *picture_.cell();
    if (spot.nearest_side >= 0) {
        const auto k = static_cast<std::size_t>(spot.nearest_side), next = (k + 1) % 3;
        const Point &a = place(spot.corners[k]), &b = place(spot.corners[next]);
        const double t = glm::dot(spot.at - a, b - a) / glm::dot(b - a, b - a);
        session_.run(fmt::format("cell.split_edge pane={} edge={},{} t={}", spot.side.pane, cell.pane_name(spot.side.pane, spot.points[k]).text(),
                                 cell.pane_name(spot.side.pane, spot.points[next]).text(), std::round(1000 * std::clamp(t, 0.001, 0.999)) / 1000));
        return;
    }
    const Point &a = place(spot.corners[0]), &b = place(spot.corners[1]), &c = place(spot.corners[2]);
    const Vector area = glm::cross(b - a, c - a);
    // In thousandths, each at least one.
    const auto weight = [&](const Point& from, const Point& to, int most) {
        return std::clamp(static_cast<int>(std::lround(1000 * glm::dot(glm::cross(from - spot.at, to - spot.at), area) / glm::dot(area, area))), 1, most);
    };
    const int first = weight(b, c, 998), second = weight(c, a, 999 - first);
    std::array<int, 3> at{first, second, 1000 - first - second};
    if (spot.side.far) std::swap(at[1], at[2]); // as its near pane has them
    session_.run(fmt::format("cell.split face=p{}:{} at={},{},{}", spot.side.pane, spot.triangle, at[0] / 1000.0, at[1] / 1000.0, at[2] / 1000.0));
}

void CellTool::flip(const Spot& spot)
{
    if (spot.nearest_side < 0) return;
    const auto k = static_cast<std::size_t>(spot.nearest_side);
    const auto text = [&](std::size_t i) { return picture_.cell()->pane_name(spot.side.pane, spot.points[i % 3]).text(); };
    session_.run(fmt::format("cell.flip pane={} edge={},{}", spot.side.pane, text(k), text(k + 1)));
}

bool CellTool::take_box(const Point2& low, const Point2& high, const Pointer& end)
{
    if (on_box) on_box();
    if (!is_shaped()) return true; // there is nothing to pick
    std::vector<OrbitMember> members;
    const std::vector<bool> facing = picture_.facing(camera_);
    for (std::uint32_t v = 0; v < facing.size(); ++v) {
        const auto seen = facing[v] ? camera_.project(place(Vertex(v))) : std::nullopt;
        if (!seen || seen->x < low.x || seen->y < low.y || seen->x > high.x || seen->y > high.y || is_hidden(place(Vertex(v)))) continue;
        members.push_back(picture_.orbit_of(Vertex(v)));
    }
    if (end.ctrl) selection_.drop(members);
    else if (end.shift) selection_.add(*picture_.cell(), members);
    else selection_.pick(*picture_.cell(), members);
    return true;
}

// --- the arrow ----------------------------------------------------------------------------------------------------------------------------

/// The pane that a point is moved with: its own; of several the one that is edited, or else the one that turns most to the viewer.
std::optional<CellSolid::Side> CellTool::side_at(const OrbitMember& member) const
{
    const CellTile& cell = *picture_.cell();
    if (const int pane = cell.pane_of(member.orbit); pane >= 0) return CellSolid::Side{pane, member.shift != LatticeStep{}};
    const auto vertex = picture_.vertex_of(member);
    if (!vertex) return {};
    std::set<CellSolid::Side> sides;
    const CellSolid& solid = picture_.solid();
    for (std::size_t i = 0; i < solid.triangles.size(); ++i)
        if (std::ranges::find(solid.triangles[i], vertex->index) != solid.triangles[i].end()) sides.insert(solid.sides[i]);
    std::optional<CellSolid::Side> best;
    double most = 0;
    for (const CellSolid::Side& side : sides) {
        const double toward = glm::dot(normal_of(cell, side), camera_.backward()) + (side.pane == plane_.pane() ? 4 : 0);
        if (!best || toward > most) best = side, most = toward;
    }
    return best;
}

std::optional<CellTool::Way> CellTool::way() const
{
    const CellSelection::Pick* last = selection_.last();
    if (!last || !is_shaped() || last->at.orbit >= picture_.cell()->point_count()) return {};
    const CellTile& cell = *picture_.cell();
    switch (along_) {
    case Along::radial: {
        // The command knows the first place of the orbit only.
        const Vector from_centre = direction(cell.position(last->at.orbit) + cell.cell().at(last->at.shift));
        if (from_centre == Vector(0.0)) return {};
        if (last->at.shift == LatticeStep{}) return Way{"along=radial", cell.world(from_centre), 1};
        return Way{fmt::format("along={:.6g},{:.6g},{:.6g}", from_centre.x + 0.0, from_centre.y + 0.0, from_centre.z + 0.0), cell.world(from_centre), 1};
    }
    case Along::normal: {
        const auto side = side_at(last->at);
        if (!side) return {};
        const double sign = side->far ? -1 : 1;
        return Way{fmt::format("along=normal pane={}", side->pane), cell.world(sign * cell.normal(side->pane)), sign};
    }
    case Along::x: return Way{"along=x", cell.world({1, 0, 0}), 1};
    case Along::y: return Way{"along=y", cell.world({0, 1, 0}), 1};
    case Along::z: return Way{"along=z", cell.world({0, 0, 1}), 1};
    }
    return {};
}

std::optional<std::pair<Point2, Point2>> CellTool::arrow() const
{
    const auto straight = mode_ == Mode::select ? way() : std::nullopt;
    const auto vertex = straight ? picture_.vertex_of(selection_.last()->at) : std::nullopt;
    if (!vertex) return {};
    const Point& at = place(*vertex);
    const double unit = camera_.unit_per_pixel_at(camera_.distance() - glm::dot(at - camera_.target(), camera_.backward()));
    const auto foot = camera_.project(at), tip = camera_.project(at + arrow_length() * unit * direction(straight->step));
    if (!foot || !tip) return {};
    return std::pair(*foot, *tip);
}

bool CellTool::is_on_arrow(const Pointer& p) const
{
    const auto ends = arrow();
    if (!ends) return false;
    const Point2 pointer(p.x, p.y);
    if (is_end_on(*ends) || glm::distance(pointer, ends->first) < arrow_start()) return false;
    return distance_to_piece(pointer, ends->first, ends->second) <= arrow_reach();
}

/// Takes what is picked along the arrow, or in the plane of a pane, with the pointer.
class CellTool::Move : public Gesture {
public:
    Move(CellTool& tool, const Target& target, const Pointer& start) : tool_(tool), target_(target), start_(start)
    {
        if (target.vertex) pressed_.emplace(*tool.picture_.cell(), tool.picture_.orbit_of(*target.vertex));
    }
    ~Move() override { tool_.is_moving_ = false; }

    void move(const Pointer& p) override
    {
        const Point2 by(p.x - start_.x, p.y - start_.y);
        if (!moved_ && (glm::length(by) < layout().click_slop() || !begin())) return;
        if (arrow_) {
            const double amount = glm::dot(by, pixels_) / glm::dot(pixels_, pixels_);
            tool_.step_->send(fmt::format("cell.move points={} {} amount={}", points_, arrow_->words, arrow_->sign * tidy_move(amount, unit_)));
        } else {
            const Vector to = unit_ * (by.x * right_ - by.y * up_);
            const Point2 place = in_pane_ * Point2(glm::dot(to, axes_[0]), glm::dot(to, axes_[1]));
            tool_.step_->send(fmt::format("cell.move points={} pane={} plane={},{}", points_, pane_, tidy_move(place.x, unit_), tidy_move(place.y, unit_)));
        }
    }
    void release(const Pointer& p) override
    {
        move(p); // or it would be lost where it came together with the release
        if (!moved_ && find_pressed()) tool_.act(target_, p);
    }
    void cancel() override
    {
        if (!moved_) return;
        tool_.step_->cancel();
        tool_.step_.reset();
    }

private:
    /// The point that was pressed, by its number in the cell that is there now: something may have been done since. @return false if it is gone
    bool find_pressed()
    {
        if (!pressed_ || !tool_.is_shaped()) return false;
        const auto& [cell, member] = *pressed_;
        const CellTile& now = *tool_.picture_.cell();
        const auto there = member_now(CellMatch(cell, now), cell, now, member);
        target_.vertex = there ? tool_.picture_.vertex_of(*there) : std::nullopt;
        return target_.vertex.has_value();
    }
    bool begin()
    {
        if (tool_.step_ && tool_.step_->is_waiting()) return false;
        if (pressed_) {
            if (!find_pressed()) return false;
            const OrbitMember member = tool_.picture_.orbit_of(*target_.vertex);
            if (!tool_.selection_.has(member)) tool_.act(target_, start_);
            if (!tool_.selection_.has(member) || !take_plane(member)) return false;
        } else if (!take_arrow()) {
            return false;
        }
        points_ = tool_.selection_.text();
        tool_.step_.emplace(tool_.session_);
        tool_.is_moving_ = moved_ = true;
        return true;
    }

    /// Directions are those of the picture as it is now, though the points go.
    bool take_arrow()
    {
        arrow_ = tool_.way();
        const auto vertex = arrow_ ? tool_.picture_.vertex_of(tool_.selection_.last()->at) : std::nullopt;
        if (!vertex) return false;
        const Point& at = tool_.place(*vertex);
        const double small = 1e-3 * tool_.camera_.distance() / glm::length(arrow_->step);
        const auto foot = tool_.camera_.project(at), head = tool_.camera_.project(at + small * arrow_->step);
        if (!foot || !head || *foot == *head) return false;
        pixels_ = (*head - *foot) / small;
        unit_ = 1 / glm::length(pixels_);
        return true;
    }

    /// Right and up in the picture are read in the plane of the pane, turned there by the smallest angle.
    bool take_plane(const OrbitMember& member)
    {
        const Camera& camera = tool_.camera_;
        const CellTile& cell = *tool_.picture_.cell();
        const auto side = tool_.side_at(member);
        if (!side) return false;
        pane_ = side->pane;
        Vector normal = normal_of(cell, *side);
        if (glm::dot(normal, camera.backward()) < 0) normal = -normal;
        right_ = turned_by_least(camera.right(), camera.backward(), normal);
        up_ = turned_by_least(camera.up(), camera.backward(), normal);
        const CellPane& pane = cell.cell().panes[static_cast<std::size_t>(pane_)];
        axes_ = {cell.world(pane.right), cell.world(pane.up)};
        const double a = glm::dot(axes_[0], axes_[0]), b = glm::dot(axes_[0], axes_[1]), c = glm::dot(axes_[1], axes_[1]);
        in_pane_ = glm::dmat2(c, -b, -b, a) / (a * c - b * b);
        unit_ = camera.unit_per_pixel_at(camera.distance() - glm::dot(tool_.place(*target_.vertex) - camera.target(), camera.backward()));
        return true;
    }

    CellTool& tool_;
    Target target_;
    std::optional<std::pair<CellTile, OrbitMember>> pressed_; // a point, in the cell as it was then
    Pointer start_;
    bool moved_ = false;
    std::string points_;
    double unit_ = 1; // for a pixel
    std::optional<Way> arrow_;
    Point2 pixels_{0.0}; // along the arrow, for 1
    int pane_ = 0;
    Vector right_{0.0}, up_{0.0};
    std::array<Vector, 2> axes_{};
    glm::dmat2 in_pane_{1.0}; // what two scalar products with them are in coordinates of the pane
};

std::unique_ptr<Gesture> CellTool::press(const Pointer& start, const ShowTarget& show)
{
    const auto target = under(start);
    if (!target || start.ctrl || !(target->vertex || target->name == "arrow")) return Tool::press(start, show);
    return std::make_unique<Move>(*this, *target, start);
}

std::string CellTool::hint() const
{
    if (!picture_.cell()) return "choose a kind of cell";
    if (!picture_.is_shown) return "this is the mesh that was made; a right click shows the cell again";
    if (!is_shaped()) return "right click a pane to edit it, beside the cell to leave it; drag to turn; Shape lets its points move in space";
    if (mode_ == Mode::split) return "click a triangle or an edge to split it, and its partner on the far pane";
    if (mode_ == Mode::flip) return "click an edge between two triangles to turn it into the other diagonal";
    if (selection_.empty()) return "click or Shift-click points, B and a drag boxes them; double click a triangle or edge to split it; right click a pane to edit it";
    if (const auto ends = arrow(); ends && is_end_on(*ends)) return "the arrow is seen end on: drag beside the points to turn the view; drag a point to move it in its pane";
    return "drag the red arrow to move along it, a point to move in its pane; drag beside them turns the view";
}

std::string CellTool::pressed_hint() const { return mode_ == Mode::select ? "with all that the lattice makes of it; Escape takes it back" : Tool::pressed_hint(); }

} // namespace druse::ui
