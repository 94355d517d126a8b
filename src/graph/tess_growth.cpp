#include "graph/tess_growth.h"

#include "dlfl/errors.h"
#include "geom/angle.h"

#include <algorithm>
#include <utility>

namespace druse {

TessGrowth::TessGrowth(std::span<const int> polygons, AdjacencySymbol symbol)
    : polygons_(polygons.begin(), polygons.end()), symbol_(std::move(symbol)), k_(static_cast<std::uint32_t>(polygons.size())), length_(druse::edge_length(polygons))
{
    double angle = 0;
    for (const int p : polygons_) {
        angles_.push_back(angle);
        angle += interior_angle(p, length_);
    }
    // Turn to the slot, go along the edge, and turn so that the slot there looks back.
    const Motion forth = Motion::translation(length_);
    const auto turn = [this](std::uint32_t key) { return key < k_ ? angles_[key] : -angles_[key - k_]; };
    for (std::uint32_t here = 0; here < 2 * k_; ++here)
        for (std::uint32_t there = 0; there < 2 * k_; ++there) steps_.push_back(Motion::rotation(turn(here)) * forth * Motion::rotation(pi - turn(there)));
}

// --- seeds ----------------------------------------------------------------------------------------------------------------------

void TessGrowth::seed_face(int corner)
{
    const int p = polygons_[std::size_t(corner)];
    // On the +x axis, with the middle of the corner towards −x.
    const double middle = angles_[std::size_t(corner)] + 0.5 * interior_angle(p, length_);
    const std::uint32_t v = add_vertex(Motion::translation(circumradius(p, length_)) * Motion::rotation(pi - middle), false);
    add_face(at(v, static_cast<std::uint32_t>(corner)));
}

void TessGrowth::seed_vertex() { add_vertex(Motion(), false); }

void TessGrowth::seed_edge(int slot)
{
    const std::uint32_t v = add_vertex(Motion::translation(-0.5 * length_) * Motion::rotation(-angles_[std::size_t(slot)]), false);
    const Half h = at(v, static_cast<std::uint32_t>(slot));
    step(h);
    place_from(h);
}

// --- growth ---------------------------------------------------------------------------------------------------------------------

void TessGrowth::complete(std::uint32_t v)
{
    Half start = at(v, 0);
    for (std::uint32_t i = 0; i < k_; ++i)
        if (covered_[v] != 0 ? has_face(at(v, i)) : link_[at(v, i)] != none) {
            start = at(v, i);
            break;
        }
    Half h = start;
    do {
        if (!has_face(h)) add_face(h);
        h = counter_clockwise(h);
    } while (h != start);
}

TessGrowth::Half TessGrowth::turned(Half h, bool up) const
{
    const std::uint32_t s = slot(h);
    if (up) return s + 1 < k_ ? h + 1 : h + 1 - k_;
    return s > 0 ? h - 1 : h + k_ - 1;
}

std::uint32_t TessGrowth::add_vertex(const Motion& frame, bool mirrored)
{
    const std::uint32_t v = vertex_count();
    frames_.push_back(frame);
    mirrored_.push_back(mirrored);
    covered_.push_back(0);
    link_.resize(link_.size() + k_, none);
    return v;
}

void TessGrowth::join(Half a, Half b)
{
    ASSERT(link_[a] == none && link_[b] == none && vertex(a) != vertex(b), "two free half-edges of different vertices");
    link_[a] = b;
    link_[b] = a;
    edges_.push_back(std::min(a, b));
}

/// Makes the vertex at the other end of a free half-edge, without its place. @return its half-edge that goes on round the face on the left
TessGrowth::Half TessGrowth::step(Half h)
{
    const auto& partner = symbol_.partners[slot(h)];
    const std::uint32_t v = add_vertex(Motion(), (mirrored_[vertex(h)] != 0) != partner.mirrored);
    const Half back = at(v, static_cast<std::uint32_t>(partner.slot));
    join(h, back);
    return clockwise(back);
}

/// Places the vertex at the other end of a half-edge.
void TessGrowth::place_from(Half h)
{
    const Half back = link_[h];
    frames_[vertex(back)] = frames_[vertex(h)] * steps_[std::size_t(2) * k_ * key(h) + key(back)];
}

/// Places as many corners of a face as there are between two that have their places, each from the end that is nearer to the centre: an error that is made
/// far out would grow by as much again on the way back.
void TessGrowth::place_between(Half ahead, Half behind, int count)
{
    for (; count > 0; --count) {
        if (frames_[vertex(ahead)].reach() <= frames_[vertex(behind)].reach()) {
            place_from(ahead);
            ahead = next_in_face(ahead);
        } else {
            const Half in = counter_clockwise(behind);
            place_from(in);
            behind = link_[in];
        }
    }
}

/// The other end of a missing edge that begins in the free half-edge h, if the face on its right has all its corners in one chain already.
TessGrowth::Half TessGrowth::forced_end_ahead(Half h) const
{
    Half end = clockwise(h);
    const int p = sides(end);
    int corners = 1;
    for (; link_[end] != none; end = clockwise(link_[end])) ++corners;
    return corners == p ? end : none;
}

/// The same if the face on its left has.
TessGrowth::Half TessGrowth::forced_end_behind(Half h) const
{
    const int p = sides(h);
    int corners = 1;
    for (; link_[counter_clockwise(h)] != none; h = link_[counter_clockwise(h)]) ++corners;
    return corners == p ? counter_clockwise(h) : none;
}

/// Adds the face on the left of a half-edge.
///
/// First its corners that are joined already are followed both ways. At an open end, the face on the other side of the missing edge may be complete but
/// for it: then the edge is forced. (Without that, triangles and squares come to have vertices twice.) What is still missing is made by
/// stepping from vertex to vertex; the edge that closes the face ends in the slot that is next there, as the symbol holds up to symmetries only.
void TessGrowth::add_face(Half h)
{
    Half first = h, last = h; // of the chain: half-edges with the face on their left
    const int p = sides(h);
    int corners = 1;
    bool closed = false;
    for (bool changed = true; changed && !closed;) {
        changed = false;
        while (!closed && link_[last] != none) {
            const Half next = clockwise(link_[last]);
            closed = next == first;
            if (closed) break;
            last = next;
            ++corners;
        }
        if (closed) break;
        for (Half in = counter_clockwise(first); link_[in] != none; in = counter_clockwise(first)) {
            first = link_[in];
            ++corners;
        }
        if (const Half end = forced_end_ahead(last); end != none) {
            join(last, end);
            changed = true;
        } else if (const Half in = counter_clockwise(first), before = forced_end_behind(in); before != none) {
            join(in, before);
            changed = true;
        }
    }
    if (!closed) {
        const Half ahead = last;
        const int missing = p - corners;
        for (; corners < p; ++corners) last = step(last);
        join(last, counter_clockwise(first));
        place_between(ahead, first, missing);
    }
    ASSERT(corners == p, "a face with as many corners as it has sides");
    for (int i = 0; i < p; ++i) {
        std::uint16_t& covered = covered_[vertex(h)];
        covered = static_cast<std::uint16_t>(covered | 1u << corner(h));
        h = next_in_face(h);
    }
    faces_.push_back(first);
}

Motion::Complex TessGrowth::along(Half h, double t) const
{
    const double angle = angles_[slot(h)];
    return (frames_[vertex(h)] * Motion::rotation(mirrored_[vertex(h)] ? -angle : angle) * Motion::translation(t * length_)).origin();
}

} // namespace druse
