// MeshBuilder::mend: a manifold from polygons that are none. Sides are paired where an edge has two; faces wound against each other
// are turned; edges with more sides are pulled apart; then vertices are split and openings closed. Each step leaves a smaller
// problem to the next, and none searches: the whole is linear, but for sorting the few sides of a crowded edge.
#include "dlfl/errors.h"
#include "dlfl/mesh_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

namespace druse {

namespace {

/// Sets of faces that hang together, each face with its winding against the root of its set (union-find with parity).
class WindingSets {
public:
    explicit WindingSets(std::uint32_t faces) : parent_(faces), turned_(faces, 0), size_(faces, 1)
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
            turned ^= turned_[root] != 0;
            root = parent_[root];
        }
        // Hang everything on the way directly below the root.
        bool here = turned;
        while (parent_[f] != root && f != root) {
            const std::uint32_t up = parent_[f];
            const bool own = turned_[f] != 0;
            parent_[f] = root;
            turned_[f] = here;
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
        turned_[b.root] = between;
        size_[a.root] += size_[b.root];
        return true;
    }

private:
    std::vector<std::uint32_t> parent_;
    std::vector<std::uint8_t> turned_;
    std::vector<std::uint32_t> size_;
};

/// The polygons while they are being mended, in the columns of the mesh to be. A side is named by the corner it starts at.
struct Polygons {
    std::uint32_t vertices, faces, corners;
    Vertex* vertex;
    const Corner *next, *previous;
    const Face* face;
    const std::uint32_t* ends; // of the faces: one past the last corner
    Corner* partner;           // of each side; none: open

