// Cells while they are edited: one step of each kind through a document, the step before undone, with what a drawing of the cell and the 12 or 14 that share a pane with it
// needs; and what is asked of a cell before it is printed. A step of a cell of 5 000 points is to be done within 16 ms, the test of 20 000 triangles for crossings within 200 ms.
#include "app/document.h"
#include "app/registry.h"
#include "cell/cell_assembly.h"
#include "cell/cell_check.h"
#include "cell/freedom.h"
#include "dlfl/self_intersections.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace druse {
namespace {

/// A cell of size 40 with about that many orbits of points, all on slow waves that have the period of its lattice, so that it does not meet itself.
const CellTile& cell_with(CellKind kind, int points)
{
    static std::map<std::pair<CellKind, int>, CellTile> known;
    if (const auto found = known.find({kind, points}); found != known.end()) return found->second;
    CellTile cell = CellTile::of_kind(kind, 40);
    double area = 0;
    for (const CellPane& pane : cell.cell().panes)
        for (std::size_t k = 0; k < pane.outline.size(); ++k) {
            const Point2 &a = pane.outline[k], &b = pane.outline[(k + 1) % pane.outline.size()];
            area += 0.5 * (a.x * b.y - a.y * b.x);
        }
    const double apart = std::sqrt(area / points);
    CellDesign design = cell.design();
    for (std::size_t e = 0; e < design.edges.size(); ++e) {
        const Parallelohedron::Edge& edge = cell.cell().edges[e];
        const int parts = std::max(1, static_cast<int>(glm::length(cell.cell().corner(edge.to) - cell.cell().corner(edge.from)) / apart));
        for (int i = 1; i < parts; ++i) design.edges[e].push_back(double(i) / parts);
    }
    for (std::size_t p = 0; p < design.panes.size(); ++p) {
        const std::vector<Point2>& outline = cell.cell().panes[p].outline;
        double wide = 0;
        for (const Point2& corner : outline) wide = std::max(wide, glm::length(corner));
        int row = 0;
        for (double y = -wide; y < wide; y += apart * std::sqrt(0.75), ++row)
            for (double x = -wide + 0.5 * apart * (row % 2); x < wide; x += apart) {
                const Point2 at(x, y);
                bool inside = true;
                for (std::size_t k = 0; k < outline.size() && inside; ++k) {
                    const Point2 side = outline[(k + 1) % outline.size()] - outline[k], to = at - outline[k];
                    inside = side.x * to.y - side.y * to.x > 0.5 * apart * glm::length(side);
                }
                if (inside) design.panes[p].points.push_back(at);
            }
    }
    CellTile shaped(design);
    shaped.shape();
    std::array<Vector, 3> waves; // ones that all steps of the lattice leave alike
    for (std::size_t k = 0; k < 3; ++k)
        waves[k] = 2 * std::acos(-1.0) / shaped.cell().volume() * glm::cross(shaped.cell().lattice[(k + 1) % 3], shaped.cell().lattice[(k + 2) % 3]);
    for (int i = 0; i < shaped.point_count(); ++i) {
        const Point p = shaped.base(i);
        shaped.move(std::array{i}, Vector(std::sin(glm::dot(waves[0], p)), std::sin(glm::dot(waves[1], p)), std::sin(glm::dot(waves[2], p))));
    }
    return known.emplace(std::pair(kind, points), std::move(shaped)).first->second;
}

/// All that a drawing takes from the cell: corners and normals of the triangles of the cell and of those around it, each scaled about its centre.
double drawn(const CellTile& cell)
{
    const CellSolid solid = make_solid(cell);
    const std::vector<LatticeStep> around = cells_around(cell.cell(), 1);
    const Point centre = centre_of_mass(solid);
    std::vector<std::array<float, 6>> vertices;
    vertices.reserve(around.size() * solid.triangles.size() * 3);
    for (const LatticeStep& step : around) {
        const Vector shift = cell.world(cell.cell().at(step)) + 0.1 * centre;
        for (const auto& t : solid.triangles) {
            const Vector normal = direction(glm::cross(solid.points[t[1]] - solid.points[t[0]], solid.points[t[2]] - solid.points[t[0]]));
            for (const std::uint32_t v : t) {
                const Point p = 0.9 * solid.points[v] + shift;
                vertices.push_back({float(p.x), float(p.y), float(p.z), float(normal.x), float(normal.y), float(normal.z)});
            }
        }
    }
    return vertices.back()[0];
}

void count(benchmark::State& state, const CellTile& cell)
{
    state.counters["points"] = cell.point_count();
    double triangles = 0;
    for (int p = 0; p < cell.pane_count(); ++p) triangles += 2.0 * double(cell.mesh(p).triangles.size());
    state.counters["triangles"] = triangles;
}

/// Steps of a drag to and fro, one by one. `command(cell, t)`: for how far it has gone, 0 to 1.
template <class F>
void drag(benchmark::State& state, bool flat, F&& command)
{
    Document document(all_operators());
    Model model;
    model.cell = cell_with(static_cast<CellKind>(state.range(0)), static_cast<int>(state.range(1)));
    document.open(std::move(model));
    if (flat) document.apply("cell.rollback pane=2");
    const auto cell = [&]() -> const CellTile& { return std::get<CellTile>(*document.scene().source); };
    count(state, cell());
    std::vector<double> times;
    int k = 0;
    for (auto _ : state) {
        const std::string text = command(cell(), (k % 10 < 5 ? k % 5 : 5 - k % 5) / 5.0);
        const auto begin = std::chrono::steady_clock::now();
        if (k++ > 0) document.apply("document.undo");
        document.apply(text);
        benchmark::DoNotOptimize(drawn(cell()));
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    }
    std::ranges::sort(times);
    state.counters["p99_ms"] = times[times.size() * 99 / 100];
}

void DragPoint(benchmark::State& state)
{
    drag(state, false, [](const CellTile&, double t) { return fmt::format("cell.move points=p2:i100,c0,x1:3 by={},0,0.1", 0.1 + 0.2 * t); });
}

void DragAllPoints(benchmark::State& state)
{
    drag(state, false, [](const CellTile&, double t) { return fmt::format("cell.move points=all by={},0,0.1", 0.1 + 0.2 * t); });
}

void Skew(benchmark::State& state)
{
    drag(state, false, [](const CellTile&, double t) { return fmt::format("cell.skew entry=xy value={}", 0.2 * t); });
}

void SplitTriangle(benchmark::State& state)
{
    drag(state, false, [](const CellTile&, double t) { return fmt::format("cell.split face=p2:{} at=0.2,0.3,0.5", 200 + int(10 * t)); });
}

void SplitSide(benchmark::State& state)
{
    drag(state, false, [](const CellTile&, double t) { return fmt::format("cell.split_edge pane=2 edge=e1:1,e1:2 t={}", 0.3 + 0.4 * t); });
}

void Flip(benchmark::State& state)
{
    drag(state, false, [](const CellTile& cell, double) {
        const PaneMesh::Corners& corners = cell.mesh(2).triangles[400];
        return fmt::format("cell.flip pane=2 edge={},{}", cell.pane_name(2, corners[0]).text(), cell.pane_name(2, corners[1]).text());
    });
}

void RollBack(benchmark::State& state)
{
    drag(state, false, [](const CellTile&, double) { return std::string("cell.rollback pane=2"); });
}

void AddPoint(benchmark::State& state)
{
    drag(state, true, [](const CellTile& cell, double t) {
        const Point2 at = cell.interior(2)[100];
        return fmt::format("cell.point_add pane=2 at={},{}", at.x + 0.2 + 0.1 * t, at.y + 0.15);
    });
}

void DragInPane(benchmark::State& state)
{
    Point2 start(0.0);
    drag(state, true, [&](const CellTile& cell, double t) {
        if (start == Point2(0.0)) start = cell.interior(2)[100];
        return fmt::format("cell.point_move point=p2:i100 to={},{}", start.x + 0.2 * t, start.y + 0.1);
    });
}

/// Whether a cell of so many triangles meets itself, as the window asks after an edit.
void Crossings(benchmark::State& state)
{
    const CellTile& cell = cell_with(static_cast<CellKind>(state.range(0)), static_cast<int>(state.range(1)) / 4);
    Progress progress;
    for (auto _ : state) {
        MeshBuilder builder;
        add_solid(builder, make_solid(cell), std::array{0});
        benchmark::DoNotOptimize(self_intersections(builder.build(), progress).pairs);
    }
    count(state, cell);
}

void Check(benchmark::State& state)
{
    const CellTile& cell = cell_with(static_cast<CellKind>(state.range(0)), static_cast<int>(state.range(1)) / 4);
    Progress progress;
    std::size_t faults = 0;
    for (auto _ : state) faults = check(cell, {.clearance = 0.2}, progress).faults.size();
    count(state, cell);
    state.counters["faults"] = double(faults);
}

void FreeDirections(benchmark::State& state)
{
    const CellTile& cell = cell_with(static_cast<CellKind>(state.range(0)), static_cast<int>(state.range(1)) / 4);
    Progress progress;
    for (auto _ : state) benchmark::DoNotOptimize(free_directions(cell, make_solid(cell), progress).size());
    count(state, cell);
}

constexpr auto bcc = static_cast<std::int64_t>(CellKind::bcc), fcc = static_cast<std::int64_t>(CellKind::fcc);

void edits(benchmark::internal::Benchmark* b) { b->Args({bcc, 5'000})->Args({fcc, 5'000})->Unit(benchmark::kMillisecond); }
void questions(benchmark::internal::Benchmark* b) { b->Args({bcc, 20'000})->Args({fcc, 20'000})->Unit(benchmark::kMillisecond); }

BENCHMARK(DragPoint)->Apply(edits);
BENCHMARK(DragAllPoints)->Apply(edits);
BENCHMARK(Skew)->Apply(edits);
BENCHMARK(SplitTriangle)->Apply(edits);
BENCHMARK(SplitSide)->Apply(edits);
BENCHMARK(Flip)->Apply(edits);
BENCHMARK(RollBack)->Apply(edits);
BENCHMARK(AddPoint)->Apply(edits);
BENCHMARK(DragInPane)->Apply(edits);
BENCHMARK(Crossings)->Apply(questions);
BENCHMARK(FreeDirections)->Apply(questions);
BENCHMARK(Check)->Apply(questions);

} // namespace
} // namespace druse

BENCHMARK_MAIN();
