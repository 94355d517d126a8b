// One click on a large mesh: an extrusion of one face through Document::apply, which runs, checks and commits it, and through a
// session, which follows it in what it shows as well. Sizes are numbers of quads. Undoing it is not timed.
#include "app/document.h"
#include "app/registry.h"
#include "ui/session.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <string>

namespace druse::ui {
namespace {

std::string torus(benchmark::State& state)
{
    const int n = int(std::lround(std::sqrt(double(state.range(0)))));
    return "make.torus nu=" + std::to_string(n) + " nv=" + std::to_string(n);
}

std::string extrusion(std::uint32_t face) { return "extrude.dodecahedral faces=" + std::to_string(face); }

void CommandOnOneFace(benchmark::State& state)
{
    Document document(all_operators());
    document.apply(torus(state));
    const std::uint32_t faces = document.scene().mesh.face_count();
    std::mt19937 random(1);
    for (auto _ : state) {
        document.apply(extrusion(random() % faces));
        state.PauseTiming();
        document.apply("document.undo");
        state.ResumeTiming();
    }
}

void ClickOnOneFace(benchmark::State& state)
{
    Session session(all_operators());
    session.run(torus(state));
    session.wait();
    session.run("select.faces faces=none"); // a new shape is selected as a whole
    session.wait();
    const std::uint32_t faces = session.display().counts.faces;
    session.choose(&all_operators().get("extrude.dodecahedral"));
    std::mt19937 random(1);
    for (auto _ : state) {
        session.apply_chosen({{"faces", std::to_string(random() % faces)}});
        session.wait();
        state.PauseTiming();
        session.undo();
        session.wait();
        state.ResumeTiming();
    }
}

// A slider that is moved after a click: the step is taken back and made again.
void AdjustOneFace(benchmark::State& state)
{
    Session session(all_operators());
    session.run(torus(state));
    session.wait();
    session.choose(&all_operators().get("extrude.dodecahedral"));
    session.apply_chosen({{"faces", "0"}});
    session.wait();
    int step = 0;
    for (auto _ : state) {
        session.set("angle", std::to_string(90 + ++step % 50));
        session.wait();
    }
}

#define THREE_SIZES Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond)->UseRealTime()
BENCHMARK(CommandOnOneFace)->THREE_SIZES;
BENCHMARK(ClickOnOneFace)->THREE_SIZES;
BENCHMARK(AdjustOneFace)->THREE_SIZES;

} // namespace
} // namespace druse::ui

BENCHMARK_MAIN();