    std::uint32_t begin(std::uint32_t f) const { return f > 0 ? ends[f - 1] : 0; }
    Vertex from(Corner side) const { return vertex[side.index]; }
    Vertex to(Corner side) const { return vertex[next[side.index].index]; }
    bool alone(Corner c) const { return next[c.index] == c; } // a point sphere: no side
    void pair(Corner s, Corner t) const
    {
        partner[s.index] = t;
        partner[t.index] = s;
    }
};

/// The sides along edges with three sides or more, edge after edge.
struct CrowdedEdges {
    std::vector<Corner> sides;
    std::vector<std::size_t> ends;
};

/// Pairs the two sides of every edge that has two, whichever way they run; says whether two of them run the same way.
bool pair_sides(const Polygons& p, CrowdedEdges& crowded)
{
    // A side hangs in a list at the lower-numbered of its vertices. In the list of one vertex, the sides with the same other
    // end are chained, in the memory of their partners; `met` knows the last of each chain and the list it was made in.
    struct Met {
        std::uint32_t low;
        Corner last;
    };
    Column<Corner> lists, followers;
    Column<Met> ends_met;
    Corner* const list = lists.extend(p.vertices);
    Corner* const following = followers.extend(p.corners);
    Met* const met = ends_met.extend(p.vertices);
    Corner* const earlier = p.partner;
    std::fill_n(list, p.vertices, Corner());
    std::fill_n(met, p.vertices, Met{Vertex::none, Corner()});
    for (std::uint32_t i = p.corners; i-- > 0;) {
        const Corner s(i);
        earlier[i] = Corner();
        if (p.alone(s)) continue;
        Corner& first = list[std::min(p.from(s), p.to(s)).index];
        following[i] = first;
        first = s;
    }
    bool same_way = false;
    std::vector<Corner> chain;
    for (std::uint32_t low = 0; low < p.vertices; ++low) {
        const auto far = [&](Corner s) -> Met& { return met[std::max(p.from(s), p.to(s)).index]; };
        for (Corner s = list[low]; s.valid(); s = following[s.index]) {
            Met& m = far(s);
            if (m.low == low) earlier[s.index] = m.last;
            m = {low, s};
        }
        for (Corner s = list[low]; s.valid(); s = following[s.index]) {
            if (far(s).last != s) continue;
            chain.clear();
            for (Corner t = s; t.valid(); t = std::exchange(earlier[t.index], Corner())) chain.push_back(t);
            if (chain.size() == 2) {
                p.pair(chain[0], chain[1]);
                same_way = same_way || p.from(chain[0]) == p.from(chain[1]);
            } else if (chain.size() > 2) {
                crowded.sides.insert(crowded.sides.end(), chain.rbegin(), chain.rend());
                crowded.ends.push_back(crowded.sides.size());
            }
        }
    }
    return same_way;
}

void turn_face(const Polygons& p, std::uint32_t f)
{
    const std::uint32_t begin = p.begin(f), end = p.ends[f];
    std::reverse(p.vertex + begin + 1, p.vertex + end); // the first vertex stays the first
    // The side that started at corner k from the beginning now starts at corner k from the end, and its partner must know.
    std::reverse(p.partner + begin, p.partner + end);
    for (std::uint32_t s = begin; s < end; ++s) {
        Corner& q = p.partner[s];
        if (!q.valid()) continue;
        if (q.index >= begin && q.index < end) q = Corner(begin + (end - 1 - q.index)); // both sides lie in this face
        else p.partner[q.index] = Corner(s);
    }
}

/// Turns the fewer faces of each set that hangs together, of two equal parts the one without the lowest face.
void wind_alike(const Polygons& p, CrowdedEdges& crowded, Repairs& repairs)
{
    WindingSets sets(p.faces);
    for (std::uint32_t i = 0; i < p.corners; ++i) {
        const Corner s(i), t = p.partner[i];
        if (!t.valid() || t < s) continue;
        const Face f = p.face[s.index], g = p.face[t.index];
        if (!sets.join(f.index, g.index, p.from(s) == p.from(t)))
            throw CommandError(fmt::format("the surface is one-sided (like a Möbius strip): face {} can be wound neither way", g.index));
    }
    std::vector<std::uint32_t> size(p.faces, 0), against(p.faces, 0);
    std::vector<std::int8_t> lowest_against(p.faces, -1); // whether the lowest face of a set runs against its root
    for (std::uint32_t f = 0; f < p.faces; ++f) {
        const auto [root, turned] = sets.find(f);
        ++size[root];
        against[root] += turned ? 1 : 0;
        if (lowest_against[root] < 0) lowest_against[root] = turned ? 1 : 0;
    }
    std::vector<bool> turned(p.faces, false);
    for (std::uint32_t f = 0; f < p.faces; ++f) {
        const auto place = sets.find(f);
        const std::uint32_t root = place.root;
        const bool most = 2 * std::uint64_t(against[root]) == size[root] ? lowest_against[root] == 1 : 2 * std::uint64_t(against[root]) > size[root];
        if (place.turned == most) continue;
        turn_face(p, f);
        turned[f] = true;
        ++repairs.faces_turned;
    }
    for (Corner& s : crowded.sides)
        if (const std::uint32_t f = p.face[s.index].index; turned[f]) s = Corner(p.begin(f) + (p.ends[f] - 1 - s.index));
}

/// Normals of faces, each measured once, however many crowded edges its face has.
class FaceNormals {
public:
    FaceNormals(const Polygons& p, std::span<const Point> position)
        : p_(p), position_(position), normals_(p.faces, Vector(0.0)), known_(p.faces, false)
    {
    }

