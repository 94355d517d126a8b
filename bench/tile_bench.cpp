// Layered tiles while they are edited: carving a bottom of so many triangles, and one step of a drag: the step before is undone, the command runs with all that
// follows from it, and what a drawing of the tile with 24 neighbours needs is gathered. The same of the tile editor, from the mouse to the picture (Editor…).
// A step is to be done within 16 ms, carving 2 000 triangles within 8 ms and 20 000 within 100 ms.
#include "app/document.h"
#include "app/registry.h"
#include "tile/carve.h"
#include "tile/layered_tile.h"
#include "tile/tile_solid.h"
#include "tile/tile_stack.h"
#include "ui/layout.h"
#include "ui/relief_picture.h"
#include "ui/session.h"
#include "ui/tile_drawing.h"
#include "ui/tile_source.h"
#include "ui/tile_view.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <variant>
#include <vector>

namespace druse {
namespace {

/// An IH79 tile with waves for edges, about that many points inside, and a relief on all of it.
const LayeredTile& tile_with(int points)
{
    static std::map<int, LayeredTile> known;
    if (const auto found = known.find(points); found != known.end()) return found->second;
    TileDesign design;
    design.type = 79;
    design.size = 100;
    design.paths.resize(2);
    const int pieces = std::max(4, static_cast<int>(0.8 * std::sqrt(double(points))));
    for (int i = 1; i < pieces; ++i) {
        const double t = double(i) / pieces;
        design.paths[0].emplace_back(t, 0.08 * std::sin(6 * t));
        if (t < 0.499) design.paths[1].emplace_back(t, 0.08 * std::sin(12 * t));
    }
    LayeredTile bare(design);
    const std::vector<Point2> outline = bare.outline().positions();
    std::mt19937 random(42);
    const auto uniform = [&](double from, double to) { return from + (to - from) * (double(random()) / 4294967296.0); };
    const double apart = 0.9 * std::sqrt(bare.area() / points);
    for (double y = -20; y < 60; y += apart)
        for (double x = -20; x < 120; x += apart) {
            const Point2 p(x + uniform(0, 0.4 * apart), y + uniform(0, 0.4 * apart));
            if (contains(outline, p) && nearest_side(outline, p).distance > 0.3 * apart && std::ssize(design.interior) < points) design.interior.push_back(p);
        }
    design.thickness = 30;
    for (std::size_t i = 0; i < design.interior.size(); ++i) design.heights[PointName::interior(static_cast<int>(i))] = uniform(-2, 2);
    LayeredTile tile(std::move(design));
    tile.set_stack({TileStack::Mode::shift, {50, 50}, 0});
    return known.emplace(points, std::move(tile)).first->second;
}

void count(benchmark::State& state, const LayeredTile& tile)
{
    state.counters["points"] = tile.point_count();
    state.counters["outline"] = tile.outline_count();
    state.counters["triangles"] = double(tile.surface().triangles.size());
}

void Carve(benchmark::State& state)
{
    const LayeredTile& tile = tile_with(static_cast<int>(state.range(0)) / 2);
    const std::vector<Point2> cutter = tile.outline().positions();
    const Isometry below = inverse(stack_motion(tile.design().stack));
    std::size_t carved = 0;
    for (auto _ : state) carved = carve(tile, cutter, below).field.triangles.size();
    count(state, tile);
    state.counters["carved"] = double(carved);
}

void Solid(benchmark::State& state)
{
    const LayeredTile& tile = tile_with(static_cast<int>(state.range(0)) / 2);
    for (auto _ : state) benchmark::DoNotOptimize(make_solid(tile).thinnest.thickness);
    count(state, tile);
}

/// All that a drawing takes from the tile: the points, outlines, lines and triangles of the tile and of the 24 copies nearest to it.
double drawn(const LayeredTile& tile)
{
    FlatBox box;
    for (const OutlinePoint& p : tile.outline().points) box.add(p.position);
    const Point2 middle = 0.5 * (box.min + box.max);
    std::vector<TileCopy> copies = tile.copies_in(box.grown(0.8 * tile.size()));
    const auto away = [&](const TileCopy& copy) { return glm::length(tile.motion(copy)(middle) - middle); };
    std::ranges::sort(copies, {}, away);
    copies.resize(std::min<std::size_t>(copies.size(), 25));
    const auto edges = tile.constrained_edges();
    const std::size_t corners = tile.outline().points.size() + 2 * edges.size() + 3 * tile.surface().triangles.size();
    std::vector<std::array<float, 2>> vertices, places(tile.surface().points.size());
    vertices.reserve(copies.size() * corners);
    for (const TileCopy& copy : copies) {
        const Isometry there = tile.motion(copy);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Point2 p = there(Point2(tile.surface().points[i]));
            places[i] = {static_cast<float>(p.x), static_cast<float>(p.y)};
        }
        for (std::size_t i = 0; i < tile.outline().points.size(); ++i) vertices.push_back(places[i]);
        for (const auto& [a, b] : edges) {
            vertices.push_back(places[static_cast<std::size_t>(a)]);
            vertices.push_back(places[static_cast<std::size_t>(b)]);
        }
        for (const auto& t : tile.surface().triangles)
            for (const std::uint32_t v : t) vertices.push_back(places[v]);
    }
    return vertices.back()[0];
}

/// What makes a tile of about that many points.
std::vector<std::string> commands_for(int points)
{
    std::string legs, hypotenuse;
    for (int i = 1; i < 40; ++i) {
        legs += fmt::format("{}{},{}", i == 1 ? "" : ",", i / 40.0, 0.05 * std::sin(6 * i / 40.0));
        if (i < 20) hypotenuse += fmt::format("{}{},{}", i == 1 ? "" : ",", i / 40.0, 0.05 * std::sin(12 * i / 40.0));
    }
    return {"tile.new type=IH79 size=100", "tile.edge path=0 points=" + legs, "tile.edge path=1 points=" + hypotenuse, "tile.extrude thickness=30",
            fmt::format("tile.refine max_area={}", 1850.0 / points), "tile.height_dome height=3", "tile.stack mode=shift offset=50,50"};
}

Document document_with(int points)
{
    Document document(all_operators());
    for (const std::string& command : commands_for(points)) document.apply(command);
    return document;
}

const LayeredTile& tile_of_document(const Document& document) { return std::get<LayeredTile>(*document.scene().source); }

/// Steps of a drag to and fro, one by one. `command(t)`: for how far it has gone, 0 to 1.
template <class F>
void drag(benchmark::State& state, F&& command)
{
    Document document = document_with(static_cast<int>(state.range(0)));
    count(state, tile_of_document(document));
    std::vector<double> times;
    int k = 0;
    for (auto _ : state) {
        const std::string text = command(tile_of_document(document), (k % 10 < 5 ? k % 5 : 5 - k % 5) / 5.0);
        const auto begin = std::chrono::steady_clock::now();
        if (k++ > 0) document.apply("document.undo");
        document.apply(text);
        benchmark::DoNotOptimize(drawn(tile_of_document(document)));
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    }
    std::ranges::sort(times);
    state.counters["p99_ms"] = times[times.size() * 99 / 100];
}

void DragPathPoint(benchmark::State& state)
{
    drag(state, [](const LayeredTile&, double t) { return fmt::format("tile.edge_move point=e0:20 uv=0.5,{}", 0.0071 + 0.004 * t); });
}

void DragInnerPoint(benchmark::State& state)
{
    Point2 start(0.0);
    drag(state, [&](const LayeredTile& tile, double t) {
        if (start == Point2(0.0)) start = tile.design().interior[100];
        return fmt::format("tile.point_move point=i100 to={},{}", start.x + 0.2 * t, start.y);
    });
}

void DragHeight(benchmark::State& state)
{
    drag(state, [](const LayeredTile&, double t) { return fmt::format("tile.height points=i100,v0 add={}", t); });
}

/// The tile editor without its window: what the mouse does becomes a command that changes the tile, and the plane is drawn anew with all copies that are seen.
/// The graphics card, or what stands for it, is left out.
class EditorDrag {
public:
    explicit EditorDrag(int points) : session_(all_operators()), view_(session_), image_(760, 600)
    {
        ui::set_layout(ui::Layout(1));
        session_.leave_out_sources(); // as the window does
        session_.on_change = [this] { view_.session_changed(); };
        view_.resize(image_.width, image_.height);
        for (const std::string& command : commands_for(points)) run(command);
        view_.frame();
        draw();
    }
    void run(const std::string& command)
    {
        session_.run(command);
        session_.wait();
    }
    void again(const std::string& command)
    {
        session_.run_again(command);
        session_.wait();
    }
    Point2 place_of(const char* name) const { return view_.plane().picture(view_.tile().points[std::size_t(view_.tile().find(name))].at); }
    void press(const Point2& at) { view_.press(pointer(at)); }
    void drag(const Point2& at)
    {
        view_.drag(pointer(at));
        session_.wait();
    }
    void release(const Point2& at) { view_.release(pointer(at)); }
    void draw() { drawing_.draw(view_, true, 1, image_); }
    /// Makes the picture in space anew: while points are raised, at each step; while the plane is dragged, when there is time.
    void follow() { relief_.follow(ui::layered_tile(*session_.scene())); }
    ui::TileView& view() { return view_; }
    const LayeredTile& tile() const { return *ui::layered_tile(*session_.scene()); }

private:
    static ui::Pointer pointer(const Point2& at)
    {
        ui::Pointer p;
        p.x = at.x;
        p.y = at.y;
        p.button = 1;
        return p;
    }

