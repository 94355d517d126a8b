// Removal of a vertex from a Triangulation: the hole it leaves is a polygon seen whole from it, and is closed ear by ear.
#include "dlfl/errors.h"
#include "pane/triangulation.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace druse {

using Index = Triangulation::Index;

namespace {

/// How far the circle through the ear's corners reaches round the removed vertex, all places as seen from that: less is earlier. The ear with
/// the least is a Delaunay triangle of the hole (Devillers 2002); rounding may mistake it, and then flips put that right.
double depth(const Point2& a, const Point2& b, const Point2& c)
{
    const double bc = b.x * c.y - b.y * c.x, ca = c.x * a.y - c.y * a.x, ab = a.x * b.y - a.y * b.x;
    return (glm::dot(a, a) * bc + glm::dot(b, b) * ca + glm::dot(c, c) * ab) / (bc + ca + ab);
}

constexpr double latest = 1e300;

struct RimCorner {
    Index vertex;
    Index glued; // what lies beyond the side from this corner to the next
    std::uint32_t bits;
    std::uint32_t before, after;
    double depth; // of the ear at this corner; infinite where it may not be cut
};

} // namespace

void Triangulation::remove(Index v)
{
    const Point2 centre = position(v);
    thread_local std::vector<RimCorner> rim;
    rim.clear();
    spare_faces_.clear();
    const Index first = out(v);
    Index h = first;
    do {
        ASSERT(!is_fixed(h), "a vertex is removed when nothing is tied to it");
        const Index link = next(h);
        rim.push_back({origin(link), twin(link), bits(link), 0, 0, 0});
        spare_faces_.push_back(face(h));
        h = turn(h);
    } while (h != first);

    const auto size = static_cast<std::uint32_t>(rim.size());
    for (std::uint32_t i = 0; i < size; ++i) {
        rim[i].before = i == 0 ? size - 1 : i - 1;
        rim[i].after = i + 1 == size ? 0 : i + 1;
    }
    const auto measure = [&](std::uint32_t i) {
        RimCorner& corner = rim[i];
        const Point2 &a = position(rim[corner.before].vertex), &b = position(corner.vertex), &c = position(rim[corner.after].vertex);
        const bool ear = orient(a, b, c) > 0 && orient(a, c, centre) >= 0;
        const double inside = depth(a - centre, b - centre, c - centre); // overflows where coordinates are huge
        corner.depth = !ear ? std::numeric_limits<double>::infinity() : inside < latest ? inside : latest;
    };
    const std::uint32_t inside = flags(first) & inside_bit;
    // All faces change; those that lie outside the pane are flagged again by whoever changes its loops.
    for (const Index t : spare_faces_) touch(t);
    std::size_t spare = 0;
    const auto place_face = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) { // the third side is left to be glued
        const Index t = spare_faces_[spare++];
        side(t | 3) = {inside, none};
        const std::array<std::uint32_t, 3> corners{i, j, k};
        for (Index n = 0; n < 3; ++n) {
            side(t + n).origin = rim[corners[n]].vertex;
            set_out(rim[corners[n]].vertex, t + n);
        }
        glue(t, rim[i].glued, rim[i].bits);
        glue(t + 1, rim[j].glued, rim[j].bits);
        return t;
    };
    std::uint32_t start = 0;
    const auto cut = [&](std::uint32_t i) {
        const std::uint32_t before = rim[i].before, after = rim[i].after;
        const Index t = place_face(before, i, after);
        // The new side runs from `after` to `before`; what lies beyond the rim there is this face.
        rim[before].glued = t + 2;
        rim[before].bits = 0;
        rim[before].after = after;
        rim[after].before = before;
        queue_.push_back(t + 2);
        start = after;
    };

    if (size > 3)
        for (std::uint32_t i = 0; i < size; ++i) measure(i);
    constexpr std::uint32_t few = 32;
    std::uint32_t left = size;
    const auto drop = [&](std::uint32_t i) {
        ASSERT(rim[i].depth < std::numeric_limits<double>::infinity(), "a polygon seen whole from one place has an ear");
        const std::uint32_t before = rim[i].before, after = rim[i].after;
        cut(i);
        --left;
        if (left > 3) {
            measure(before);
            measure(after);
        }
    };
    if (size > few) {
        using Entry = std::pair<double, std::uint32_t>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
        for (std::uint32_t i = 0; i < size; ++i) heap.emplace(rim[i].depth, i);
        while (left > 3) {
            const auto [key, i] = heap.top();
            heap.pop();
            if (rim[rim[i].before].after != i || rim[i].depth != key) continue; // cut, or measured again
            const std::uint32_t before = rim[i].before, after = rim[i].after;
            drop(i);
            heap.emplace(rim[before].depth, before);
            heap.emplace(rim[after].depth, after);
        }
    } else {
        while (left > 3) {
            std::uint32_t best = start;
            for (std::uint32_t i = rim[start].after; i != start; i = rim[i].after)
                if (rim[i].depth < rim[best].depth) best = i;
            drop(best);
        }
    }
    const std::uint32_t i = start, j = rim[i].after, k = rim[j].after;
    const Index t = place_face(i, j, k);
    glue(t + 2, rim[k].glued, rim[k].bits);
    free_face(spare_faces_[spare]);
    free_face(spare_faces_[spare + 1]);
    free_vertex(v);
    legalise();
    remember(centre, t);
}

} // namespace druse