    /// Newell's, so that concave faces count too; of any length.
    const Vector& operator()(Face f)
    {
        Vector& normal = normals_[f.index];
        if (known_[f.index]) return normal;
        known_[f.index] = true;
        const Point& origin = position_[p_.from(Corner(p_.begin(f.index))).index];
        Vector here(0.0);
        for (std::size_t c = p_.begin(f.index) + 1; c < p_.ends[f.index]; ++c) {
            const Vector there = position_[p_.from(Corner(static_cast<std::uint32_t>(c))).index] - origin;
            normal += glm::cross(here, there);
            here = there;
        }
        return normal;
    }

private:
    const Polygons& p_;
    std::span<const Point> position_;
    std::vector<Vector> normals_;
    std::vector<bool> known_;
};

/// Pairs the sides along a crowded edge: going around it, a side that runs down is joined to the next one that runs up, so that
/// each pair encloses a wedge of the solid. What finds no mate stays open.
void pair_fan(const Polygons& p, std::span<const Corner> sides, std::span<const Point> position, FaceNormals& normal)
{
    const Vertex low = std::min(p.from(sides[0]), p.to(sides[0])), high = std::max(p.from(sides[0]), p.to(sides[0]));
    const Point& origin = position[low.index];
    const Vector axis = unit(position[high.index] - origin);
    const Vector aside = std::abs(axis.x) < 0.7 ? Vector(1, 0, 0) : Vector(0, 1, 0);
    const Vector x = unit(glm::cross(axis, aside)), y = glm::cross(axis, x);
    struct Ray {
        double angle;
        Corner side;
        bool up;
    };
    std::vector<Ray> fan;
    for (const Corner s : sides) {
        const bool up = p.from(s) == low;
        const Vector away = unit(glm::cross(normal(p.face[s.index]), up ? axis : -axis)); // the face leaves the edge square to it
        fan.push_back({std::atan2(glm::dot(away, y), glm::dot(away, x)), s, up});
    }
    // Faces upon each other count as being at the same angle, however they are rounded.
    constexpr double same = 1e-7;
    std::sort(fan.begin(), fan.end(), [](const Ray& a, const Ray& b) { return std::pair(a.angle, a.side) < std::pair(b.angle, b.side); });
    while (fan.back().angle - fan.front().angle > 2 * std::numbers::pi - same) { // on either side of the cut at ±π
        fan.back().angle = fan.front().angle;
        std::rotate(fan.begin(), fan.end() - 1, fan.end());
    }
    for (std::size_t i = 1; i < fan.size(); ++i)
        if (fan[i].angle - fan[i - 1].angle < same) fan[i].angle = fan[i - 1].angle;
    // There the side that closes a wedge comes before the one that opens the next; of faces given twice the first is joined to
    // others, at all of its edges.
    std::sort(fan.begin(), fan.end(), [](const Ray& a, const Ray& b) {
        if (a.angle != b.angle) return a.angle < b.angle;
        if (a.up != b.up) return a.up;
        return a.up ? a.side < b.side : b.side < a.side;
    });
    std::vector<Corner> waiting; // sides that run down, not joined yet
    for (int round = 0; round < 2; ++round)
        for (Ray& ray : fan) {
            if (!ray.side.valid()) continue;
            if (!ray.up && round == 0) {
                waiting.push_back(ray.side);
                ray.side = Corner();
            } else if (ray.up && !waiting.empty()) {
                p.pair(waiting.back(), ray.side);
                waiting.pop_back();
                ray.side = Corner();
            }
        }
}

/// Gives each fan of corners around a vertex a vertex of its own. Returns the vertices that were copied, once for each copy.
std::vector<Vertex> split_vertices(const Polygons& p, const CrowdedEdges& crowded, Repairs& repairs)
{
    // Vertices at the ends of crowded edges come apart with them, and are not counted.
    std::vector<bool> done(p.corners, false), met(p.vertices, false), counted(p.vertices, false);
    for (const Corner s : crowded.sides) counted[p.from(s).index] = counted[p.to(s).index] = true;
    std::vector<Vertex> copied;
    for (std::uint32_t i = 0; i < p.corners; ++i) {
        if (done[i]) continue;
        const Corner first(i);
        const Vertex v = p.from(first);
        Vertex own = v;
        if (met[v.index]) {
            own = Vertex(p.vertices + static_cast<std::uint32_t>(copied.size()));
            copied.push_back(v);
            if (!counted[v.index]) ++repairs.vertices_split;
            counted[v.index] = true;
        }
        met[v.index] = true;
        const auto take = [&](Corner c) {
            done[c.index] = true;
            p.vertex[c.index] = own;
        };
        take(first);
        if (p.alone(first)) continue;
        Corner c = p.partner[p.previous[i].index]; // counter-clockwise, all around or to the end of the fan
        for (; c.valid() && c != first; c = p.partner[p.previous[c.index].index]) take(c);
        if (c == first) continue;
        for (c = p.partner[i]; c.valid(); c = p.partner[c.index]) { // clockwise from the start
            c = p.next[c.index];
            take(c);
        }
    }
    return copied;
}

} // namespace