    ui::Session session_;
    ui::TileView view_;
    ui::TileDrawing drawing_;
    ui::ReliefPicture relief_;
    Image image_;
};

/// Times steps of a drag in the editor: step(k), then the drawing.
template <class F>
void time_steps(benchmark::State& state, EditorDrag& editor, F&& step)
{
    count(state, editor.tile());
    std::vector<double> times;
    int k = 0;
    for (auto _ : state) {
        const auto begin = std::chrono::steady_clock::now();
        step(k++);
        editor.draw();
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    }
    std::ranges::sort(times);
    state.counters["median_ms"] = times[times.size() / 2];
    state.counters["p99_ms"] = times[times.size() * 99 / 100];
}

/// Within a few pixels of a place.
Point2 jittered(const Point2& at, int k) { return at + Point2(5 + k % 7, -(k % 5)); }

void EditorDragsPoint(benchmark::State& state, const char* name)
{
    EditorDrag editor(static_cast<int>(state.range(0)));
    const Point2 at = editor.place_of(name);
    editor.press(at);
    time_steps(state, editor, [&](int k) { editor.drag(jittered(at, k)); });
    editor.release(at);
}

void EditorDragsOutline(benchmark::State& state) { EditorDragsPoint(state, "e0:20"); }
void EditorDragsInside(benchmark::State& state) { EditorDragsPoint(state, "i100"); }

void EditorDragsOffset(benchmark::State& state)
{
    EditorDrag editor(static_cast<int>(state.range(0)));
    editor.run("tile.stack mode=free offset=50,50");
    editor.view().set_tool(ui::TileView::Tool::offset);
    const Point2 at(380, 300);
    editor.press(at);
    time_steps(state, editor, [&](int k) { editor.drag(jittered(at, k)); });
    editor.release(at);
}

void EditorRaisesPoints(benchmark::State& state)
{
    EditorDrag editor(static_cast<int>(state.range(0)));
    editor.run("tile.height points=i100,v0 add=0.5");
    time_steps(state, editor, [&](int k) {
        editor.again(fmt::format("tile.height points=i100,v0 add={}", 0.1 * (k % 10)));
        editor.follow();
    });
}

BENCHMARK(Carve)->Arg(2'000)->Arg(20'000)->Unit(benchmark::kMillisecond);
BENCHMARK(Solid)->Arg(2'000)->Arg(20'000)->Unit(benchmark::kMillisecond);
BENCHMARK(DragPathPoint)->Arg(2'000)->Arg(5'000)->Unit(benchmark::kMillisecond);
BENCHMARK(DragInnerPoint)->Arg(2'000)->Arg(5'000)->Unit(benchmark::kMillisecond);
BENCHMARK(DragHeight)->Arg(2'000)->Arg(5'000)->Unit(benchmark::kMillisecond);
BENCHMARK(EditorDragsOutline)->Arg(2'000)->Arg(5'000)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(EditorDragsInside)->Arg(2'000)->Arg(5'000)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(EditorRaisesPoints)->Arg(2'000)->Arg(5'000)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(EditorDragsOffset)->Arg(2'000)->Arg(5'000)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

} // namespace
} // namespace druse

BENCHMARK_MAIN();
