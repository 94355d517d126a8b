#include "graph/strut_table.h"

#include <algorithm>

namespace druse {

namespace {

void add_part(std::uint32_t before, const std::vector<std::uint32_t>& ends, std::uint32_t i, std::vector<Face>& faces)
{
    for (std::uint32_t f = i > 0 ? ends[i - 1] : 0; f < ends[i]; ++f) faces.push_back(Face(before + f));
}

} // namespace

void StrutTable::add_strut(std::uint32_t edge, std::vector<Face>& faces) const
{
    for (std::uint32_t k = 0; k < per_strut; ++k) faces.push_back(Face(first_face + ball_ends.back() + edge * per_strut + k));
}

void StrutTable::add_ball(std::uint32_t vertex, std::vector<Face>& faces) const { add_part(first_face, ball_ends, vertex, faces); }

void StrutTable::add_cap(std::uint32_t vertex, std::vector<Face>& faces) const
{
    add_part(first_face + ball_ends.back() + per_strut * static_cast<std::uint32_t>(edge_ids.size()), cap_ends, vertex, faces);
}

std::uint32_t StrutTable::face_count() const
{
    if (edge_ids.empty()) return 0;
    return ball_ends.back() + per_strut * static_cast<std::uint32_t>(edge_ids.size()) + cap_ends.back();
}

std::uint64_t StrutTable::fingerprint(const Mesh& mesh) const
{
    std::uint64_t mixed = 0;
    const auto mix = [&mixed](std::uint32_t x) { mixed = (mixed ^ x) * 0x9e3779b97f4a7c15u, mixed ^= mixed >> 32; };
    for (std::uint32_t f = first_face; f < first_face + face_count(); ++f) {
        for (const Corner c : mesh.corners(Face(f))) mix(mesh.vertex(c).index);
        mix(Vertex::none);
    }
    return mixed;
}

bool StrutTable::holds(const Mesh& now) const
{
    const std::uint32_t end = first_face + face_count();
    if (end == first_face || end > now.face_limit()) return false;
    for (std::uint32_t f = first_face; f < end; ++f)
        if (!now.is_alive(Face(f))) return false;
    return fingerprint(now) == corners;
}

std::vector<Face> StrutTable::strut(const Mesh& now, std::uint32_t edge) const
{
    std::vector<Face> faces;
    if (!holds(now)) return faces;
    for (std::uint32_t e = 0; e < edge_ids.size(); ++e)
        if (edge_ids[e] == edge) add_strut(e, faces); // an edge that was split has several
    return faces;
}

std::vector<Face> StrutTable::ball(const Mesh& now, std::uint32_t vertex) const
{
    std::vector<Face> faces;
    const auto at = std::find(vertex_ids.begin(), vertex_ids.end(), vertex);
    if (at == vertex_ids.end() || !holds(now)) return faces;
    const auto v = static_cast<std::uint32_t>(at - vertex_ids.begin());
    add_ball(v, faces);
    add_cap(v, faces);
    return faces;
}

} // namespace druse
