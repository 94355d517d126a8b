#include "ui/pane_tool.h"

#include "ui/layout.h"

#include "ops/shown_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace druse::ui {

namespace {

constexpr double near_pixels = 6;
constexpr double rim_pixels = 60; // how far from the boundary a click draws it out

struct ActWord {
    const char* op;
    PaneTool::Act act;
};
constexpr std::array<ActWord, 7> act_words{{{"pane.add", PaneTool::Act::add},
                                            {"pane.add_boundary", PaneTool::Act::add_boundary},
                                            {"pane.move", PaneTool::Act::move},
                                            {"pane.remove", PaneTool::Act::remove},
                                            {"pane.lock", PaneTool::Act::lock},
                                            {"pane.constrain", PaneTool::Act::constrain},
                                            {"pane.unconstrain", PaneTool::Act::unconstrain}}};

std::string place_argument(const Point2& p) { return fmt::format("{},{}", p.x, p.y); }
std::string id_argument(PointId point) { return std::to_string(std::uint32_t(point)); }

/// The nearest line that is more than a side of triangles.
struct NearLine {
    double distance = 1e300;
    Point2 foot{0.0};
    PaneEdge edge{};
    std::optional<SegmentId> segment;

    void look_at(const Pane& pane, PointId a, PointId b, const Point2& p, std::optional<SegmentId> of)
    {
        const Point2 from = pane.position(a), along = pane.position(b) - from;
        const double length2 = glm::dot(along, along), t = length2 > 0 ? std::clamp(glm::dot(p - from, along) / length2, 0.0, 1.0) : 0.0;
        const Point2 q = from + t * along;
        if (const double d = glm::distance(p, q); d < distance) *this = {d, q, {a, b}, of};
    }
};

} // namespace

std::optional<PaneTool::Act> PaneTool::act_of(const std::string& op)
{
    const auto found = std::ranges::find(act_words, op, &ActWord::op);
    return found == act_words.end() ? std::nullopt : std::optional(found->act);
}

const Pane* PaneTool::pane() const
{
    const Scene* scene = session_.scene();
    return scene && shows_source(*scene) ? std::get_if<Pane>(&*scene->source) : nullptr;
}

/// Where the line of sight meets the plane of the pane.
std::optional<Point2> PaneTool::place(const Pointer& pointer) const
{
    const Ray ray = camera_.ray(pointer.x, pointer.y);
    if (std::abs(ray.direction.z) < 1e-6 * glm::length(ray.direction)) return {};
    return Point2(ray.origin - ray.origin.z / ray.direction.z * ray.direction);
}

double PaneTool::reach(const Pane& pane) const { return std::max(pane.snap(), near_pixels * layout().scale * camera_.unit_per_pixel()); }

/// To a tenth of what a pixel is, so that commands can be read.
Point2 PaneTool::tidy(const Point2& p) const
{
    const double step = std::pow(10, std::floor(std::log10(0.2 * camera_.unit_per_pixel())));
    const auto rounded = [step](double x) { return (step < 1 ? std::round(x / step) / std::round(1 / step) : std::round(x / step) * step) + 0.0; };
    return {rounded(p.x), rounded(p.y)};
}

