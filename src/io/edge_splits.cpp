#include "io/edge_splits.h"

#include "dlfl/measures.h"

#include <fmt/format.h>

namespace druse {

EdgeSplits::EdgeSplits(const Mesh& mesh)
{
    const auto split = [&](Edge e, int count) {
        if (first_.empty()) first_.resize(mesh.edge_limit(), 0);
        first_[e.index] = static_cast<std::uint32_t>(added_.size()) + 1;
        const auto [v, w] = mesh.ends(e);
        added_.insert(added_.end(), static_cast<std::size_t>(count), 0.5 * mesh.position(v) + 0.5 * mesh.position(w));
    };
    std::vector<Vertex> seen_from(mesh.vertex_limit());
    for (const Vertex v : mesh.vertices()) {
        if (mesh.is_point_sphere(v)) continue;
        for (const Corner c : mesh.around(v)) {
            const Vertex w = mesh.target(c);
            if (w.index < v.index) continue; // met from there
            const Edge e = mesh.edge(c);
            if (w == v) {
                if (mesh.corner(e, 0) != c) continue;
                split(e, 2);
                ++loops_;
            } else if (seen_from[w.index] == v) {
                split(e, 1);
                ++parallel_;
            } else if (mesh.rotate(c) == c && mesh.next(mesh.next(c)) == c) {
                split(e, 1);
                ++lone_;
            } else {
                seen_from[w.index] = v;
            }
        }
    }
    if (parallel_ > 0) thin_walls_ = facts(mesh).zero_thickness_walls;
}

void EdgeSplits::note(OutputFiles& out) const
{
    const auto note = [&](std::uint32_t count, const char* what) {
        if (count > 0) out.note(fmt::format("{} {}{} split", count, what, count == 1 ? "" : "s"));
    };
    note(parallel_, "parallel edge");
    note(loops_, "loop");
    note(lone_, "lone edge");
    note_thin_walls(thin_walls_, out);
}

void note_thin_walls(std::uint32_t count, OutputFiles& out)
{
    if (count == 0) return;
    out.note(fmt::format("{} zero-thickness wall{}, which cannot be printed: rind.peel leaves none", count, count == 1 ? "" : "s"));
}

} // namespace druse
