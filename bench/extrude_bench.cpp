// Extruding every face on its own: each of the seven tiered extrusions on all faces of a mesh of quads, as the operator runs inside a
// document (recording its change for undo) and as a plain function of a mesh. `floor` writes the result of the cubical extrusion as plain
// index and position arrays in fresh memory, the least that any program must do. Times are processor times.
#include "ops/extrude.h"
#include "ops/registry.h"
#include "ops/tiered_kernels.h"
#include "torus.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace druse {
namespace {

std::vector<Face> all_faces(const Mesh& mesh)
{
    std::vector<Face> faces;
    for (const Face f : mesh.faces()) faces.push_back(f);
    return faces;
}

void report(benchmark::State& state, std::size_t faces, const Mesh& result)
{
    state.counters["faces_per_s"] = benchmark::Counter(double(faces), benchmark::Counter::kIsIterationInvariantRate);
    state.counters["MB"] = double(result.bytes()) / 1e6;
}

template <class Kernel>
void extrude(benchmark::State& state)
{
    const Mesh input = torus(state.range(0));
    const std::vector<Face> faces = all_faces(input);
    Progress progress;
    Mesh mesh;
    for (auto _ : state) {
        state.PauseTiming();
        mesh = Mesh(); // the memory of the run before is given back first
        mesh = Mesh(input);
        state.ResumeTiming();
        benchmark::DoNotOptimize(extrude_faces(mesh, faces, Kernel(), NewGroups::each, 1, false, progress));
    }
    report(state, faces.size(), mesh);
}

/// The same with its change recorded, and then undone outside the measured time.
template <class Kernel>
void extrude_and_record(benchmark::State& state)
{
    Mesh mesh = torus(state.range(0));
    const std::vector<Face> faces = all_faces(mesh);
    Progress progress;
    std::size_t bytes = 0;
    for (auto _ : state) {
        mesh.begin_change();
        extrude_faces(mesh, faces, Kernel(), NewGroups::each, 1, false, progress);
        MeshChange change = mesh.end_change();
        state.PauseTiming();
        bytes = change.bytes();
        mesh.exchange(change);
        state.ResumeTiming();
    }
    report(state, faces.size(), mesh);
    state.counters["undo_MB"] = double(bytes) / 1e6;
}

/// The operator extrude.solid with these arguments, as a function of a scene.
void extrude_solid(benchmark::State& state, const char* solid, const char* planar)
{
    Registry registry;
    register_extrude(registry);
    const Operator& op = registry.get("extrude.solid");
    const auto parameters = op.make();
    for (const auto& [key, value] : {std::pair("solid", solid), {"planar", planar}, {"faces", "all"}}) op.find(key)->set(parameters.get(), value);
    const Mesh input = torus(state.range(0));
    Progress progress;
    Context context{.progress = progress};
    Scene scene;
    for (auto _ : state) {
        state.PauseTiming();
        scene.mesh = Mesh();
        scene.mesh = Mesh(input);
        state.ResumeTiming();
        op.run(scene, parameters.get(), context);
    }
    report(state, input.face_count(), scene.mesh);
}

void floor(benchmark::State& state)
{
    const Mesh input = torus(state.range(0));
    std::vector<std::array<float, 3>> points;
    std::vector<std::uint32_t> corners;
    for (const Vertex v : input.vertices()) points.push_back({float(input.position(v).x), float(input.position(v).y), float(input.position(v).z)});
    for (const Face f : input.faces())
        for (const Corner c : input.corners(f)) corners.push_back(input.vertex(c).index);
    for (auto _ : state) {
        auto out = std::make_unique_for_overwrite<std::array<float, 3>[]>(points.size() + corners.size());
        auto faces = std::make_unique_for_overwrite<std::uint32_t[]>(5 * corners.size());
        std::copy(points.begin(), points.end(), out.get());
        std::uint32_t* w = faces.get();
        for (std::size_t f = 0; f < corners.size(); f += 4) {
            const auto ring = [&](std::size_t k) { return corners[f + k % 4]; };
            const auto raised = [&](std::size_t k) { return static_cast<std::uint32_t>(points.size() + f + k % 4); };
            float n[3] = {}, square = 0;
            for (std::size_t k = 0; k < 4; ++k)
                for (int d = 0; d < 3; ++d) {
                    const auto &p = points[ring(k)], &q = points[ring(k + 1)];
                    n[d] += (p[(d + 1) % 3] - q[(d + 1) % 3]) * (p[(d + 2) % 3] + q[(d + 2) % 3]);
                }
            for (const float x : n) square += x * x;
            const float scale = 0.01f / std::sqrt(square);
            for (std::size_t k = 0; k < 4; ++k) {
                for (int d = 0; d < 3; ++d) out[raised(k)][d] = points[ring(k)][d] + scale * n[d];
                *w++ = raised(k);
            }
            for (std::size_t k = 0; k < 4; ++k) {
                *w++ = ring(k);
                *w++ = ring(k + 1);
                *w++ = raised(k + 1);
                *w++ = raised(k);
            }
        }
        benchmark::DoNotOptimize(out.get());
        benchmark::DoNotOptimize(faces.get());
    }
    state.counters["faces_per_s"] = benchmark::Counter(double(corners.size()) / 4, benchmark::Counter::kIsIterationInvariantRate);
}

#define SIZES ->Unit(benchmark::kMillisecond)->Arg(10'000)->Arg(100'000)->Arg(1'000'000)
BENCHMARK(floor) SIZES;
BENCHMARK(extrude<Tetrahedral>) SIZES;
BENCHMARK(extrude<Cubical>) SIZES;
BENCHMARK(extrude<Octahedral>) SIZES;
BENCHMARK(extrude<Dodecahedral>) SIZES;
BENCHMARK(extrude<Icosahedral>) SIZES;
BENCHMARK(extrude<Cuboctahedral>) SIZES;
BENCHMARK(extrude<Rhombicuboctahedral>) SIZES;
BENCHMARK_CAPTURE(extrude_solid, cube, "cube", "off") SIZES;
BENCHMARK_CAPTURE(extrude_solid, cube_flat, "cube", "free")->Unit(benchmark::kMillisecond)->Arg(10'000)->Arg(100'000);
BENCHMARK_CAPTURE(extrude_solid, rhombicuboctahedron, "rhombicuboctahedron", "off") SIZES;
BENCHMARK_CAPTURE(extrude_solid, rhombicuboctahedron_flat, "rhombicuboctahedron", "free")->Unit(benchmark::kMillisecond)->Arg(1'000)->Arg(10'000);
BENCHMARK_CAPTURE(extrude_solid, truncated_cube, "truncated_cube", "off") SIZES;
BENCHMARK(extrude_and_record<Cubical>) SIZES;
BENCHMARK(extrude_and_record<Dodecahedral>) SIZES;

} // namespace
} // namespace druse

BENCHMARK_MAIN();
