#include "dlfl/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <limits>
#include <numeric>
#include <span>

namespace druse {

Vector area_vector(const Mesh& mesh, Face f)
{
    // Taken about the first corner, so that a face far from the origin loses no digits.
    const Corner first = mesh.corner(f);
    const Point origin = mesh.position(first);
    Vector sum(0.0);
    for (Corner c = mesh.next(first); mesh.next(c) != first; c = mesh.next(c))
        sum += glm::cross(mesh.position(c) - origin, mesh.position(mesh.next(c)) - origin);
    return 0.5 * sum;
}

Vector unit_normal(const Mesh& mesh, Face f) { return unit(area_vector(mesh, f)); }

Point vertex_mean(const Mesh& mesh, Face f)
{
    Vector sum(0.0);
    int n = 0;
    for (const Corner c : mesh.corners(f)) {
        sum += mesh.position(c);
        ++n;
    }
    return sum / double(n);
}

double area(const Mesh& mesh, Face f) { return glm::length(area_vector(mesh, f)); }

double length(const Mesh& mesh, Edge e)
{
    const auto [a, b] = mesh.ends(e);
    return glm::distance(mesh.position(a), mesh.position(b));
}

double nonplanarity(const Mesh& mesh, Face f)
{
    const Corner first = mesh.corner(f);
    if (mesh.next(mesh.next(mesh.next(first))) == first) return 0.0; // a triangle, or fewer corners
    const Vector normal = unit_normal(mesh, f);
    const Point mean = vertex_mean(mesh, f);
    double farthest = 0.0;
    for (const Corner c : mesh.corners(f)) farthest = std::max(farthest, std::abs(glm::dot(mesh.position(c) - mean, normal)));
    return farthest;
}

namespace {

/// Called in every turn of a long loop: now and then it asks whether to go on.
class Breath {
public:
    Breath() = default; // nobody cancels
    Breath(Progress& progress, double done) : progress_(&progress), done_(done) {}
    void operator()()
    {
        if ((++turns_ & 0x3fff) == 0) at_once();
    }
    void at_once()
    {
        if (progress_) progress_->step(done_);
    }

private:
    Progress* progress_ = nullptr;
    double done_ = 0;
    std::uint32_t turns_ = 0;
};

/// Six times the signed volume between the origin and a face fanned from its vertex mean.
double six_volumes(const Mesh& mesh, Face f, const Point& origin)
{
    const Point mean = vertex_mean(mesh, f) - origin;
    double sum = 0.0;
    for (const Corner c : mesh.corners(f))
        sum += glm::dot(mean, glm::cross(mesh.position(c) - origin, mesh.position(mesh.next(c)) - origin));
    return sum;
}

/// About a point near the model: far from it, digits would be lost.
double volume(const Mesh& mesh, const Point& origin, Breath breath)
{
    double sum = 0.0;
    for (const Face f : mesh.faces()) {
        breath();
        sum += six_volumes(mesh, f, origin);
    }
    for (const Face f : mesh.boundary_faces()) sum += six_volumes(mesh, f, origin);
    return sum / 6.0;
}

} // namespace

Box bounds(const Mesh& mesh)
{
    Box box;
    for (const Vertex v : mesh.vertices()) box.add(mesh.position(v));
    return box;
}

double volume(const Mesh& mesh) { return volume(mesh, bounds(mesh).center(), Breath()); }

double surface_area(const Mesh& mesh)
{
    double sum = 0.0;
    for (const Face f : mesh.faces()) sum += area(mesh, f);
    return sum;
}

namespace {

Components components(const Mesh& mesh, Breath breath)
{
    // Faces, then boundary faces, joined across edges; the root of a set is its lowest member.
    const std::uint32_t faces = mesh.face_limit(), all = faces + mesh.boundary_count();
    std::vector<std::uint32_t> parent(all);
    std::iota(parent.begin(), parent.end(), 0u);
    const auto slot = [faces](Face f) { return f.is_boundary() ? faces + f.boundary_index() : f.index; };
    const auto find = [&parent](std::uint32_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    for (const Edge e : mesh.edges()) {
        breath();
        const auto [f, g] = mesh.faces(e);
        const std::uint32_t a = find(slot(f)), b = find(slot(g));
        if (a != b) parent[std::max(a, b)] = std::min(a, b);
    }
    Components result;
    result.of_face.assign(faces, Face::none);
    std::vector<std::uint32_t> part_of_root(all, Face::none);
    for (const Face f : mesh.faces()) {
        breath();
        std::uint32_t& part = part_of_root[find(f.index)];
        if (part == Face::none) {
            part = static_cast<std::uint32_t>(result.parts.size());
            result.parts.emplace_back();
        }
        result.of_face[f.index] = part;
        ++result.parts[part].faces;
        ++result.parts[part].euler;
    }
    const auto part_of = [&](Face f) -> Components::Part& { return result.parts[part_of_root[find(slot(f))]]; };
    for (const Face f : mesh.boundary_faces()) ++part_of(f).boundary_loops;
    for (const Edge e : mesh.edges()) {
        breath();
        --part_of(mesh.face(mesh.corner(e, 0))).euler;
    }
    for (const Vertex v : mesh.vertices()) {
        breath();
        ++part_of(mesh.face(mesh.corner(v))).euler;
    }
    return result;
}

} // namespace

Components components(const Mesh& mesh) { return components(mesh, Breath()); }

std::int64_t euler_characteristic(const Mesh& mesh)
{
    return std::int64_t(mesh.vertex_count()) - mesh.edge_count() + mesh.face_count();
}

std::int64_t genus(const Mesh& mesh)
{
    // Σ (2 − χ_c − loops_c) / 2 over the components.
    const auto parts = static_cast<std::int64_t>(components(mesh).parts.size());
    return (2 * parts - euler_characteristic(mesh) - mesh.boundary_count()) / 2;
}

std::uint32_t boundary_edge_count(const Mesh& mesh)
{
    std::uint32_t count = 0;
    for (const Face f : mesh.boundary_faces()) count += static_cast<std::uint32_t>(mesh.valence(f));
    return count;
}

namespace {

/// Edges with the same two ends as an edge of lower id.
std::uint32_t count_parallel_edges(const Mesh& mesh, Breath breath)
{
    // Parallel edges are met at the end with fewer corners, so that a vertex of huge valence is never searched.
    std::uint32_t parallel = 0;
    std::vector<std::uint32_t> seen(mesh.vertex_limit(), Vertex::none), degree(mesh.vertex_limit(), 0);
    for (const Edge e : mesh.edges()) {
        breath();
        for (const Vertex v : mesh.ends(e)) ++degree[v.index];
    }
    for (const Vertex v : mesh.vertices()) {
        if (mesh.is_point_sphere(v)) continue;
        for (const Corner c : mesh.around(v)) {
            breath();
            const Vertex w = mesh.target(c);
            if (w == v || degree[v.index] > degree[w.index] || (degree[v.index] == degree[w.index] && v > w)) continue;
            if (seen[w.index] == v.index) ++parallel;
            seen[w.index] = v.index;
        }
    }
    return parallel;
}

/// Do two faces have the same vertices in opposite rotation?
bool lie_on_each_other(const Mesh& mesh, Face f, Face g)
{
    const Vertex first = mesh.vertex(mesh.corner(f));
    for (const Corner start : mesh.corners(g)) {
        if (mesh.vertex(start) != first) continue;
        Corner a = mesh.corner(f), b = start;
        bool same = true;
        do {
            a = mesh.next(a);
            b = mesh.previous(b);
            same = mesh.vertex(a) == mesh.vertex(b);
        } while (same && a != mesh.corner(f));
        if (same && b == start) return true;
    }
    return false;
}

struct Summed {
    std::uint64_t sum; // of what its vertices hash to: equal for faces with the same vertices
    Face face;
    friend auto operator<=>(const Summed&, const Summed&) = default;
};

std::uint64_t sum_of_vertices(const Mesh& mesh, Face f)
{
    std::uint64_t sum = 0;
    for (const Corner c : mesh.corners(f)) {
        std::uint64_t x = mesh.vertex(c).index + 0x9e3779b97f4a7c15ull; // splitmix64
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
        sum += x ^ (x >> 31);
    }
    return sum;
}

/// Pairs among faces of one bucket, which are sorted for that.
std::uint32_t count_walls(const Mesh& mesh, std::span<Summed> faces)
{
    std::sort(faces.begin(), faces.end());
    std::uint32_t walls = 0;
    for (std::size_t i = 0; i < faces.size();) {
        std::size_t j = i + 1;
        while (j < faces.size() && faces[j].sum == faces[i].sum) ++j;
        std::vector<bool> used(j - i, false);
        for (std::size_t a = i; a < j; ++a)
            for (std::size_t b = a + 1; b < j && !used[a - i]; ++b)
                if (!used[b - i] && lie_on_each_other(mesh, faces[a].face, faces[b].face)) {
                    used[a - i] = used[b - i] = true;
                    ++walls;
                }
        i = j;
    }
    return walls;
}

/// Pairs of faces that lie on each other: the same vertices in opposite rotation.
std::uint32_t count_zero_thickness_walls(const Mesh& mesh, Breath breath)
{
    // Such faces share an edge in a punched rind, but need not: look them up by what their vertices add up to. Faces that may
    // match are in the same of some buckets, each small enough to stay in the cache while it is sorted.
    constexpr int bits = 10;
    const auto bucket_of = [](std::uint64_t sum) { return std::size_t(sum >> (64 - bits)); };
    std::vector<Summed> sums;
    sums.reserve(mesh.face_count());
    std::array<std::size_t, (1u << bits) + 1> ends{};
    for (const Face f : mesh.faces()) {
        breath();
        const Corner first = mesh.corner(f);
        if (mesh.next(mesh.next(first)) == first) continue; // one side or two: no wall
        sums.push_back({sum_of_vertices(mesh, f), f});
        ++ends[bucket_of(sums.back().sum) + 1];
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<Summed> sorted(sums.size());
    for (const Summed& s : sums) {
        breath();
        sorted[ends[bucket_of(s.sum)]++] = s; // from where a bucket begins to where it ends
    }
    std::uint32_t walls = 0;
    for (std::size_t i = 0, begin = 0; i < ends.size() - 1; begin = ends[i++]) {
        walls += count_walls(mesh, std::span(sorted).subspan(begin, ends[i] - begin));
        breath.at_once();
    }
    return walls;
}

} // namespace

MeshFacts facts(const Mesh& mesh)
{
    Progress progress;
    return facts(mesh, progress);
}

MeshFacts facts(const Mesh& mesh, Progress& progress)
{
    MeshFacts r;
    r.counts = mesh.counts();
    const Components parts = components(mesh, {progress, 0.0});
    r.components = static_cast<std::uint32_t>(parts.parts.size());
    for (const auto& part : parts.parts) r.component_genus.push_back((2 - part.euler - part.boundary_loops) / 2);
    r.genus = std::accumulate(r.component_genus.begin(), r.component_genus.end(), std::int64_t(0));
    r.euler = euler_characteristic(mesh);
    r.boundary_edges = boundary_edge_count(mesh);
    r.bounds = bounds(mesh);
    r.volume = volume(mesh, r.bounds.center(), {progress, 0.3});
    Breath breath(progress, 0.4);
    for (const Face f : mesh.faces()) {
        breath();
        const int n = mesh.valence(f);
        r.corners += static_cast<std::uint32_t>(n);
        ++r.sides[n];
        ++r.groups[mesh.group(f)];
        if (n == 1 && !mesh.edge(mesh.corner(f)).valid()) continue;
        r.area += area(mesh, f);
        r.max_nonplanarity = std::max(r.max_nonplanarity, nonplanarity(mesh, f));
    }
    for (const Vertex v : mesh.vertices()) {
        breath();
        ++r.valences[mesh.valence(v)];
        if (mesh.is_point_sphere(v)) ++r.point_spheres;
    }
    double sum = 0.0;
    if (mesh.edge_count() > 0) r.shortest_edge = std::numeric_limits<double>::infinity();
    for (const Edge e : mesh.edges()) {
        breath();
        const double l = length(mesh, e);
        r.shortest_edge = std::min(r.shortest_edge, l);
        r.longest_edge = std::max(r.longest_edge, l);
        sum += l;
    }
    r.mean_edge = mesh.edge_count() > 0 ? sum / mesh.edge_count() : 0.0;
    r.parallel_edges = count_parallel_edges(mesh, {progress, 0.6});
    r.zero_thickness_walls = count_zero_thickness_walls(mesh, {progress, 0.8});
    return r;
}

} // namespace druse
