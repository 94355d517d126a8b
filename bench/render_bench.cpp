// Frames, uploads and picks off screen, at 1280x800. Each frame turns the camera a little and ends in glFinish.
#include "dlfl/mesh_builder.h"
#include "render/draw_lists.h"
#include "render/offscreen_context.h"
#include "render/picking.h"
#include "render/renderer.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <map>

namespace {

using namespace druse;

/// An octahedron with n² triangles a side, blown up to a unit sphere, row by row: the mesh of the rendering floor.
Mesh triangle_sphere(int n)
{
    MeshBuilder builder;
    std::map<std::array<int, 3>, std::uint32_t> known;
    const auto vertex = [&](int x, int y, int z) {
        const auto [found, fresh] = known.try_emplace({x, y, z}, builder.vertex_count());
        if (fresh) builder.add_vertex(unit(Point(x, y, z)));
        return found->second;
    };
    for (int side = 0; side < 8; ++side) {
        const int sx = side & 1 ? -1 : 1, sy = side & 2 ? -1 : 1, sz = side & 4 ? -1 : 1;
        const auto at = [&](int i, int j) { return vertex(sx * (n - i), sy * (i - j), sz * j); };
        const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            if (sx * sy * sz < 0) std::swap(b, c);
            builder.add_face(std::array{a, b, c}, 1 + side);
        };
        for (int i = 0; i < n; ++i)
            for (int j = 0; j <= i; ++j) {
                triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
                if (j < i) triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
            }
    }
    return builder.build();
}

Mesh quad_torus(int n)
{
    MeshBuilder builder;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double u = 2 * M_PI * i / n, v = 2 * M_PI * j / n;
            builder.add_vertex({(1 + 0.4 * std::cos(v)) * std::cos(u), (1 + 0.4 * std::cos(v)) * std::sin(u), 0.4 * std::sin(v)});
        }
    const auto at = [&](int i, int j) { return std::uint32_t((i % n) * n + j % n); };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) builder.add_face(std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, i % 7);
    return builder.build();
}

Colour colour(int group)
{
    return colour_from_hsv(0.618 * group, 0.62, 0.93);
}

struct Scene {
    Mesh mesh;
    DrawLists lists;
    Camera camera;
    explicit Scene(Mesh m) : mesh(std::move(m)), lists(mesh, colour)
    {
        camera.resize(1280, 800);
        camera.fit(lists.bounds());
    }
};

/// `rows`² · 8 triangles; 112 → 100 352, 354 → 1 002 528.
Scene& sphere(int rows)
{
    static std::map<int, Scene> scenes;
    const auto found = scenes.find(rows);
    return found != scenes.end() ? found->second : scenes.emplace(rows, triangle_sphere(rows)).first->second;
}

Renderer& renderer()
{
    static OffscreenContext context;
    static Renderer r(context.loader());
    return r;
}

void draw_frames(benchmark::State& state, Scene& scene, const Style& style, int samples)
{
    Renderer& r = renderer();
    const auto frame = [&] {
        scene.camera.orbit(5.7, 0);
        r.draw(scene.lists, scene.camera, style, {}, samples);
        r.finish();
    };
    for (int i = 0; i < 3; ++i) frame(); // shaders are compiled, buffers filled
    for (auto _ : state) frame();
    state.counters["triangles"] = scene.lists.triangle_count();
}

void frame_faces(benchmark::State& state)
{
    Style style;
    style.edges = false;
    draw_frames(state, sphere(int(state.range(0))), style, 0);
}
BENCHMARK(frame_faces)->Arg(112)->Arg(354)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void frame_faces_and_edges(benchmark::State& state)
{
    Style style;
    style.fade_edges = false;
    draw_frames(state, sphere(int(state.range(0))), style, 0);
}
BENCHMARK(frame_faces_and_edges)->Arg(112)->Arg(354)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void frame_faces_and_gl_lines(benchmark::State& state)
{
    Style style;
    style.fade_edges = false;
    style.edge_method = Style::EdgeMethod::lines;
    draw_frames(state, sphere(int(state.range(0))), style, 0);
}
BENCHMARK(frame_faces_and_gl_lines)->Arg(112)->Arg(354)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void frame_with_4_samples(benchmark::State& state)
{
    draw_frames(state, sphere(int(state.range(0))), {}, 4);
}
BENCHMARK(frame_with_4_samples)->Arg(112)->Arg(354)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

/// The pointer moves over the mesh with a face pressed: pick, outline, no other change.
void frame_highlight_only(benchmark::State& state)
{
    Scene& scene = sphere(int(state.range(0)));
    Renderer& r = renderer();
    Overlay overlay;
    double x = 500;
    for (auto _ : state) {
        x = x < 780 ? x + 1 : 500;
        overlay.pressed.clear();
        if (const auto hit = pick_face(scene.lists, scene.camera.ray(x, 400))) overlay.pressed.push_back(hit->face);
        r.draw(scene.lists, scene.camera, {}, overlay, 0);
        r.finish();
    }
}
BENCHMARK(frame_highlight_only)->Arg(112)->Arg(354)->Unit(benchmark::kMillisecond)->UseRealTime();

void build_lists(benchmark::State& state)
{
    Scene& scene = sphere(int(state.range(0)));
    DrawLists lists;
    for (auto _ : state) lists.build(scene.mesh, colour);
}
BENCHMARK(build_lists)->Arg(112)->Arg(354)->Unit(benchmark::kMillisecond);

/// From a changed mesh to a finished first frame when everything is taken anew.
void rebuild_and_draw(benchmark::State& state)
{
    Scene& scene = sphere(int(state.range(0)));
    Renderer& r = renderer();
    DrawLists lists;
    for (auto _ : state) {
        lists.build(scene.mesh, colour);
        r.draw(lists, scene.camera, {}, {}, 0);
        r.finish();
    }
}
BENCHMARK(rebuild_and_draw)->Arg(112)->Arg(354)->Unit(benchmark::kMillisecond)->UseRealTime();

/// One face of a million quads is split by an edge, and the edge taken away again, until the lists are ready to be drawn.
void follow_one_face(benchmark::State& state)
{
    Mesh mesh = quad_torus(int(state.range(0)));
    DrawLists lists(mesh, colour);
    bool split = false;
    for (auto _ : state) {
        state.PauseTiming();
        mesh.begin_change();
        if (!split)
            mesh.insert_edge(mesh.corner(Face(7)), mesh.corner(Face(7), 2));
        else
            mesh.delete_edge(Edge(mesh.edge_limit() - 1));
        split = !split;
        mesh.compact();
        const MeshChange change = mesh.end_change();
        state.ResumeTiming();
        lists.update(mesh, difference(mesh, change), colour);
    }
}
BENCHMARK(follow_one_face)->Arg(1000)->Unit(benchmark::kMillisecond)->Iterations(200); // the untimed part is longer

void pick(benchmark::State& state)
{
    Scene& scene = sphere(int(state.range(0)));
    double x = 450;
    for (auto _ : state) {
        x = x < 830 ? x + 1.7 : 450;
        benchmark::DoNotOptimize(pick_face(scene.lists, scene.camera.ray(x, 380.5)));
    }
}
BENCHMARK(pick)->Arg(112)->Arg(354)->Unit(benchmark::kMicrosecond);

} // namespace

BENCHMARK_MAIN();
