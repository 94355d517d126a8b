// The core alone: building a mesh from faces, checking it, and committing and undoing a small edit of a large mesh.
// Sizes are numbers of quads. Times are processor times; `bytes_per_face` is the memory of the finished mesh.
#include "dlfl/check.h"
#include "dlfl/measures.h"
#include "dlfl/mesh_builder.h"
#include "dlfl/patch.h"
#include "dlfl/self_intersections.h"
#include "dlfl/wall_thickness.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <unordered_map>
#include <vector>

namespace druse {
namespace {

/// Faces as a reader sees them.
struct Soup {
    std::vector<Point> points;
    std::vector<std::uint32_t> corners; // four to a face
    std::uint32_t faces() const { return static_cast<std::uint32_t>(corners.size() / 4); }
};

/// A cube of 6k² squares blown up to a sphere; vertices are numbered as the faces first use them.
Soup cube_sphere(std::uint32_t quads)
{
    const int k = std::max(1, int(std::lround(std::sqrt(quads / 6.0))));
    Soup soup;
    std::unordered_map<std::uint64_t, std::uint32_t> ids;
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side)
            for (int i = 0; i < k; ++i)
                for (int j = 0; j < k; ++j) {
                    const auto at = [&](int a, int b) {
                        int p[3];
                        p[axis] = side * k;
                        p[(axis + 1) % 3] = a;
                        p[(axis + 2) % 3] = b;
                        const std::uint64_t key = (std::uint64_t(p[0]) << 42) | (std::uint64_t(p[1]) << 21) | std::uint64_t(p[2]);
                        const auto [it, made] = ids.try_emplace(key, std::uint32_t(soup.points.size()));
                        if (made) soup.points.push_back(unit(Point(p[0], p[1], p[2]) - 0.5 * k * Vector(1)));
                        return it->second;
                    };
                    std::uint32_t face[4] = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
                    if (side == 0) std::swap(face[1], face[3]);
                    soup.corners.insert(soup.corners.end(), face, face + 4);
                }
    return soup;
}

/// The same surface with vertices and faces in random order, as the worst of files have them.
Soup shuffled(Soup soup)
{
    std::mt19937 random(1);
    std::vector<std::uint32_t> vertex(soup.points.size()), face(soup.faces());
    std::iota(vertex.begin(), vertex.end(), 0u);
    std::iota(face.begin(), face.end(), 0u);
    std::shuffle(vertex.begin(), vertex.end(), random);
    std::shuffle(face.begin(), face.end(), random);
    Soup result;
    result.points.resize(soup.points.size());
    for (std::uint32_t v = 0; v < vertex.size(); ++v) result.points[vertex[v]] = soup.points[v];
    for (const std::uint32_t f : face)
        for (std::uint32_t k = 0; k < 4; ++k) result.corners.push_back(vertex[soup.corners[4 * f + k]]);
    return result;
}

MeshBuilder filled(const Soup& soup)
{
    MeshBuilder builder;
    builder.reserve(static_cast<std::uint32_t>(soup.points.size()), soup.faces(), static_cast<std::uint32_t>(soup.corners.size()));
    for (const Point& p : soup.points) builder.add_vertex(p);
    for (std::uint32_t f = 0; f < soup.faces(); ++f) builder.add_face({soup.corners.data() + 4 * std::size_t(f), 4});
    return builder;
}

Mesh build(const Soup& soup)
{
    MeshBuilder builder = filled(soup);
    Repairs repairs;
    return builder.build(repairs);
}

void count_faces(benchmark::State& state, const Soup& soup)
{
    state.SetItemsProcessed(state.iterations() * soup.faces());
}

// From arrays to a finished mesh, copying into the builder included.
void BuildFromFaces(benchmark::State& state)
{
    const Soup soup = cube_sphere(std::uint32_t(state.range(0)));
    std::size_t bytes = 0;
    for (auto _ : state) {
        const Mesh mesh = build(soup);
        bytes = mesh.bytes();
    }
    count_faces(state, soup);
    state.counters["bytes_per_face"] = double(bytes) / soup.faces();
}

void BuildFromShuffledFaces(benchmark::State& state)
{
    const Soup soup = shuffled(cube_sphere(std::uint32_t(state.range(0))));
    for (auto _ : state) benchmark::DoNotOptimize(build(soup));
    count_faces(state, soup);
}

void FillBuilder(benchmark::State& state)
{
    const Soup soup = cube_sphere(std::uint32_t(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(filled(soup));
    count_faces(state, soup);
}

// A tenth of the faces wound against the others: everything has to be mended.
void BuildFromMiswoundFaces(benchmark::State& state)
{
    Soup soup = cube_sphere(std::uint32_t(state.range(0)));
    for (std::uint32_t f = 0; f < soup.faces(); f += 10) std::swap(soup.corners[4 * f + 1], soup.corners[4 * f + 3]);
    for (auto _ : state) benchmark::DoNotOptimize(build(soup));
    count_faces(state, soup);
}

void Check(benchmark::State& state)
{
    const Soup soup = cube_sphere(std::uint32_t(state.range(0)));
    const Mesh mesh = build(soup);
    for (auto _ : state) benchmark::DoNotOptimize(check(mesh));
    count_faces(state, soup);
}

void Facts(benchmark::State& state)
{
    const Soup soup = cube_sphere(std::uint32_t(state.range(0)));
    const Mesh mesh = build(soup);
    for (auto _ : state) benchmark::DoNotOptimize(facts(mesh));
    count_faces(state, soup);
}

void Copy(benchmark::State& state)
{
    const Soup soup = cube_sphere(std::uint32_t(state.range(0)));
    const Mesh mesh = build(soup);
    for (auto _ : state) benchmark::DoNotOptimize(Mesh(mesh));
    count_faces(state, soup);
}

/// A box on a face: n walls and the top, which keeps the face's id.
Patch box_patch(int n)
{
    Patch patch(n, n);
    std::vector<int> top;
    for (int i = 0; i < n; ++i) top.push_back(n + i);
    patch.add(top);
    for (int i = 0; i < n; ++i) patch.add({i, (i + 1) % n, n + (i + 1) % n, n + i});
    patch.connect();
    return patch;
}

void raise(Mesh& mesh, Face f, const Patch& patch)
{
    const Vector up = unit_normal(mesh, f);
    std::vector<Point> foot;
    for (const Corner c : mesh.corners(f)) foot.push_back(mesh.position(c));
    std::uint32_t v = mesh.replace_face(f, patch);
    for (const Point& p : foot) mesh.set_position(Vertex(v++), p + 0.01 * up);
}

// One face extruded, checked and committed, then undone: what a click costs beside drawing.
void CommitAndUndoOneFace(benchmark::State& state)
{
    const Soup soup = cube_sphere(std::uint32_t(state.range(0)));
    Mesh mesh = build(soup);
    const Patch patch = box_patch(4);
    std::mt19937 random(1);
    std::size_t step = 0;
    for (auto _ : state) {
        mesh.begin_change();
        raise(mesh, Face(std::uint32_t(random() % soup.faces())), patch);
        MeshChange change = mesh.end_change();
        if (!check_change(mesh, change).empty()) state.SkipWithError("not sound");
        step = change.bytes();
        mesh.exchange(change);
    }
    state.counters["undo_step_bytes"] = double(step);
}

// All faces replaced in one go, the change recorded: the floor under the extrusions.
void ReplaceEveryFace(benchmark::State& state)
{
    const Soup soup = cube_sphere(std::uint32_t(state.range(0)));
    const Mesh mesh = build(soup);
    const Patch patch = box_patch(4);
    std::vector<Face> all(soup.faces());
    for (std::uint32_t f = 0; f < all.size(); ++f) all[f] = Face(f);
    const std::vector<const Patch*> patches(all.size(), &patch);
    std::size_t step = 0;
    for (auto _ : state) {
        state.PauseTiming();
        Mesh copy = mesh;
        state.ResumeTiming();
        copy.begin_change();
        benchmark::DoNotOptimize(copy.replace_faces(all, patches));
        const MeshChange change = copy.end_change();
        state.PauseTiming();
        step = change.bytes();
        copy.clear();
        state.ResumeTiming();
    }
    count_faces(state, soup);
    state.counters["undo_step_bytes"] = double(step);
}

// Nothing to be found, as in a good model: what it costs to make sure. Two triangles a quad.
void FindSelfIntersections(benchmark::State& state)
{
    const Soup soup = cube_sphere(std::uint32_t(state.range(0)));
    const Mesh mesh = build(soup);
    Progress progress;
    for (auto _ : state) benchmark::DoNotOptimize(self_intersections(mesh, progress).pairs);
    count_faces(state, soup);
}

// Three rays in the corners of each triangle and one in its middle, through the whole sphere.
void MeasureWalls(benchmark::State& state)
{
    const Soup soup = cube_sphere(std::uint32_t(state.range(0)));
    const Mesh mesh = build(soup);
    Progress progress;
    for (auto _ : state) {
        const RayCast rays(mesh, progress, 0.5);
        benchmark::DoNotOptimize(wall_thickness(mesh, rays, 1e-6, progress, 0.5).thinnest);
    }
    count_faces(state, soup);
}

#define THREE_SIZES Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond)
BENCHMARK(BuildFromFaces)->THREE_SIZES;
BENCHMARK(BuildFromShuffledFaces)->THREE_SIZES;
BENCHMARK(BuildFromMiswoundFaces)->THREE_SIZES;
BENCHMARK(FillBuilder)->THREE_SIZES;
BENCHMARK(Check)->THREE_SIZES;
BENCHMARK(Facts)->THREE_SIZES;
BENCHMARK(Copy)->THREE_SIZES;
BENCHMARK(CommitAndUndoOneFace)->THREE_SIZES;
BENCHMARK(ReplaceEveryFace)->THREE_SIZES;
BENCHMARK(FindSelfIntersections)->THREE_SIZES;
BENCHMARK(MeasureWalls)->THREE_SIZES;

} // namespace
} // namespace druse

BENCHMARK_MAIN();