/// In the order of the pane itself: a point, else a line, else the place.
std::optional<PaneTool::Found> PaneTool::find(const Pointer& pointer, std::optional<PointId> besides) const
{
    const Pane* pane = this->pane();
    const auto p = place(pointer);
    if (!pane || !p) return {};
    const double reach = this->reach(*pane);
    Found found{tidy(*p), {}, {}, {}};
    double nearest = reach;
    for (const PointId point : pane->points())
        if (const double d = glm::distance(pane->position(point), *p); d < nearest && point != besides) nearest = d, found.point = point;
    if (found.point) {
        found.at = pane->position(*found.point);
        return found;
    }
    NearLine line;
    for (std::size_t i = 0; i <= pane->hole_count(); ++i) {
        const std::vector<PointId> loop = pane->loop(i);
        for (std::size_t k = 0; k < loop.size(); ++k) line.look_at(*pane, loop[k], loop[(k + 1) % loop.size()], *p, {});
    }
    const double rim = line.distance;
    for (const SegmentId segment : pane->segments()) {
        const std::vector<PointId> chain = pane->chain(segment);
        for (std::size_t k = 1; k < chain.size(); ++k) line.look_at(*pane, chain[k - 1], chain[k], *p, segment);
    }
    if (line.distance < reach) {
        found.edge = line.edge;
        found.segment = line.segment;
        if (act_ != Act::add_boundary) found.at = line.foot;
    }
    // Beside everything a drag turns the view.
    const double farthest = act_ == Act::add_boundary ? rim_pixels * layout().scale * camera_.unit_per_pixel() : reach;
    bool inside = false;
    for (std::size_t i = 0; i <= pane->hole_count(); ++i) {
        const std::vector<PointId> loop = pane->loop(i);
        for (std::size_t k = 0, last = loop.size() - 1; k < loop.size(); last = k++) {
            const Point2 &a = pane->position(loop[k]), &b = pane->position(loop[last]);
            if ((a.y > p->y) != (b.y > p->y) && p->x < a.x + (p->y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
        }
    }
    return inside || rim < farthest ? std::optional(found) : std::nullopt;
}

std::optional<Target> PaneTool::under(const Pointer& pointer) const
{
    const auto found = find(pointer);
    if (!found) return {};
    Target target;
    switch (act_) {
    case Act::add:
    case Act::add_boundary: target.name = fmt::format("place {},{}", found->at.x, found->at.y); return target;
    case Act::unconstrain:
        if (!found->segment) return {};
        target.name = fmt::format("segment {}", std::uint32_t(*found->segment));
        return target;
    case Act::move:
    case Act::remove:
    case Act::lock:
    case Act::constrain: break;
    }
    if (!found->point) return {};
    target.name = "point " + id_argument(*found->point);
    return target;
}

void PaneTool::act(const Target&, const Pointer& pointer)
{
    const auto found = find(pointer);
    if (!found) return;
    switch (act_) {
    case Act::add:
    case Act::add_boundary: {
        Session::Overrides target{{"at", place_argument(found->at)}};
        if (found->edge) target.push_back({"edge", fmt::format("{}~{}", std::uint32_t(found->edge->a), std::uint32_t(found->edge->b))});
        session_.apply_chosen(target);
        break;
    }
    case Act::move: break; // a drag does that
    case Act::remove:
        if (found->point) session_.apply_chosen({{"point", id_argument(*found->point)}});
        break;
    case Act::lock:
        if (found->point) session_.apply_chosen({{"points", id_argument(*found->point)}});
        break;
    case Act::constrain:
        if (!found->point) break;
        if (!first_) first_ = found->point;
        else if (*first_ == *found->point) first_.reset();
        else session_.apply_chosen({{"from", id_argument(*std::exchange(first_, std::nullopt))}, {"to", id_argument(*found->point)}});
        break;
    case Act::unconstrain:
        if (found->segment) session_.apply_chosen({{"segment", std::to_string(std::uint32_t(*found->segment))}});
        break;
    }
}

std::unique_ptr<Gesture> PaneTool::press(const Pointer& start, const ShowTarget& show)
{
    const auto found = act_ == Act::move ? find(start) : std::nullopt;
    if (!found || !found->point) return Tool::press(start, show);
    return std::make_unique<Move>(*this, *found->point);
}

/// Onto another point or line it is there to the last bit; where it may not be, the last place where it may stands.
void PaneTool::Move::move(const Pointer& pointer)
{
    step_.go_on();
    const auto p = tool_.place(pointer);
    if (!p) return;
    const auto found = tool_.find(pointer, point_);
    step_.send(fmt::format("pane.move point={} to={}", id_argument(point_), place_argument(found && found->point ? found->at : tool_.tidy(*p))));
}

void PaneTool::add_dot(const Point2& at, double size, Overlay& overlay) const
{
    const Point p(at, 0.0);
    overlay.lines.push_back({p, p, overlay.highlight, size * layout().scale, 1});
}

void PaneTool::add_marks(Overlay& overlay) const
{
    constexpr Colour segment_colour{0xe8, 0xa3, 0x3d};
    constexpr std::size_t most_lines = 5000;
    const Pane* pane = this->pane();
    if (!pane) return;
    for (const SegmentId segment : pane->segments()) {
        if (overlay.lines.size() > most_lines) break;
        const std::vector<PointId> chain = pane->chain(segment);
        for (std::size_t k = 1; k < chain.size(); ++k)
            overlay.lines.push_back({Point(pane->position(chain[k - 1]), 0.0), Point(pane->position(chain[k]), 0.0), segment_colour, 2.5 * layout().scale, 1});
    }
    if (first_ && pane->exists(*first_)) add_dot(pane->position(*first_), 11, overlay);
}

void PaneTool::add_pointer(const Pointer& pointer, Overlay& overlay) const
{
    const auto found = under(pointer) ? find(pointer) : std::nullopt;
    const Pane* pane = this->pane();
    if (!found || !pane) return;
    if (act_ == Act::unconstrain) {
        const std::vector<PointId> chain = pane->chain(*found->segment);
        for (std::size_t k = 1; k < chain.size(); ++k)
            overlay.lines.push_back({Point(pane->position(chain[k - 1]), 0.0), Point(pane->position(chain[k]), 0.0), overlay.highlight, 4 * layout().scale, 1});
        return;
    }
    add_dot(found->at, found->point ? 11 : 7, overlay);
    if (first_ && pane->exists(*first_)) overlay.lines.push_back({Point(pane->position(*first_), 0.0), Point(found->at, 0.0), overlay.highlight, 2 * layout().scale, 1});
}

std::string PaneTool::hint() const
{
    if (!pane()) return "the document shows no pane: pane.new makes one";
    switch (act_) {
    case Act::add: return "click inside, or on a line, to add a point";
    case Act::add_boundary: return "click near the boundary to draw it out there";
    case Act::move: return "drag a point";
    case Act::remove: return "click a point to remove it";
    case Act::lock: return "click a point to lock it";
    case Act::constrain: return first_ ? "click the point that the line goes to" : "click the point that a line begins at";
    case Act::unconstrain: return "click a line to remove it";
    }
    return {};
}

std::string PaneTool::pressed_hint() const
{
    return act_ == Act::move ? "release to leave it here; Escape takes it back" : Tool::pressed_hint();
}

} // namespace druse::ui
