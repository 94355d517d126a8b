// MeshBuilder::mend: a manifold from polygons that are none. Sides are paired, faces turned, vertices split, openings closed, in
// this order; each step leaves a smaller problem to the next.
#include "dlfl/errors.h"
#include "dlfl/mesh_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace druse {

namespace {

constexpr std::uint32_t none = Corner::none;

/// Sets of faces that hang together, each face with its winding (0 or 1) against the root of its set.
class WindingSets {
public:
    explicit WindingSets(std::uint32_t faces) : parent_(faces), winding_(faces, 0), size_(faces, 1)
    {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    struct Place {
        std::uint32_t root;
        bool turned;
    };
    Place find(std::uint32_t f)
    {
        std::uint32_t root = f;
        bool turned = false;
        while (parent_[root] != root) {
            turned ^= winding_[root] != 0;
            root = parent_[root];
        }
        // Hang everything on the way directly below the root.
        bool here = turned;
        while (parent_[f] != root && f != root) {
            const std::uint32_t up = parent_[f];
            const bool own = winding_[f] != 0;
            parent_[f] = root;
            winding_[f] = here;
            here ^= own;
            f = up;
        }
        return {root, turned};
    }
    /// Says that the winding of two faces differs or not; false if that contradicts what was said before.
    bool join(std::uint32_t f, std::uint32_t g, bool differ)
    {
        Place a = find(f), b = find(g);
        const bool between = a.turned ^ b.turned ^ differ;
        if (a.root == b.root) return !between;
        if (size_[a.root] < size_[b.root]) std::swap(a, b);
        parent_[b.root] = a.root;
        winding_[b.root] = between;
        size_[a.root] += size_[b.root];
        return true;
    }

private:
    std::vector<std::uint32_t> parent_;
    std::vector<std::uint8_t> winding_;
    std::vector<std::uint32_t> size_;
};

/// The polygons while they are being mended. A side is named by the corner it starts at.
struct Polygons {
    std::span<Vertex> vertex;             // of each corner
    std::vector<std::uint32_t> next, previous, face;
    std::vector<std::uint32_t> partner;   // of each side, none: open
    std::vector<std::uint32_t> face_begin; // and one past the last

