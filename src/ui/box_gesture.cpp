#include "ui/box_gesture.h"

#include "ui/layout.h"

#include <algorithm>
#include <utility>

namespace druse::ui {

namespace {

template <class H>
void select(Session& session, const char* what, const std::vector<H>& handles, const Pointer& p)
{
    const std::string key = what;
    std::string command = "select." + key + " " + key + "=" + (handles.empty() ? "none" : Selector<H>::of(handles).text());
    if (p.ctrl) command += " mode=remove";
    else if (p.shift) command += " mode=add";
    session.run(command);
}

} // namespace

void BoxGesture::add_to(Overlay& overlay) const
{
    const Point a(start_.x, start_.y, 0), c(end_.x, end_.y, 0);
    const Point b(c.x, a.y, 0), d(a.x, c.y, 0);
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, d), std::pair(d, a)})
        overlay.screen_lines.push_back({from, to, overlay.highlight, 1.5 * layout().scale, 1});
}

void BoxGesture::release(const Pointer& pointer)
{
    end_ = pointer;
    const DrawLists& lists = session_.display().lists;
    const auto [left, right] = std::minmax(start_.x, end_.x);
    const auto [top, bottom] = std::minmax(start_.y, end_.y);
    if (tool_.take_box({left, top}, {right, bottom}, pointer)) return;
    std::vector<bool> inside(lists.vertex_limit());
    for (std::uint32_t v = 0; v < lists.vertex_limit(); ++v) {
        const auto place = camera_.project(lists.position(v));
        inside[v] = place && place->x >= left && place->x <= right && place->y >= top && place->y <= bottom;
    }

    if (element_ == Element::vertex) {
        std::vector<Vertex> vertices;
        for (std::uint32_t v = 0; v < lists.vertex_limit(); ++v)
            if (inside[v]) vertices.push_back(Vertex(v));
        select(session_, "vertices", vertices, pointer);
    } else if (element_ == Element::edge) {
        std::vector<Edge> edges;
        for (std::uint32_t e = 0; e < lists.edge_limit(); ++e) {
            const auto& [a, b] = lists.edges()[e];
            if (a != DrawLists::none && inside[a] && inside[b]) edges.push_back(Edge(e));
        }
        select(session_, "edges", edges, pointer);
    } else {
        std::vector<Face> faces;
        for (std::uint32_t f = 0; f < lists.face_limit(); ++f) {
            const DrawLists::Range range = lists.triangles(Face(f));
            bool all = range.count > 0;
            for (std::uint32_t t = range.first; all && t < range.first + range.count; ++t)
                for (const std::uint32_t corner : lists.triangles()[t]) all = all && inside[lists.vertex_of(corner)];
            if (all) faces.push_back(Face(f));
        }
        select(session_, "faces", faces, pointer);
    }
}

} // namespace druse::ui
