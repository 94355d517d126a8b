#include "dlfl/patch.h"

#include "dlfl/errors.h"

#include <algorithm>
#include <tuple>

namespace druse {

void Patch::add(std::span<const int> polygon)
{
    polygons_.insert(polygons_.end(), polygon.begin(), polygon.end());
    polygon_ends_.push_back(static_cast<int>(polygons_.size()));
}

void Patch::connect()
{
    const auto ring = static_cast<std::uint32_t>(ring_);
    const std::size_t sides = polygons_.size();

    // A side of a polygon that runs along the ring is the old corner there; every other one is a new corner.
    std::vector<std::uint32_t> reference(sides), polygon_of(sides), next_side(sides);
    std::vector<bool> ring_used(ring, false);
    std::uint32_t corners = 0;
    std::size_t begin = 0;
    for (std::size_t p = 0; p < polygon_ends_.size(); ++p) {
        const auto end = static_cast<std::size_t>(polygon_ends_[p]);
        ASSERT(end >= begin + 2, "polygons with two corners or more");
        for (std::size_t s = begin; s < end; ++s) {
            polygon_of[s] = static_cast<std::uint32_t>(p);
            next_side[s] = static_cast<std::uint32_t>(s + 1 < end ? s + 1 : begin);
            const int from = polygons_[s], to = polygons_[next_side[s]];
            ASSERT(from >= 0 && from < ring_ + inner_ && from != to, "local vertex numbers, no side twice the same");
            if (from < ring_ && to == (from + 1) % ring_) {
                ASSERT(!ring_used[static_cast<std::size_t>(from)], "each side of the ring in one polygon");
                ring_used[static_cast<std::size_t>(from)] = true;
                reference[s] = static_cast<std::uint32_t>(from);
            } else {
                reference[s] = ring + corners++;
            }
        }
        begin = end;
    }
    ASSERT(std::ranges::find(ring_used, false) == ring_used.end(), "each side of the ring in a polygon");

    // Sides that run against each other make an edge, numbered by the first of the two.
    std::vector<std::tuple<int, int, std::uint32_t>> by_ends; // lower end, higher end, side
    for (std::uint32_t s = 0; s < sides; ++s)
        if (reference[s] >= ring) {
            const int from = polygons_[s], to = polygons_[next_side[s]];
            by_ends.emplace_back(std::min(from, to), std::max(from, to), s);
        }
    std::sort(by_ends.begin(), by_ends.end());
    ASSERT(by_ends.size() % 2 == 0, "inner sides in pairs");
    std::vector<std::uint32_t> partner(sides);
    for (std::size_t i = 0; i < by_ends.size(); i += 2) {
        const auto [lo, hi, s] = by_ends[i];
        const auto [lo2, hi2, s2] = by_ends[i + 1];
        ASSERT(lo == lo2 && hi == hi2 && polygons_[s] != polygons_[s2], "inner sides in pairs that run against each other");
        ASSERT(i == 0 || lo != std::get<0>(by_ends[i - 1]) || hi != std::get<1>(by_ends[i - 1]), "inner edges between different vertices");
        partner[s] = s2;
        partner[s2] = s;
    }
    check_disc(reference, next_side, partner);

    vertex_.assign(corners, 0);
    next_.assign(corners, 0);
    previous_.assign(corners, 0);
    face_.assign(corners, 0);
    edge_.assign(corners, 0);
    ring_next_.assign(ring, 0);
    ring_previous_.assign(ring, 0);
    ring_face_.assign(ring, 0);
    vertex_corner_.assign(static_cast<std::size_t>(inner_), Corner::none);
    std::vector<std::uint32_t> edge_of_side(sides, Edge::none);
    begin = 0;
    for (std::size_t p = 0; p < polygon_ends_.size(); ++p) {
        starts_.push_back(reference[begin]);
        begin = static_cast<std::size_t>(polygon_ends_[p]);
    }
    for (std::uint32_t s = 0; s < sides; ++s) {
        const std::uint32_t here = reference[s], there = reference[next_side[s]];
        if (here < ring) {
            ring_next_[here] = there;
            ring_face_[here] = polygon_of[s];
        } else {
            const std::uint32_t k = here - ring;
            const auto local = static_cast<std::uint32_t>(polygons_[s]);
            if (local < ring) vertex_fixups_.push_back({k, local});
            else vertex_[k] = local - ring;
            if (local >= ring && vertex_corner_[local - ring] == Corner::none) vertex_corner_[local - ring] = k;
            if (there < ring) next_fixups_.push_back({k, there});
            else next_[k] = there - ring;
            if (polygon_of[s] == 0) first_polygon_corners_.push_back(k);
            else face_[k] = polygon_of[s] - 1;
            if (edge_of_side[s] == Edge::none) {
                edge_of_side[s] = edge_of_side[partner[s]] = static_cast<std::uint32_t>(edges_.size());
                edges_.emplace_back(k, reference[partner[s]] - ring);
            }
            edge_[k] = edge_of_side[s];
        }
        if (there < ring) {
            ring_previous_[there] = here;
        } else {
            if (here < ring) previous_fixups_.push_back({there - ring, here});
            else previous_[there - ring] = here - ring;
        }
    }
    // V − E + F of a disc: the ring closes it, so ring + inner vertices, ring + new edges, and the polygons.
    ASSERT(inner_ - new_edges() + polygon_count() == 1, "polygons that make a disc");
}

void Patch::check_disc(std::span<const std::uint32_t> reference, std::span<const std::uint32_t> next_side,
                       std::span<const std::uint32_t> partner) const
{
    const auto ring = static_cast<std::uint32_t>(ring_);
    const auto sides = static_cast<std::uint32_t>(reference.size());
    std::vector<std::uint32_t> previous_side(sides), first_at(static_cast<std::size_t>(inner_), sides);
    for (std::uint32_t s = 0; s < sides; ++s) {
        previous_side[next_side[s]] = s;
        if (polygons_[s] >= ring_) first_at[static_cast<std::size_t>(polygons_[s] - ring_)] = s;
    }
    // One fan of sides at each corner of the ring, from its own side to the one before, and one rotation about each new vertex.
    std::uint32_t met = 0;
    for (std::uint32_t s = 0; s < sides; ++s)
        if (reference[s] < ring)
            for (std::uint32_t t = s;;) {
                ++met;
                const std::uint32_t into = previous_side[t];
                if (reference[into] < ring) break;
                t = partner[into];
            }
    for (const std::uint32_t first : first_at) {
        ASSERT(first < sides, "every new vertex in a polygon");
        std::uint32_t t = first;
        do {
            ++met;
            t = partner[previous_side[t]];
        } while (t != first);
    }
    ASSERT(met == sides, "one rotation about each vertex");

    std::vector<std::uint32_t> reached{0};
    std::vector<bool> seen(sides, false);
    seen[0] = true;
    for (std::size_t i = 0; i < reached.size(); ++i)
        for (const std::uint32_t t : {next_side[reached[i]], reference[reached[i]] < ring ? next_side[reached[i]] : partner[reached[i]]})
            if (!seen[t]) {
                seen[t] = true;
                reached.push_back(t);
            }
    ASSERT(reached.size() == sides, "polygons that hang together");
}

} // namespace druse