    std::uint32_t corners() const { return static_cast<std::uint32_t>(vertex.size()); }
    std::uint32_t from(std::uint32_t side) const { return vertex[side].index; }
    std::uint32_t to(std::uint32_t side) const { return vertex[next[side]].index; }
    void pair(std::uint32_t s, std::uint32_t t)
    {
        partner[s] = t;
        partner[t] = s;
    }
};

/// All sides sorted so that those along one edge stand together: bucket by the end with fewer corners, then by the other end.
std::vector<std::uint32_t> sides_by_edge(const Polygons& p, std::uint32_t vertices)
{
    std::vector<std::uint32_t> count(vertices, 0), begin(vertices + 1, 0);
    for (const Vertex v : p.vertex) ++count[v.index];
    const auto near = [&](std::uint32_t s) {
        const std::uint32_t a = p.from(s), b = p.to(s);
        return count[a] < count[b] || (count[a] == count[b] && a < b) ? a : b;
    };
    for (std::uint32_t s = 0; s < p.corners(); ++s)
        if (p.next[s] != s) ++begin[near(s) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::uint32_t> sides(begin.back()), fill(begin.begin(), begin.end() - 1);
    for (std::uint32_t s = 0; s < p.corners(); ++s)
        if (p.next[s] != s) sides[fill[near(s)]++] = s;
    for (std::uint32_t v = 0; v < vertices; ++v) {
        const auto far = [&](std::uint32_t s) { return p.from(s) == v ? p.to(s) : p.from(s); };
        std::sort(sides.begin() + begin[v], sides.begin() + begin[v + 1], [&](std::uint32_t s, std::uint32_t t) {
            return std::pair(far(s), s) < std::pair(far(t), t);
        });
    }
    return sides;
}

/// Pairs three or more sides along one edge: walking around it, a side that runs down is joined to the next one that runs up,
/// so that each pair encloses a wedge of the solid. What finds no mate stays open.
void pair_fan(Polygons& p, std::span<const std::uint32_t> sides, std::span<const Point> positions, std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs)
{
    const std::uint32_t low = std::min(p.from(sides[0]), p.to(sides[0])), high = std::max(p.from(sides[0]), p.to(sides[0]));
    const Vector axis = unit(positions[high] - positions[low]);
    const Vector aside = std::abs(axis.x) < 0.7 ? Vector(1, 0, 0) : Vector(0, 1, 0);
    const Vector x = unit(glm::cross(axis, aside)), y = glm::cross(axis, x);
    struct Ray {
        double angle;
        std::uint32_t side;
        bool up;
    };
    std::vector<Ray> fan;
    for (const std::uint32_t s : sides) {
        // The face leaves the edge towards its other corners.
        Vector away(0.0);
        for (std::uint32_t c = p.next[p.next[s]]; c != s; c = p.next[c]) away += positions[p.from(c)] - positions[low];
        const bool up = p.from(s) == low;
        fan.push_back({std::atan2(glm::dot(away, y), glm::dot(away, x)), s, up});
    }
    // At one angle the side that closes a wedge comes before the one that opens the next.
    std::sort(fan.begin(), fan.end(), [](const Ray& a, const Ray& b) {
        return std::tuple(a.angle, !a.up, a.side) < std::tuple(b.angle, !b.up, b.side);
    });
    std::vector<std::uint32_t> waiting; // sides that run down, not joined yet
    for (int turn = 0; turn < 2; ++turn)
        for (Ray& ray : fan) {
            if (ray.side == none) continue;
            if (!ray.up && turn == 0) {
                waiting.push_back(ray.side);
                ray.side = none;
            } else if (ray.up && !waiting.empty()) {
                pairs.emplace_back(waiting.back(), ray.side);
                waiting.pop_back();
                ray.side = none;
            }
        }
}

void turn_face(Polygons& p, std::uint32_t f)
{
    const std::uint32_t begin = p.face_begin[f], n = p.face_begin[f + 1] - begin;
    std::reverse(p.vertex.begin() + begin + 1, p.vertex.begin() + begin + n); // the first vertex stays the first
    // Side k from corner k to k + 1 is now the side from corner n − 1 − k.
    std::reverse(p.partner.begin() + begin, p.partner.begin() + begin + n);
    for (std::uint32_t s = begin; s < begin + n; ++s)
        if (p.partner[s] != none) {
            const std::uint32_t q = p.partner[s];
            const bool own = q >= begin && q < begin + n; // both sides in this face: both names change
            if (own) p.partner[s] = begin + (n - 1 - (q - begin));
            else p.partner[q] = s;
        }
}

void wind_alike(Polygons& p, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& plain,
                const std::vector<std::pair<std::uint32_t, std::uint32_t>>& split, Repairs& repairs)
{
    const auto faces = static_cast<std::uint32_t>(p.face_begin.size() - 1);
    WindingSets sets(faces);
    for (const auto& [s, t] : plain) {
        if (!sets.join(p.face[s], p.face[t], p.from(s) == p.from(t)))
            throw CommandError(fmt::format("the surface is one-sided (like a Möbius strip): face {} can be wound neither way", p.face[t]));
        p.pair(s, t);
    }
    // A pair chosen by us where many faces meet must not make a one-sided surface of a file that has none: it stays open then.
    for (const auto& [s, t] : split)
        if (sets.join(p.face[s], p.face[t], p.from(s) == p.from(t))) p.pair(s, t);

    std::vector<std::uint32_t> size(faces, 0), turned(faces, 0);
    for (std::uint32_t f = 0; f < faces; ++f) {
        const auto [root, against] = sets.find(f);
        ++size[root];
        turned[root] += against ? 1 : 0;
    }
    std::vector<std::int8_t> first_is_turned(faces, -1); // whether the lowest face of a set runs against its root
    for (std::uint32_t f = 0; f < faces; ++f) {
        const auto [root, against] = sets.find(f);
        if (first_is_turned[root] < 0) first_is_turned[root] = against;
        const bool most_turned = 2 * turned[root] == size[root] ? first_is_turned[root] != 0 : 2 * turned[root] > size[root];
        if (against != most_turned) {
            turn_face(p, f);
            ++repairs.faces_turned;
        }
    }
}

/// Gives each fan of corners around a vertex a vertex of its own. Returns the positions of the vertices added.
std::vector<std::uint32_t> split_vertices(Polygons& p, std::uint32_t vertices, Repairs& repairs)
{
    std::vector<std::uint32_t> copy_of;
    std::vector<bool> done(p.corners(), false), met(vertices, false), counted(vertices, false);
    for (std::uint32_t c = 0; c < p.corners(); ++c) {
        if (done[c]) continue;
        const std::uint32_t v = p.from(c);
        const bool again = met[v];
        met[v] = true;
        if (again) {
            if (!counted[v]) ++repairs.vertices_split;
            counted[v] = true;
            copy_of.push_back(v);
        }
        const Vertex own(again ? vertices + static_cast<std::uint32_t>(copy_of.size()) - 1 : v);
        std::uint32_t d = c;
        do { // counter-clockwise, to the end of the fan or all around
            done[d] = true;
            p.vertex[d] = own;
            d = p.next[d] == d ? c : p.partner[p.previous[d]];
        } while (d != none && d != c);
        if (d == none)
            for (d = p.partner[c]; d != none; d = p.partner[d]) { // clockwise from the start
                d = p.next[d];
                done[d] = true;
                p.vertex[d] = own;
            }
    }
    return copy_of;
}

} // namespace

Mesh MeshBuilder::mend(Repairs& repairs)
{
    const std::uint32_t corners = corners_.size(), faces = ends_.size(), vertices = positions_.size();
    Polygons p;
    p.vertex = {corners_.write(0, corners), corners};
    p.next.resize(corners);
    p.previous.resize(corners);
    p.face.resize(corners);
    p.partner.assign(corners, none);
    p.face_begin.push_back(0);
    for (std::uint32_t f = 0; f < faces; ++f) {
        const std::uint32_t begin = p.face_begin[f], end = ends_[f];
        for (std::uint32_t c = begin; c < end; ++c) {
            p.next[c] = c + 1 < end ? c + 1 : begin;
            p.previous[c] = c > begin ? c - 1 : end - 1;
            p.face[c] = f;
            ASSERT(end == begin + 1 || p.from(c) != p.vertex[p.next[c]].index, "no side from a vertex to itself");
        }
        p.face_begin.push_back(end);
    }

    std::vector<std::pair<std::uint32_t, std::uint32_t>> plain, split;
    const auto sides = sides_by_edge(p, vertices);
    for (std::size_t i = 0; i < sides.size();) {
        const auto ends = [&](std::uint32_t s) { return std::minmax({p.from(s), p.to(s)}); };
        std::size_t j = i + 1;
        while (j < sides.size() && ends(sides[j]) == ends(sides[i])) ++j;
        if (j - i == 2) plain.emplace_back(sides[i], sides[i + 1]);
        if (j - i > 2) {
            pair_fan(p, std::span(sides).subspan(i, j - i), positions_.view(), split);
            ++repairs.edges_split;
        }
        i = j;
    }
    wind_alike(p, plain, split, repairs);
    for (const std::uint32_t v : split_vertices(p, vertices, repairs)) positions_.push_back(Point(positions_[v]));

    // The mesh: the sides of faces, then for each open side one that runs against it, in the cycle of its boundary.
    Mesh mesh;
    std::vector<std::uint32_t> open, open_into(positions_.size(), none);
    for (std::uint32_t s = 0; s < corners; ++s)
        if (p.partner[s] == none && p.next[s] != s) {
            open_into[p.to(s)] = static_cast<std::uint32_t>(open.size());
            open.push_back(s);
        }
    const auto all = corners + static_cast<std::uint32_t>(open.size());
    Corner* const next = mesh.corner_next_.extend(all);
    Corner* const previous = mesh.corner_previous_.extend(all);
    Face* const face = mesh.corner_face_.extend(all);
    Edge* const edge = mesh.corner_edge_.extend(all);
    std::fill_n(edge, all, Edge());
    mesh.vertex_corner_.extend(positions_.size());
    for (std::uint32_t c = corners; c-- > 0;) {
        next[c] = Corner(p.next[c]);
        previous[c] = Corner(p.previous[c]);
        face[c] = Face(p.face[c]);
        mesh.vertex_corner_.set(p.vertex[c].index, Corner(c));
    }
    for (std::uint32_t f = 0; f < faces; ++f) mesh.face_corner_.push_back(Corner(p.face_begin[f]));
    for (std::uint32_t k = 0; k < open.size(); ++k) p.partner[open[k]] = corners + k;
    for (std::uint32_t s = 0; s < corners; ++s)
        if (p.next[s] != s && !edge[s].valid()) {
            const std::uint32_t t = p.partner[s];
            edge[s] = edge[t] = Edge(mesh.edge_corners_.size());
            mesh.edge_corners_.push_back({Corner(s), Corner(t)});
        }
    for (std::uint32_t k = 0; k < open.size(); ++k) {
        // The side against open[k] starts where that one ends, and goes on with the open side that ends where it starts.
        corners_.push_back(Vertex(p.to(open[k])));
        p.vertex = {corners_.write(0, corners), corners};
        const std::uint32_t after = open_into[p.from(open[k])];
        ASSERT(after != none, "an open side after each open side");
        next[corners + k] = Corner(corners + after);
        previous[corners + after] = Corner(corners + k);
        face[corners + k] = Face();
    }
    for (std::uint32_t k = 0; k < open.size(); ++k) {
        if (face[corners + k].valid()) continue;
        const Face made = Face::boundary(mesh.boundary_count());
        mesh.boundary_corner_.push_back(Corner(corners + k));
        for (Corner c(corners + k); !face[c.index].valid(); c = next[c.index]) face[c.index] = made;
    }
    repairs.boundary_edges = static_cast<std::uint32_t>(open.size());
    repairs.boundary_loops = mesh.boundary_count();
    hand_over(mesh);
    return mesh;
}

} // namespace druse
