#include "ui/paint_tool.h"

#include "ui/layout.h"

#include "dlfl/measures.h"
#include "ops/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace druse::ui {

namespace {

/// What a brush goes over between press and release.
class StrokeGesture : public Gesture {
public:
    StrokeGesture(PaintTool& tool, const Pointer& start) : tool_(tool), start_(start), last_(start), taken_(tool.face_limit())
    {
        tool_.touch(start, taken_, faces_);
    }

    void move(const Pointer& p) override
    {
        const double length = std::hypot(p.x - last_.x, p.y - last_.y);
        const int steps = std::max(1, static_cast<int>(std::ceil(length / tool_.stride())));
        for (int i = 1; i <= steps; ++i) {
            Pointer between = p;
            between.x = std::lerp(last_.x, p.x, double(i) / steps);
            between.y = std::lerp(last_.y, p.y, double(i) / steps);
            tool_.touch(between, taken_, faces_);
        }
        last_ = p;
    }

    void release(const Pointer& p) override
    {
        move(p);
        std::ranges::sort(faces_);
        tool_.paint(faces_, start_);
    }

    void add_to(Overlay& overlay) const override
    {
        overlay.painted = faces_;
        std::ranges::sort(overlay.painted); // neighbours are drawn together
        overlay.paint = tool_.colour(start_);
    }

private:
    PaintTool& tool_;
    Pointer start_, last_; // whether it takes out of groups is settled when it begins
    std::vector<std::uint8_t> taken_;
    std::vector<Face> faces_;
};

double distance_to_segment(const Point& p, const Point& a, const Point& b)
{
    const Vector along = b - a;
    const double square = glm::dot(along, along);
    const double t = square > 0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * along);
}

/// A word for the status bar.
std::string named(int id, const GroupTable& groups)
{
    if (id == 0) return "no group";
    const std::string& name = groups.name(id);
    return name.empty() ? fmt::format("group {}", id) : fmt::format("group {} ({})", id, name);
}

} // namespace

// --- the brush ----------------------------------------------------------------------------------------------------------------

bool PaintTool::is_armed() const { return session_.chosen() && !session_.arguments().text("id").empty(); }

std::string PaintTool::id(const Pointer& pointer) const { return pointer.ctrl ? "0" : session_.arguments().text("id"); }

Colour PaintTool::colour(const Pointer& pointer) const
{
    const GroupTable& groups = *session_.display().groups;
    const std::string text = id(pointer);
    if (text == "new") return groups.colour(session_.display().group_sizes->empty() ? 1 : session_.display().group_sizes->back().id + 1);
    return groups.colour(static_cast<int>(parse_integer(text)));
}

double PaintTool::stride() const { return std::max(2.0, settings_.brush / 2); }

std::optional<Target> PaintTool::under(const Pointer& pointer) const
{
    auto target = face_under(pointer);
    if (!target || !is_armed()) return {};
    if (settings_.brush > 0) target->faces.clear(); // the disc shows what it takes
    return target;
}

void PaintTool::touch(const Pointer& pointer, std::vector<std::uint8_t>& taken, std::vector<Face>& faces) const
{
    const auto found = hit(pointer);
    if (!found) return;
    const auto take = [&](Face f) {
        if (f.index >= taken.size() || taken[f.index]) return;
        taken[f.index] = 1;
        faces.push_back(f);
    };
    take(found->face);
    const Mesh* mesh = settings_.brush > 0 ? session_.mesh() : nullptr;
    if (!mesh) return;

    const Vector away = camera_.backward();
    const double ahead = glm::dot(camera_.eye() - found->point, away);
    const double radius = settings_.brush * camera_.unit_per_pixel_at(camera_.parallel() ? camera_.distance() : ahead);
    const auto faces_eye = [&](Face f) {
        const Vector to_eye = camera_.parallel() ? away : camera_.eye() - mesh->position(mesh->vertex(mesh->corner(f)));
        const double cosine = glm::dot(area_vector(*mesh, f), to_eye);
        return found->from_behind ? cosine < 0 : cosine > 0;
    };
    // From face to face, across every side that comes into the disc.
    std::vector<Face> reached{found->face}, seen{found->face};
    std::vector<bool> known;
    known.resize(mesh->face_limit());
    known[found->face.index] = true;
    while (!reached.empty()) {
        const Face f = reached.back();
        reached.pop_back();
        for (const Corner c : mesh->corners(f)) {
            if (!mesh->edge(c).valid()) continue;
            const Face g = mesh->face(mesh->opposite(c));
            if (g.is_boundary() || known[g.index]) continue;
            if (distance_to_segment(found->point, mesh->position(mesh->vertex(c)), mesh->position(mesh->target(c))) > radius) continue;
            known[g.index] = true;
            if (!faces_eye(g)) continue;
            take(g);
            reached.push_back(g);
        }
    }
}

void PaintTool::act(const Target& target, const Pointer& pointer) { paint({*target.face}, pointer); }

void PaintTool::paint(const std::vector<Face>& faces, const Pointer& pointer)
{
    if (faces.empty()) return;
    Session::Overrides target{{"faces", FaceSelector::of(faces).text()}};
    if (pointer.ctrl) target.push_back({"id", "0"});
    session_.apply_chosen(target);
}

std::unique_ptr<Gesture> PaintTool::press(const Pointer& start, const ShowTarget&) { return std::make_unique<StrokeGesture>(*this, start); }

void PaintTool::preview(const Target& target, Overlay& overlay) const
{
    overlay.painted = target.faces;
    overlay.paint = colour({});
}

void PaintTool::add_pointer(const Pointer& pointer, Overlay& overlay) const
{
    if (settings_.brush <= 0 || !is_armed()) return;
    constexpr int sides = 48;
    const auto place = [&](int i) {
        const double angle = 2 * 3.14159265358979323846 * i / sides;
        return Point(pointer.x + settings_.brush * std::cos(angle), pointer.y + settings_.brush * std::sin(angle), 0);
    };
    for (int i = 0; i < sides; ++i) overlay.screen_lines.push_back({place(i), place(i + 1), colour(pointer), 2 * layout().scale, 1});
}

std::string PaintTool::hint() const
{
    if (!is_armed()) return "choose the group to paint with";
    const std::string text = session_.arguments().text("id");
    const std::string what = text == "new" ? "a new group" : named(static_cast<int>(parse_integer(text)), *session_.display().groups);
    return fmt::format("drag over faces to paint them with {}; Ctrl takes them out of groups; , and . change the brush", what);
}

// --- dropping a swatch --------------------------------------------------------------------------------------------------------

void DropGroupTool::act(const Target& target, const Pointer&)
{
    session_.run(fmt::format("group.assign faces={} id={}", target.face->index, group_));
}

void DropGroupTool::preview(const Target& target, Overlay& overlay) const
{
    overlay.painted = target.faces;
    overlay.paint = session_.display().groups->colour(group_);
}

std::string DropGroupTool::hint() const { return fmt::format("release on a face to put it into {}", named(group_, *session_.display().groups)); }

} // namespace druse::ui
