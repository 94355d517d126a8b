// Cells while they are edited: one step of a drag as the cell editor makes it. The step before is undone, the command runs with all that follows from it, and the picture of
// the cell with its neighbours (12 or 14) follows. A step is to be done within 16 ms.
#include "app/document.h"
#include "app/registry.h"
#include "ui/cell_picture.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <variant>
#include <vector>

namespace druse::ui {
namespace {

const CellTile& cell_in(const Document& document) { return std::get<CellTile>(*document.scene().source); }

/// A document with a cell of about that many orbits of points.
Document document_with_cell(const char* kind, int points)
{
    Document document(all_operators());
    document.apply(fmt::format("cell.new cell={} size=20", kind));
    for (int edge = 0; edge < std::ssize(cell_in(document).cell().edges); ++edge)
        for (const double t : {0.25, 0.5, 0.75}) document.apply(fmt::format("cell.edge_add edge={} t={}", edge, t));
    const int panes = cell_in(document).pane_count();
    for (int pane = 0; pane < panes; ++pane) {
        const CellPane& its = cell_in(document).cell().panes[std::size_t(pane)];
        double area = 0;
        for (std::size_t i = 0; i < its.outline.size(); ++i) {
            const Point2 &a = its.outline[i], &b = its.outline[(i + 1) % its.outline.size()];
            area += 0.5 * (a.x * b.y - a.y * b.x);
        }
        document.apply(fmt::format("cell.refine pane={} max_area={}", pane, 0.78 * area * panes / points));
    }
    return document;
}

/// Steps of a drag to and fro, one by one. `command(t)`: for how far it has gone, 0 to 1.
template <class F>
void drag_cell(benchmark::State& state, const char* kind, bool shaped, F&& command)
{
    Document document = document_with_cell(kind, static_cast<int>(state.range(0)));
    if (shaped) document.apply("cell.shape");
    CellPicture picture;
    picture.set_neighbours(0.7, 1);
    picture.follow(&cell_in(document), 0);
    std::vector<double> times;
    int k = 0;
    for (auto _ : state) {
        const std::string text = command(cell_in(document), (k % 10 < 5 ? k % 5 : 5 - k % 5) / 5.0);
        const auto begin = std::chrono::steady_clock::now();
        if (k++ > 0) document.apply("document.undo");
        document.apply(text);
        picture.follow(&cell_in(document), 0);
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    }
    std::ranges::sort(times);
    state.counters["p99_ms"] = times[times.size() * 99 / 100];
    state.counters["orbits"] = cell_in(document).point_count();
    state.counters["triangles"] = double(picture.solid().triangles.size());
    state.counters["drawn"] = double(picture.lists().triangle_count() * (1 + picture.lists().copies().size()));
}

void MovePoint(benchmark::State& state, const char* kind)
{
    drag_cell(state, kind, true, [](const CellTile&, double t) { return fmt::format("cell.move points=p0:i100,c0 along=radial amount={}", 0.1 * t + 0.01); });
}

void MoveAllPoints(benchmark::State& state, const char* kind)
{
    drag_cell(state, kind, true, [](const CellTile&, double t) { return fmt::format("cell.move points=interior along=x amount={}", 0.1 * t + 0.01); });
}

void Skew(benchmark::State& state, const char* kind)
{
    drag_cell(state, kind, true, [](const CellTile&, double t) { return fmt::format("cell.skew entry=xy value={}", 0.1 * t + 0.01); });
}

void DragInPane(benchmark::State& state, const char* kind)
{
    Point2 start(0.0);
    drag_cell(state, kind, false, [&](const CellTile& cell, double t) {
        if (start == Point2(0.0)) start = cell.interior(0)[100];
        return fmt::format("cell.point_move point=p0:i100 to={},{}", start.x + 0.02 * t, start.y);
    });
}

/// All triangles of a pane are others, so the picture is made anew.
void AddPoint(benchmark::State& state, const char* kind)
{
    drag_cell(state, kind, false, [](const CellTile&, double t) { return fmt::format("cell.point_add pane=0 at={},0.1", t); });
}

BENCHMARK_CAPTURE(MovePoint, fcc, "fcc")->Arg(5'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(MovePoint, bcc, "bcc")->Arg(5'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(MoveAllPoints, fcc, "fcc")->Arg(5'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Skew, fcc, "fcc")->Arg(5'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(AddPoint, fcc, "fcc")->Arg(5'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(DragInPane, fcc, "fcc")->Arg(5'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(DragInPane, bcc, "bcc")->Arg(5'000)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace druse::ui

BENCHMARK_MAIN();
