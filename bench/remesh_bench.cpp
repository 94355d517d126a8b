// Remeshing whole meshes, own mesh in to own mesh out, from 10 thousand to 4 million new faces. Beside it OpenSubdiv as it is fastest (refiner
// from polygons, one uniform level without what interpolation does not need, positions), in floats; and `floor`, which writes as many bytes as
// the result has into fresh memory. `Time` is what passed, `CPU` the processor time of all threads.
//
// `again` makes positions alone, of a run that was kept; beside it OpenSubdiv's tables of stencils, in floats and in doubles like ours. The
// smooth preview is made `anew`, or follows a mesh of so many faces whose vertices `moved`; beside it the stencils of the same level, which give
// positions only, and not of the limit.
#include "dlfl/storage.h"
#include "ops/registry.h"
#include "ops/remesh_again.h"
#include "ops/smooth_surface.h"
#include "torus.h"

#include <benchmark/benchmark.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTable.h>
#include <opensubdiv/far/stencilTableFactory.h>
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

void remesh_again(benchmark::State& state, const Operator& op, bool triangles, double growth)
{
    const Mesh input = torus(std::int64_t(double(state.range(0)) / growth), triangles);
    const auto parameters = op.make();
    Progress progress;
    const auto kept = op.keep(input, parameters.get(), parameters.get(), progress);
    Column<Point> points;
    const std::uint32_t count = remeshed(op, input).vertex_limit();
    const std::span<Point> to(points.extend(count), count);
    for (auto _ : state) {
        kept->place(parameters.get(), to, progress);
        benchmark::ClobberMemory();
    }
}

void smooth_anew(benchmark::State& state)
{
    const Mesh input = torus(state.range(0));
    Progress progress;
    for (auto _ : state) benchmark::DoNotOptimize(SmoothSurface(input, progress).mesh().positions().data());
}

void smooth_moved(benchmark::State& state)
{
    const Mesh input = torus(state.range(0));
    Progress progress;
    SmoothSurface surface(input, progress);
    for (auto _ : state) surface.follow(input, progress);
    state.counters["faces"] = double(surface.mesh().face_count());
}

template <class Real>
struct SumOf {
    Real p[3];
    void Clear(void* = nullptr) { p[0] = p[1] = p[2] = 0; }
    void AddWithWeight(const SumOf& other, Real weight)
    {
        for (int i = 0; i < 3; ++i) p[i] += weight * other.p[i];
    }
};

/// A mesh as OpenSubdiv takes it.
template <class Real>
struct Polygons {
    std::vector<int> sides, corners;
    std::vector<SumOf<Real>> points;
    OpenSubdiv::Sdc::SchemeType scheme;

    Polygons(const Mesh& mesh, bool loop) : scheme(loop ? OpenSubdiv::Sdc::SCHEME_LOOP : OpenSubdiv::Sdc::SCHEME_CATMARK)
    {
        for (const Face f : mesh.faces()) {
            sides.push_back(mesh.valence(f));
            for (const Corner c : mesh.corners(f)) corners.push_back(int(mesh.vertex(c).index));
        }
        for (const Point& p : mesh.positions()) points.push_back({{Real(p.x), Real(p.y), Real(p.z)}});
    }

    std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> refined(int level) const
    {
        using namespace OpenSubdiv;
        Far::TopologyDescriptor polygons;
        polygons.numVertices = int(points.size());
        polygons.numFaces = int(sides.size());
        polygons.numVertsPerFace = sides.data();
        polygons.vertIndicesPerFace = corners.data();
        using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
        std::unique_ptr<Far::TopologyRefiner> refiner(Factory::Create(polygons, Factory::Options(scheme)));
        refiner->RefineUniform(Far::TopologyRefiner::UniformOptions(level));
        return refiner;
    }
};

void open_subdiv(benchmark::State& state, bool loop)
{
    using namespace OpenSubdiv;
    const Polygons<float> input(torus(state.range(0) / 4, loop), loop);
    std::unique_ptr<Far::TopologyRefiner> refiner;
    std::vector<SumOf<float>> points;
    for (auto _ : state) {
        state.PauseTiming();
        refiner.reset();
        std::vector<SumOf<float>>().swap(points);
        state.ResumeTiming();
        refiner = input.refined(1);
        points.resize(std::size_t(refiner->GetLevel(1).GetNumVertices()));
        Far::PrimvarRefiner(*refiner).Interpolate(1, input.points, points);
    }
}

template <class Real>
void stencils(benchmark::State& state, const Polygons<Real>& input, int level)
{
    using namespace OpenSubdiv;
    using Factory = Far::StencilTableFactoryReal<Real>;
    typename Factory::Options options;
    options.generateIntermediateLevels = false;
    options.generateOffsets = false;
    const std::unique_ptr<const Far::StencilTableReal<Real>> table(Factory::Create(*input.refined(level), options));
    std::vector<SumOf<Real>> points(std::size_t(table->GetNumStencils()));
    for (auto _ : state) {
        table->UpdateValues(input.points.data(), points.data());
        benchmark::ClobberMemory();
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
        sized(benchmark::RegisterBenchmark((op.name + "/again").c_str(), [&op, &s](benchmark::State& state) { remesh_again(state, op, s.triangles, s.growth); }));
        sized(benchmark::RegisterBenchmark((op.name + "/floor").c_str(), [&op, &s](benchmark::State& state) { write_floor(state, op, s.triangles, s.growth); }));
    }
    sized(benchmark::RegisterBenchmark("opensubdiv/catmull_clark", [](benchmark::State& state) { open_subdiv(state, false); }));
    sized(benchmark::RegisterBenchmark("opensubdiv/loop", [](benchmark::State& state) { open_subdiv(state, true); }));
    for (const bool loop : {false, true}) {
        const std::string name = loop ? "opensubdiv/loop" : "opensubdiv/catmull_clark";
        sized(benchmark::RegisterBenchmark((name + "/stencils").c_str(), [loop](benchmark::State& state) { stencils(state, Polygons<float>(torus(state.range(0) / 4, loop), loop), 1); }));
        sized(benchmark::RegisterBenchmark((name + "/double_stencils").c_str(), [loop](benchmark::State& state) { stencils(state, Polygons<double>(torus(state.range(0) / 4, loop), loop), 1); }));
    }
    const auto previewed = [](benchmark::internal::Benchmark* b) {
        b->Arg(90)->Arg(1'400)->Arg(23'000)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime(); // levels 5, 3 and 1, each about 92 000 faces
    };
    previewed(benchmark::RegisterBenchmark("smooth/anew", smooth_anew));
    previewed(benchmark::RegisterBenchmark("smooth/moved", smooth_moved));
    previewed(benchmark::RegisterBenchmark("smooth/double_stencils", [](benchmark::State& state) {
        stencils(state, Polygons<double>(torus(state.range(0)), false), state.range(0) < 1'000 ? 5 : state.range(0) < 10'000 ? 3 : 1);
    }));
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
