#include "dlfl/rind.h"

#include "dlfl/errors.h"

#include <algorithm>

namespace druse {

namespace {

/// A sum over the vertices of a face, in the order in which `step` walks them from a corner: other vertices, or another order, give another
/// one but for one chance in 2⁶⁴.
template <class Step>
std::uint64_t ring_sum(const Mesh& mesh, Corner first, Step&& step)
{
    std::uint64_t sum = 0;
    Corner c = first;
    do {
        sum = (sum + mesh.vertex(c).index + 1) * 0x9e3779b97f4a7c15ull;
        sum ^= sum >> 32;
        c = step(c);
    } while (c != first);
    return sum;
}

std::uint64_t ring_forward(const Mesh& mesh, Corner c)
{
    return ring_sum(mesh, c, [&mesh](Corner d) { return mesh.next(d); });
}
std::uint64_t ring_backward(const Mesh& mesh, Corner c)
{
    return ring_sum(mesh, c, [&mesh](Corner d) { return mesh.previous(d); });
}

std::uint32_t place_in_face(const Mesh& mesh, Corner c)
{
    std::uint32_t k = 0;
    for (Corner d = mesh.corner(mesh.face(c)); d != c; d = mesh.next(d)) ++k;
    return k;
}

} // namespace

Rind::Rind(const Mesh& mesh, std::span<const Pair> pairs)
{
    if (pairs.empty()) return;
    Mate* const mate = mates_.extend(mesh.face_limit());
    std::fill_n(mate, mesh.face_limit(), Mate());
    const auto enter = [&](Face f, Corner c, Face other) {
        ASSERT(!mate[f.index].other.valid(), "each face in one pair at most");
        mate[f.index] = {other, mesh.vertex(c), ring_forward(mesh, c)};
    };
    for (const Pair& p : pairs) {
        ASSERT(mesh.is_alive(p.first) && mesh.is_alive(p.second) && p.first != p.second, "pairs of two faces that are there");
        enter(p.first, mesh.corner(p.first, int(p.first_corner)), p.second);
        enter(p.second, mesh.corner(p.second, int(p.second_corner)), p.first);
    }
}

Rind Rind::of_copies(const Mesh& mesh, std::uint32_t count)
{
    ASSERT(mesh.face_limit() >= 2 * count, "as many copies as faces");
    Rind rind;
    Mate* const mate = rind.mates_.extend(2 * count);
    for (std::uint32_t f = 0; f < 2 * count; ++f) {
        const Corner c = mesh.corner(Face(f));
        mate[f] = {Face(f < count ? f + count : f - count), mesh.vertex(c), ring_forward(mesh, c)};
    }
    return rind;
}

std::optional<std::array<Corner, 2>> Rind::find(const Mesh& mesh, Face f) const
{
    const Mate* const mine = mate(f);
    if (!mine) return std::nullopt;
    const Mate* const its = mate(mine->other);
    if (!its || its->other != f || !mesh.is_alive(f) || !mesh.is_alive(mine->other)) return std::nullopt;

    // Each face as it was, or each of them turned round.
    const auto corner_in = [&mesh](Face face, const Mate& m, auto&& ring) {
        for (const Corner c : mesh.corners(face))
            if (mesh.vertex(c) == m.vertex && ring(mesh, c) == m.ring) return c;
        return Corner();
    };
    for (const auto ring : {ring_forward, ring_backward}) {
        const Corner c = corner_in(f, *mine, ring), d = corner_in(mine->other, *its, ring);
        if (c.valid() && d.valid()) return f < mine->other ? std::array{c, d} : std::array{d, c};
    }
    return std::nullopt;
}

void Rind::remove(Face f)
{
    const Mate* const m = mate(f);
    if (!m) return;
    const Face other = m->other;
    mates_.set(f.index, {});
    if (mate(other)) mates_.set(other.index, {});
}

std::vector<Rind::Pair> Rind::pairs(const Mesh& mesh) const
{
    std::vector<Pair> list;
    for (std::uint32_t i = 0; i < mates_.size(); ++i) {
        const Face f(i), other = mates_[i].other;
        if (!other.valid() || other < f) continue;
        if (const auto found = find(mesh, f)) list.push_back({f, other, place_in_face(mesh, (*found)[0]), place_in_face(mesh, (*found)[1])});
    }
    return list;
}

bool operator==(const Rind& a, const Rind& b) { return std::ranges::equal(a.mates_.view(), b.mates_.view()); }

Renumbering close_holes(Mesh& mesh, Rind& rind)
{
    const bool renumbers = mesh.face_count() != mesh.face_limit() || mesh.vertex_count() != mesh.vertex_limit();
    if (rind.empty() || !renumbers) return mesh.compact();
    std::vector<Rind::Pair> pairs = rind.pairs(mesh);
    Renumbering to = mesh.compact();
    if (!to.faces.empty())
        for (Rind::Pair& p : pairs) {
            p.first = Face(to.faces[p.first.index]);
            p.second = Face(to.faces[p.second.index]);
        }
    rind = Rind(mesh, pairs);
    return to;
}

} // namespace druse
