// Panes beside CGAL's constrained Delaunay triangulation, with the same points in the same run: --benchmark_enable_random_interleaving=true. Points of a
// jittered grid in random order; links join one in ten to the next of its row, long links cross each other. Batches are timed from points in memory; latencies
// are percentiles of single edits, with what makes them whole or not at all, on a pane of that many points.
#include "pane/pane.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <vector>

namespace druse {
namespace {

struct Input {
    double size = 0;
    std::vector<Point2> points;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> links, long_links;
};

const Input& input(std::int64_t count)
{
    static std::map<std::int64_t, Input> known;
    Input& in = known[count];
    if (!in.points.empty()) return in;
    const auto k = static_cast<std::uint32_t>(std::lround(std::sqrt(double(count))));
    in.size = k;
    std::mt19937_64 random(42);
    std::uniform_real_distribution<double> jitter(0.001, 0.999);
    std::vector<std::uint32_t> id(std::size_t(k) * k);
    for (std::uint32_t i = 0; i < id.size(); ++i) id[i] = i;
    std::shuffle(id.begin(), id.end(), random);
    in.points.resize(id.size());
    for (std::uint32_t y = 0; y < k; ++y)
        for (std::uint32_t x = 0; x < k; ++x) in.points[id[std::size_t(y) * k + x]] = {x + jitter(random), y + jitter(random)};
    for (std::uint32_t y = 0; y < k; ++y)
        for (std::uint32_t x = 0; x + 1 < k; ++x)
            if (jitter(random) < 0.1) in.links.emplace_back(id[std::size_t(y) * k + x], id[std::size_t(y) * k + x + 1]);
    in.long_links = in.links;
    for (std::uint32_t i = 0; i < k / 10; ++i)
        in.long_links.emplace_back(std::uint32_t(random() % in.points.size()), std::uint32_t(random() % in.points.size()));
    return in;
}

Pane pane_of(const Input& in, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& links)
{
    Pane pane(std::vector<Point2>{{0, 0}, {in.size, 0}, {in.size, in.size}, {0, in.size}}, {}, {0.0, 1e-9});
    const auto ids = pane.add_all(in.points);
    if (links.empty()) return pane;
    std::vector<std::pair<PointId, PointId>> ends;
    ends.reserve(links.size());
    for (const auto& [a, b] : links) ends.emplace_back(ids[a], ids[b]);
    pane.constrain_all(ends);
    return pane;
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Data = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data, CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Crossing = CGAL::Constrained_triangulation_plus_2<CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data, CGAL::Exact_predicates_tag>>;

std::vector<Kernel::Point_2> cgal_points(const Input& in)
{
    std::vector<Kernel::Point_2> points;
    for (const Point2& p : in.points) points.emplace_back(p.x, p.y);
    return points;
}

// --- batches --------------------------------------------------------------------------------------------------------------------------

void Points(benchmark::State& state)
{
    const Input& in = input(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(pane_of(in, {}).point_count());
}
void Links(benchmark::State& state)
{
    const Input& in = input(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(pane_of(in, in.links).point_count());
}
void LongLinks(benchmark::State& state)
{
    const Input& in = input(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(pane_of(in, in.long_links).point_count());
}
void PointsCgal(benchmark::State& state)
{
    const auto points = cgal_points(input(state.range(0)));
    for (auto _ : state) {
        Cdt t;
        t.insert(points.begin(), points.end());
        benchmark::DoNotOptimize(t.number_of_faces());
    }
}
template <class T>
void insert_links(benchmark::State& state, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& links)
{
    const auto points = cgal_points(input(state.range(0)));
    const std::vector<std::pair<std::size_t, std::size_t>> ends(links.begin(), links.end());
    for (auto _ : state) {
        T t;
        t.insert_constraints(points.begin(), points.end(), ends.begin(), ends.end());
        benchmark::DoNotOptimize(t.number_of_faces());
    }
}
void LinksCgal(benchmark::State& state) { insert_links<Cdt>(state, input(state.range(0)).links); }
void LongLinksCgal(benchmark::State& state) { insert_links<Crossing>(state, input(state.range(0)).long_links); }

/// Degenerate shapes: a line, a circle, a grid and a spiral, beside random places.
void Shape(benchmark::State& state)
{
    const auto count = static_cast<int>(state.range(1));
    std::vector<Point2> points;
    const int row = static_cast<int>(std::sqrt(count));
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> number(0.01, 0.99);
    for (int i = 0; i < count; ++i) {
        const double t = double(i) / count, turn = 6.283185307179586 * t;
        switch (state.range(0)) {
        case 0: points.emplace_back(number(random), number(random)); break;
        case 1: points.emplace_back(0.1 + 0.8 * t, 0.5); break;
        case 2: points.emplace_back(0.5 + 0.4 * std::cos(turn), 0.5 + 0.4 * std::sin(turn)); break;
        case 3: points.emplace_back(0.1 + 0.8 * (i % row) / row, 0.1 + 0.8 * (i / row) / row); break;
        default: points.emplace_back(0.5 + 0.4 * t * std::cos(300 * turn), 0.5 + 0.4 * t * std::sin(300 * turn)); break;
        }
    }
    for (auto _ : state) {
        Pane pane(std::vector<Point2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}, {0.0, 1e-12});
        pane.add_all(points);
    }
}

// --- single edits ---------------------------------------------------------------------------------------------------------------------

class Latency {
public:
    template <class F>
    void time(F&& f)
    {
        const auto start = std::chrono::steady_clock::now();
        f();
        times_.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
    }
    void report(benchmark::State& state)
    {
        std::sort(times_.begin(), times_.end());
        state.counters["p50_us"] = times_[times_.size() / 2];
        state.counters["p99_us"] = times_[times_.size() * 99 / 100];
    }

private:
    std::vector<double> times_;
};

constexpr int edits = 2000;

Point2 wrapped(const Point2& p, double size) { return {p.x - size * std::floor(p.x / size), p.y - size * std::floor(p.y / size)}; }

/// Adds points anywhere or, `near`, each close to the one before; moves each a little; removes them.
void edit(benchmark::State& state, bool near, int which)
{
    const Input& in = input(state.range(0));
    static std::map<std::int64_t, std::unique_ptr<Pane>> panes;
    auto& kept = panes[state.range(0)];
    if (kept == nullptr) kept = std::make_unique<Pane>(pane_of(in, {}));
    Pane& pane = *kept;
    Latency latency;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> number(0.01, in.size - 0.01), step(-1, 1);
    pane.remove(pane.add({number(random), number(random)}));
    for (auto _ : state) {
        std::vector<PointId> made;
        Point2 p(in.size / 2);
        for (int i = 0; i < edits; ++i) {
            p = near ? wrapped(p + Point2(step(random), step(random)), in.size) : Point2(number(random), number(random));
            const auto add = [&] { made.push_back(pane.add(p)); };
            if (which == 0) latency.time(add);
            else add();
        }
        for (const PointId q : made) {
            const Point2 to = glm::clamp(pane.position(q) + Point2(0.1, 0.05), Point2(0.01), Point2(in.size - 0.01));
            if (which == 1) latency.time([&] { pane.move(q, to); });
        }
        for (const PointId q : made) {
            if (!pane.exists(q)) continue;
            if (which == 2) latency.time([&] { pane.remove(q); });
            else pane.remove(q);
        }
    }
    latency.report(state);
}
void AddAnywhere(benchmark::State& state) { edit(state, false, 0); }
void AddNear(benchmark::State& state) { edit(state, true, 0); }
void Move(benchmark::State& state) { edit(state, false, 1); }
void Remove(benchmark::State& state) { edit(state, false, 2); }

void edit_cgal(benchmark::State& state, bool near, int which)
{
    const Input& in = input(state.range(0));
    static std::map<std::int64_t, std::unique_ptr<Cdt>> known;
    auto& kept = known[state.range(0)];
    if (kept == nullptr) {
        const auto points = cgal_points(in);
        kept = std::make_unique<Cdt>();
        kept->insert(points.begin(), points.end());
    }
    Cdt& t = *kept;
    Latency latency;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> number(0.01, in.size - 0.01), step(-1, 1);
    for (auto _ : state) {
        std::vector<Cdt::Vertex_handle> made;
        Point2 p(in.size / 2);
        for (int i = 0; i < edits; ++i) {
            p = near ? wrapped(p + Point2(step(random), step(random)), in.size) : Point2(number(random), number(random));
            const auto add = [&] { made.push_back(near && !made.empty() ? t.insert({p.x, p.y}, made.back()->face()) : t.insert({p.x, p.y})); };
            if (which == 0) latency.time(add);
            else add();
        }
        for (auto& v : made) {
            if (which != 1) break;
            const Kernel::Point_2 to(v->point().x() + 0.1, v->point().y() + 0.05);
            latency.time([&] {
                auto around = t.incident_vertices(v);
                while (t.is_infinite(around)) ++around;
                const Cdt::Vertex_handle hint = around;
                t.remove(v);
                v = t.insert(to, hint->face());
            });
        }
        for (const auto& v : made) {
            if (which == 2) latency.time([&] { t.remove(v); });
            else t.remove(v);
        }
    }
    latency.report(state);
}
void AddAnywhereCgal(benchmark::State& state) { edit_cgal(state, false, 0); }
void AddNearCgal(benchmark::State& state) { edit_cgal(state, true, 0); }
void MoveCgal(benchmark::State& state) { edit_cgal(state, false, 1); }
void RemoveCgal(benchmark::State& state) { edit_cgal(state, false, 2); }

/// A drag of a boundary point through the inside of a pane with 40 boundary points, which floods it at each step that leaves the star.
void DragBoundary(benchmark::State& state)
{
    const Input& in = input(state.range(0));
    std::vector<Point2> loop;
    for (int i = 0; i < 40; ++i) loop.push_back(in.size * (Point2(0.5) + 0.9 * Point2(std::cos(i * 0.15707963267948966), std::sin(i * 0.15707963267948966))));
    Pane pane(loop, {}, {0.0, 1e-9});
    pane.add_all(in.points);
    Latency latency;
    for (auto _ : state)
        for (int i = 0; i < 100; ++i) latency.time([&] { pane.move(PointId(0), in.size * Point2(1.41 + 0.005 * (i % 10), 0.5 + 0.01 * (i % 7))); });
    latency.report(state);
}

#define PEERS(name, ...)            \
    BENCHMARK(name)->__VA_ARGS__;   \
    BENCHMARK(name##Cgal)->__VA_ARGS__

PEERS(Points, RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMillisecond));
PEERS(Links, RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMillisecond));
PEERS(LongLinks, RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMillisecond));
PEERS(AddAnywhere, RangeMultiplier(10)->Range(1000, 1000000)->Iterations(3)->Unit(benchmark::kMillisecond));
PEERS(AddNear, RangeMultiplier(10)->Range(1000, 1000000)->Iterations(3)->Unit(benchmark::kMillisecond));
PEERS(Move, RangeMultiplier(10)->Range(1000, 1000000)->Iterations(3)->Unit(benchmark::kMillisecond));
PEERS(Remove, RangeMultiplier(10)->Range(1000, 1000000)->Iterations(3)->Unit(benchmark::kMillisecond));
BENCHMARK(DragBoundary)->RangeMultiplier(10)->Range(1000, 100000)->Iterations(3)->Unit(benchmark::kMillisecond);
BENCHMARK(Shape)->ArgsProduct({{0, 1, 2, 3, 4}, {100000}})->Unit(benchmark::kMillisecond);

} // namespace
} // namespace druse

BENCHMARK_MAIN();
