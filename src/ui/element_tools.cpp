#include "ui/element_tools.h"

#include <fmt/format.h>

namespace druse::ui {

namespace {

// Of a graph that is shown without a mesh nothing can be picked: ids are those of the mesh.

std::optional<Target> edge_under(const DrawLists& lists, const Camera& camera, const Pointer& p)
{
    Target target;
    if (lists.face_limit() == 0) return std::nullopt;
    target.edge = pick_edge(lists, camera, p.x, p.y);
    return target.edge ? std::optional(target) : std::nullopt;
}

std::optional<Target> vertex_under(const DrawLists& lists, const Camera& camera, const Pointer& p)
{
    Target target;
    if (lists.face_limit() == 0) return std::nullopt;
    target.vertex = pick_vertex(lists, camera, p.x, p.y);
    return target.vertex ? std::optional(target) : std::nullopt;
}

const char* mode_of(const Pointer& p) { return p.ctrl ? " mode=remove" : p.shift ? " mode=add" : ""; }

} // namespace

std::optional<Target> EdgeTool::under(const Pointer& pointer) const { return edge_under(lists(), camera_, pointer); }

void EdgeTool::act(const Target& target, const Pointer&) { session_.apply_chosen({{"edges", std::to_string(target.edge->index)}}); }

std::optional<Target> VertexTool::under(const Pointer& pointer) const { return vertex_under(lists(), camera_, pointer); }

void VertexTool::act(const Target& target, const Pointer&) { session_.apply_chosen({{"vertices", std::to_string(target.vertex->index)}}); }

std::optional<Target> SelectTool::under(const Pointer& pointer) const
{
    switch (element_) {
    case Element::edge: return edge_under(lists(), camera_, pointer);
    case Element::vertex: return vertex_under(lists(), camera_, pointer);
    default: break;
    }
    auto target = face_under(pointer);
    if (target && pointer.twice) target->faces = group_of(*target->face);
    return target;
}

void SelectTool::act(const Target& target, const Pointer& pointer)
{
    const char* mode = mode_of(pointer);
    if (target.edge) session_.run(fmt::format("select.edges edges={}{}", target.edge->index, mode));
    else if (target.vertex) session_.run(fmt::format("select.vertices vertices={}{}", target.vertex->index, mode));
    else if (pointer.twice && lists().group(*target.face) > 0)
        session_.run(fmt::format("select.faces faces=group:{}{}", lists().group(*target.face), mode));
    else session_.run(fmt::format("select.faces faces={}{}", target.face->index, mode));
}

void SelectTool::act_on_nothing()
{
    const Selection& selection = *session_.display().selection;
    if (element_ == Element::face && !selection.faces.empty()) session_.run("select.faces faces=none");
    if (element_ == Element::edge && !selection.edges.empty()) session_.run("select.edges edges=none");
    if (element_ == Element::vertex && !selection.vertices.empty()) session_.run("select.vertices vertices=none");
}

std::string SelectTool::hint() const
{
    const char* what = element_ == Element::face ? "face" : element_ == Element::edge ? "edge" : "vertex";
    return fmt::format("click selects a {}; Shift adds, Ctrl removes{}", what,
                       element_ == Element::face ? "; double click takes its group" : "");
}

} // namespace druse::ui
