#include "ui/gizmo.h"

#include "ui/layout.h"

#include <algorithm>
#include <array>

namespace druse::ui {

namespace {

struct End {
    Vector axis;
    ViewAngles view; // that looks at the model from this end
    Colour colour;
    char letter; // 0 for the negative ends
};

// front looks along +y with x to the right, so the eye of +x is at azimuth 90 and that of +y at 180.
const std::array<End, 6> ends{{
    {{1, 0, 0}, {90, 0}, {0xe2, 0x5c, 0x5c}, 'x'},
    {{0, 1, 0}, {180, 0}, {0x7c, 0xb9, 0x4c}, 'y'},
    {{0, 0, 1}, {0, 90}, {0x5a, 0x96, 0xe6}, 'z'},
    {{-1, 0, 0}, {-90, 0}, {0x7a, 0x40, 0x42}, 0},
    {{0, -1, 0}, {0, 0}, {0x4a, 0x66, 0x38}, 0},
    {{0, 0, -1}, {0, -90}, {0x3c, 0x58, 0x80}, 0},
}};

struct Seen {
    const End* end;
    Point2 place;
    double depth; // greater is nearer
};

Point2 centre(const Camera& camera)
{
    const double inset = layout().gizmo_margin() + layout().gizmo_radius();
    return {camera.width() - inset, inset};
}

/// The ends from the farthest to the nearest.
std::array<Seen, 6> seen(const Camera& camera)
{
    std::array<Seen, 6> result;
    const glm::dmat3 turn = camera.rotation();
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const Vector v = turn * ends[i].axis;
        result[i] = {&ends[i], centre(camera) + double(layout().gizmo_radius()) * Point2(v.x, -v.y), v.z};
    }
    std::sort(result.begin(), result.end(), [](const Seen& a, const Seen& b) { return a.depth < b.depth; });
    return result;
}

double radius(const End& end) { return layout().px(end.letter ? 8 : 5.5); }

void draw_letter(std::vector<ThickLine>& lines, char letter, Point2 at)
{
    const double h = layout().px(3), w = 0.75 * h;
    const Colour ink{0x18, 0x19, 0x1c};
    const auto stroke = [&](double x0, double y0, double x1, double y1) {
        lines.push_back({{at.x + x0 * w, at.y + y0 * h, 0}, {at.x + x1 * w, at.y + y1 * h, 0}, ink, 1.6 * layout().scale, 1});
    };
    if (letter == 'x') stroke(-1, -1, 1, 1), stroke(1, -1, -1, 1);
    if (letter == 'y') stroke(-1, -1, 0, 0), stroke(1, -1, 0, 0), stroke(0, 0, 0, 1);
    if (letter == 'z') stroke(-1, -1, 1, -1), stroke(1, -1, -1, 1), stroke(-1, 1, 1, 1);
}

} // namespace

std::vector<ThickLine> Gizmo::lines(const Camera& camera, std::optional<Point2> pointer)
{
    std::vector<ThickLine> lines;
    const Point2 middle = centre(camera);
    for (const Seen& s : seen(camera)) {
        const Point place(s.place.x, s.place.y, 0);
        if (s.end->letter) lines.push_back({{middle.x, middle.y, 0}, place, s.end->colour, 2.0 * layout().scale, 1});
        const bool under = pointer && glm::length(*pointer - s.place) <= radius(*s.end) + 1;
        lines.push_back({place, place, s.end->colour, 2 * (radius(*s.end) + (under ? layout().px(2) : 0)), 1});
        if (s.end->letter) draw_letter(lines, s.end->letter, s.place);
    }
    return lines;
}

std::optional<ViewAngles> Gizmo::view_at(const Camera& camera, double x, double y)
{
    std::optional<ViewAngles> view;
    for (const Seen& s : seen(camera))
        if (glm::length(Point2(x, y) - s.place) <= radius(*s.end) + 2) view = s.end->view;
    return view;
}

} // namespace druse::ui
