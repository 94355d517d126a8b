// Struts around the edges of meshes and around crystal nets, from a graph in memory to the mesh, everything included that the operator does: cleaning,
// placing, looking for what comes too near, hulls, and connecting. Files named on the command line are taken as well.
// Processor time is that of all threads. tri is the time for one triangle of the result, as if all its faces were cut.
#include "app/registry.h"
#include "graph/edge_graph.h"
#include "graph/lattice.h"
#include "io/read.h"
#include "torus.h"

#include <benchmark/benchmark.h>

#include <sys/resource.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace druse {
namespace {

using Arguments = std::vector<std::pair<std::string, std::string>>;

void run(Scene& scene, const Arguments& arguments, Context& context)
{
    const Operator& op = all_operators().get("graph.struts");
    const auto parameters = op.make();
    for (const auto& [key, value] : arguments) op.find(key)->set(parameters.get(), value);
    op.run(scene, parameters.get(), context);
}

void struts(benchmark::State& state, const Graph& graph, const Arguments& arguments)
{
    Progress progress;
    Scene scene;
    for (auto _ : state) {
        state.PauseTiming();
        scene = Scene(); // the memory of the run before is given back first
        scene.source.replace_with(graph);
        Context context{.progress = progress};
        state.ResumeTiming();
        run(scene, arguments, context);
    }
    const double triangles = 2.0 * scene.mesh.edge_count() - 2.0 * scene.mesh.face_count(); // of faces with k corners k − 2
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    state.counters["edges"] = double(graph.edges.size());
    state.counters["triangles"] = triangles;
    state.counters["tri"] = benchmark::Counter(triangles, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["edge"] = benchmark::Counter(double(graph.edges.size()), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["peak_bytes_tri"] = 1024.0 * double(used.ru_maxrss) / triangles; // of the whole program
}

Graph edges_of(const Mesh& mesh)
{
    std::vector<Edge> all;
    for (const Edge e : mesh.edges()) all.push_back(e);
    return edge_graph(mesh, all);
}

void Surface(benchmark::State& state) { struts(state, edges_of(torus(2 * state.range(0) / 3, true)), {{"radius", "0.05"}}); }

void Diamond(benchmark::State& state)
{
    Progress progress;
    const int n = static_cast<int>(state.range(0));
    LatticeShape shape;
    shape.cells = {n, n, n};
    struts(state, lattice(shape, progress), {});
}

#define HOW Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()
BENCHMARK(Surface)->Arg(758)->Arg(2'000)->Arg(10'000)->Arg(110'000)->HOW;
BENCHMARK(Diamond)->Arg(4)->Arg(9)->Arg(19)->HOW; // 16 n³ edges

} // namespace
} // namespace druse

int main(int argc, char** argv)
{
    using namespace druse;
    benchmark::Initialize(&argc, argv);
    std::vector<Graph> graphs;
    for (int i = 1; i < argc; ++i) {
        Progress progress;
        const Model model = read_model(argv[i], progress);
        graphs.push_back(model.graph ? *model.graph : edges_of(model.mesh));
    }
    for (int i = 1; i < argc; ++i)
        for (const char* radius : {"0.075", "0.15"})
            benchmark::RegisterBenchmark((std::string(argv[i]) + " " + radius).c_str(),
                                         [&graph = graphs[std::size_t(i - 1)], radius](benchmark::State& state) { struts(state, graph, {{"radius", radius}}); })
                ->HOW;
    benchmark::RunSpecifiedBenchmarks();
}
