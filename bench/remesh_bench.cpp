// Remeshing whole meshes, own mesh in to own mesh out, from 10 thousand to 4 million new faces. Beside it OpenSubdiv as it is fastest (refiner
// from polygons, one uniform level without what interpolation does not need, positions), in floats; and `floor`, which writes as many bytes as
// the result has into fresh memory. `Time` is what passed, `CPU` the processor time of all threads.
#include "dlfl/storage.h"
#include "ops/registry.h"
#include "torus.h"

#include <benchmark/benchmark.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace druse {
namespace {

struct Scheme {
    const char* name;
    bool triangles;
    double growth; // of the number of faces, on such a mesh
};
const Scheme schemes[] = {
    {"remesh.catmull_clark", false, 4}, {"remesh.doo_sabin", false, 4}, {"remesh.loop", true, 4}, {"remesh.sqrt3", true, 3},
    {"remesh.dual", false, 1},          {"remesh.truncate", false, 2},  {"remesh.checkerboard", false, 9},
};

void report(benchmark::State& state, const Mesh& result)
{
    state.counters["faces_per_s"] = benchmark::Counter(double(result.face_count()), benchmark::Counter::kIsIterationInvariantRate);
    state.counters["MB"] = double(result.bytes()) / 1e6;
}

Mesh remeshed(const Operator& op, const Mesh& input)
{
    Scene scene;
    scene.mesh = input;
    Progress progress;
    Context context{.progress = progress};
    op.run(scene, op.make().get(), context);
    return std::move(scene.mesh);
}

void remesh(benchmark::State& state, const Operator& op, bool triangles, double growth)
{
    const Mesh input = torus(std::int64_t(double(state.range(0)) / growth), triangles);
    Scene scene;
    const auto parameters = op.make();
    Progress progress;
    Context context{.progress = progress};
    for (auto _ : state) {
        state.PauseTiming();
        scene.mesh = Mesh(); // the memory of the run before is given back first
        scene.mesh = Mesh(input);
        state.ResumeTiming();
        op.run(scene, parameters.get(), context);
    }
    report(state, scene.mesh);
}

/// As many bytes as the operator's result, written in order.
void write_floor(benchmark::State& state, const Operator& op, bool triangles, double growth)
{
    const std::size_t bytes = remeshed(op, torus(std::int64_t(double(state.range(0)) / growth), triangles)).bytes();
    for (auto _ : state) {
        Storage fresh;
        fresh.reserve(bytes);
        std::memset(fresh.data(), int(state.iterations()), bytes);
        benchmark::ClobberMemory();
    }
    state.counters["MB"] = double(bytes) / 1e6;
}

struct FloatPoint {
    float p[3];
    void Clear(void* = nullptr) { p[0] = p[1] = p[2] = 0; }
    void AddWithWeight(const FloatPoint& other, float weight)
    {
        for (int i = 0; i < 3; ++i) p[i] += weight * other.p[i];
    }
};

void open_subdiv(benchmark::State& state, bool loop)
{
    using namespace OpenSubdiv;
    const Mesh input = torus(state.range(0) / 4, loop);
    std::vector<int> sides, corners;
    for (const Face f : input.faces()) {
        sides.push_back(input.valence(f));
        for (const Corner c : input.corners(f)) corners.push_back(int(input.vertex(c).index));
    }
    std::vector<FloatPoint> base;
    for (const Point& p : input.positions()) base.push_back({{float(p.x), float(p.y), float(p.z)}});
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    std::unique_ptr<Far::TopologyRefiner> refiner;
    std::vector<FloatPoint> points;
    for (auto _ : state) {
        state.PauseTiming();
        refiner.reset();
        std::vector<FloatPoint>().swap(points);
        state.ResumeTiming();
        Far::TopologyDescriptor polygons;
        polygons.numVertices = int(base.size());
        polygons.numFaces = int(sides.size());
        polygons.numVertsPerFace = sides.data();
        polygons.vertIndicesPerFace = corners.data();
        refiner.reset(Factory::Create(polygons, Factory::Options(loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK)));
        refiner->RefineUniform(Far::TopologyRefiner::UniformOptions(1));
        points.resize(std::size_t(refiner->GetLevel(1).GetNumVertices()));
        Far::PrimvarRefiner(*refiner).Interpolate(1, base, points);
    }
}

} // namespace
} // namespace druse

int main(int argc, char** argv)
{
    using namespace druse;
    Registry registry;
    register_remesh(registry);
    const auto sized = [](benchmark::internal::Benchmark* b) {
        for (const std::int64_t faces : {10'000, 100'000, 1'000'000, 4'000'000}) b->Arg(faces);
        b->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
    };
    for (const Scheme& s : schemes) {
        const Operator& op = registry.get(s.name);
        sized(benchmark::RegisterBenchmark((op.name + "/run").c_str(), [&op, &s](benchmark::State& state) { remesh(state, op, s.triangles, s.growth); }));
        sized(benchmark::RegisterBenchmark((op.name + "/floor").c_str(), [&op, &s](benchmark::State& state) { write_floor(state, op, s.triangles, s.growth); }));
    }
    sized(benchmark::RegisterBenchmark("opensubdiv/catmull_clark", [](benchmark::State& state) { open_subdiv(state, false); }));
    sized(benchmark::RegisterBenchmark("opensubdiv/loop", [](benchmark::State& state) { open_subdiv(state, true); }));
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