Mesh MeshBuilder::mend(Repairs& repairs)
{
    const std::uint32_t corners = corners_.size(), faces = ends_.size();
    Mesh mesh;
    Column<Corner> partners;
    Polygons p{positions_.size(), faces, corners, corners_.write(0, corners), nullptr, nullptr, nullptr, ends_.view().data(), partners.extend(corners)};
    {
        Corner* const next = mesh.corner_next_.extend(corners);
        Corner* const previous = mesh.corner_previous_.extend(corners);
        Face* const face = mesh.corner_face_.extend(corners);
        Corner* const start = mesh.face_corner_.extend(faces);
        for (std::uint32_t f = 0; f < faces; ++f) {
            const std::uint32_t begin = p.begin(f), end = p.ends[f];
            start[f] = Corner(begin);
            for (std::uint32_t c = begin; c < end; ++c) {
                next[c] = Corner(c + 1 < end ? c + 1 : begin);
                previous[c] = Corner(c > begin ? c - 1 : end - 1);
                face[c] = Face(f);
            }
        }
        p.next = next;
        p.previous = previous;
        p.face = face;
    }

    CrowdedEdges crowded;
    if (pair_sides(p, crowded)) wind_alike(p, crowded, repairs);
    std::size_t begin = 0;
    std::optional<FaceNormals> normals;
    if (!crowded.ends.empty()) normals.emplace(p, positions_.view());
    for (const std::size_t end : crowded.ends) {
        pair_fan(p, std::span(crowded.sides).subspan(begin, end - begin), positions_.view(), *normals);
        begin = end;
    }
    repairs.edges_split = static_cast<std::uint32_t>(crowded.ends.size());
    for (const Vertex v : split_vertices(p, crowded, repairs)) positions_.push_back(positions_[v.index]);

    // For each open side one that runs against it, in the cycle of its boundary. At a vertex at most one open side ends now.
    std::vector<Corner> open, against(positions_.size()); // against: at a vertex, the side against the open one that ends there
    for (std::uint32_t i = 0; i < corners; ++i)
        if (const Corner s(i); !p.partner[i].valid() && !p.alone(s)) {
            against[p.to(s).index] = Corner(corners + static_cast<std::uint32_t>(open.size()));
            open.push_back(s);
        }
    const auto opened = static_cast<std::uint32_t>(open.size());
    ASSERT(std::uint64_t(corners) + opened < Face::boundary_bit, "fewer than 2^31 corners");
    Vertex* const vertex = corners_.extend(opened) - corners;
    Corner* const next = mesh.corner_next_.extend(opened) - corners;
    Corner* const previous = mesh.corner_previous_.extend(opened) - corners;
    Face* const face = mesh.corner_face_.extend(opened) - corners;
    Corner* const partner = partners.extend(opened) - corners;
    for (std::uint32_t k = 0; k < opened; ++k) {
        const Corner s = open[k], t(corners + k), after = against[vertex[s.index].index];
        ASSERT(after.valid(), "an open side after each open side");
        vertex[t.index] = vertex[next[s.index].index];
        next[t.index] = after;
        previous[after.index] = t;
        face[t.index] = Face();
        partner[t.index] = s;
        partner[s.index] = t;
    }
    for (std::uint32_t k = 0; k < opened; ++k) {
        if (face[corners + k].valid()) continue;
        const Face made = Face::boundary(mesh.boundary_count());
        mesh.boundary_corner_.push_back(Corner(corners + k));
        for (Corner c(corners + k); !face[c.index].valid(); c = next[c.index]) face[c.index] = made;
    }
    repairs.boundary_edges = opened;
    repairs.boundary_loops = mesh.boundary_count();

    // Edges, as the faces first use them, and a corner for each vertex.
    Edge* const edge = mesh.corner_edge_.extend(corners + opened);
    Corner* const vertex_corner = mesh.vertex_corner_.extend(positions_.size());
    mesh.edge_corners_.reserve((corners + opened) / 2);
    for (std::uint32_t c = corners; c-- > 0;) vertex_corner[vertex[c].index] = Corner(c);
    for (std::uint32_t c = 0; c < corners; ++c) {
        const Corner across = partner[c];
        if (!across.valid()) {
            edge[c] = Edge();
        } else if (across.index > c) {
            edge[c] = edge[across.index] = Edge(mesh.edge_corners_.size());
            mesh.edge_corners_.push_back({Corner(c), across});
        }
    }
    hand_over(mesh);
    return mesh;
}

} // namespace druse
