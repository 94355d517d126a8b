// Crusts, and holes in them. A crust is timed from a mesh in memory to its double, table included, in place; beside it CGAL's extrude_mesh with the
// vertex normals that it needs, of as many triangles. Of single openings, Document::apply is timed on crusts of three sizes; undoing them is not.
#include "app/document.h"
#include "app/registry.h"
#include "torus.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/extrude.h>
#include <CGAL/Surface_mesh.h>
#include <benchmark/benchmark.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

namespace druse {
namespace {

using Arguments = std::vector<std::pair<const char*, std::string>>;

void run(Scene& scene, const char* name, const Arguments& arguments)
{
    const Operator& op = all_operators().get(name);
    const auto parameters = op.make();
    for (const auto& [key, value] : arguments) op.find(key)->set(parameters.get(), value);
    Progress progress;
    Context context{.progress = progress};
    op.run(scene, parameters.get(), context);
}

void crust(benchmark::State& state, const Arguments& arguments)
{
    const Mesh input = torus(state.range(0));
    Scene scene;
    for (auto _ : state) {
        state.PauseTiming();
        scene = Scene(); // the memory of the run before is given back first
        scene.mesh = Mesh(input);
        state.ResumeTiming();
        run(scene, "rind.crust", arguments);
    }
    state.counters["faces_per_s"] = benchmark::Counter(double(input.face_count()), benchmark::Counter::kIsIterationInvariantRate);
    state.counters["MB"] = double(scene.mesh.bytes()) / 1e6;
}

void Crust(benchmark::State& state) { crust(state, {{"guard", "off"}, {"thickness", "0.001"}}); }
void CrustUniform(benchmark::State& state) { crust(state, {{"guard", "off"}, {"thickness", "0.001"}, {"uniform", "true"}}); }
void CrustGuarded(benchmark::State& state) { crust(state, {{"thickness", "0.001"}}); }

void open_many(benchmark::State& state, const char* name, const std::string& faces)
{
    Scene given;
    given.mesh = torus(state.range(0));
    run(given, "rind.crust", {{"guard", "off"}, {"thickness", "0.001"}});
    Scene scene;
    for (auto _ : state) {
        state.PauseTiming();
        scene = Scene();
        scene = given;
        state.ResumeTiming();
        run(scene, name, {{"faces", faces}});
    }
    state.counters["faces_per_s"] = benchmark::Counter(double(state.range(0)), benchmark::Counter::kIsIterationInvariantRate);
}

void PunchEveryFace(benchmark::State& state) { open_many(state, "rind.punch", "all"); }
void PeelHalf(benchmark::State& state) { open_many(state, "rind.peel", "0-" + std::to_string(state.range(0) / 2)); }

void open_one(benchmark::State& state, const char* command)
{
    Document document(all_operators());
    Model model;
    model.mesh = torus(state.range(0));
    const std::uint32_t faces = model.mesh.face_count();
    document.open(std::move(model));
    document.apply("rind.crust guard=off thickness=0.001");
    std::mt19937 random(1);
    for (auto _ : state) {
        document.apply(command + std::to_string(random() % faces));
        state.PauseTiming();
        document.apply("document.undo");
        state.ResumeTiming();
    }
}

void PunchOneFace(benchmark::State& state) { open_one(state, "rind.punch faces="); }
void PeelOneFace(benchmark::State& state) { open_one(state, "rind.peel faces="); }

void CgalExtrudeMesh(benchmark::State& state)
{
    namespace PMP = CGAL::Polygon_mesh_processing;
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
    const Mesh input = torus(state.range(0), true);
    Surface in, out;
    for (const Point& p : input.positions()) in.add_vertex({p.x, p.y, p.z});
    for (const Face f : input.faces()) {
        std::vector<Surface::Vertex_index> ring;
        for (const Corner c : input.corners(f)) ring.emplace_back(input.vertex(c).index);
        in.add_face(ring);
    }
    const auto normal = in.add_property_map<Surface::Vertex_index, Kernel::Vector_3>("normal").first;
    for (auto _ : state) {
        state.PauseTiming();
        out = Surface();
        state.ResumeTiming();
        PMP::compute_vertex_normals(in, normal);
        const auto points = get(CGAL::vertex_point, out);
        const auto bottom = [&](Surface::Vertex_index v, Surface::Vertex_index w) { put(points, w, get(points, w) - 0.001 * normal[v]); };
        PMP::extrude_mesh(in, out, bottom, [](Surface::Vertex_index, Surface::Vertex_index) {});
    }
    state.counters["faces_per_s"] = benchmark::Counter(double(input.face_count()), benchmark::Counter::kIsIterationInvariantRate);
}

#define SIZES Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond)
BENCHMARK(Crust)->SIZES;
BENCHMARK(CrustUniform)->SIZES;
BENCHMARK(CrustGuarded)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(CgalExtrudeMesh)->SIZES;
BENCHMARK(PunchEveryFace)->SIZES;
BENCHMARK(PeelHalf)->SIZES;
BENCHMARK(PunchOneFace)->SIZES;
BENCHMARK(PeelOneFace)->SIZES;

} // namespace
} // namespace druse

BENCHMARK_MAIN();
