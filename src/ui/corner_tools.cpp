#include "ui/corner_tools.h"

#include <fmt/format.h>

#include <algorithm>

namespace druse::ui {

namespace {

/// `FACE:K` for the corner of a face at a vertex. Empty if there is none.
std::string corner_text(const Mesh& mesh, Face f, Vertex v)
{
    const std::optional<int> k = CornerTool::place(mesh, f, v);
    return k ? fmt::format("{}:{}", f.index, *k) : std::string();
}

} // namespace

std::optional<Target> CornerTool::under(const Pointer& pointer) const
{
    auto target = face_under(pointer);
    if (!target) return {};
    double nearest = 1e300;
    for (const auto& side : lists().sides(*target->face))
        for (const std::uint32_t v : side) {
            const auto place = camera_.project(lists().position(v));
            if (!place) continue;
            const double dx = place->x - pointer.x, dy = place->y - pointer.y;
            if (dx * dx + dy * dy < nearest) {
                nearest = dx * dx + dy * dy;
                target->vertex = Vertex(v);
            }
        }
    return target->vertex ? target : std::nullopt;
}

std::optional<int> CornerTool::place(const Mesh& mesh, Face f, Vertex v)
{
    int k = 0;
    for (const Corner c : mesh.corners(f)) {
        if (mesh.vertex(c) == v) return k;
        ++k;
    }
    return {};
}

void StartCornerTool::act(const Target& target, const Pointer&)
{
    const std::vector<Face>& selected = session_.display().selection->faces;
    const bool of_selection = std::find(selected.begin(), selected.end(), *target.face) != selected.end();
    session_.run(fmt::format("{} faces={} vertex={}", session_.chosen()->name,
                             of_selection ? std::string("selected") : std::to_string(target.face->index), target.vertex->index));
}

void CornerPairTool::act(const Target& target, const Pointer&)
{
    const Mesh* mesh = session_.mesh();
    if (!mesh) return;
    const std::string corner = corner_text(*mesh, *target.face, *target.vertex);
    if (corner.empty()) return;
    // A corner is named by its face; after any change the first one may be another.
    if (first_.empty() || version_ != session_.display().lists.id() + session_.display().lists.version()) {
        first_ = corner;
        version_ = session_.display().lists.id() + session_.display().lists.version();
        return;
    }
    session_.apply_chosen({{"c1", first_}, {"c2", corner}});
    first_.clear();
}

} // namespace druse::ui
