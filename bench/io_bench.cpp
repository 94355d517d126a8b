// Reading and writing files: a coloured OBJ of quads, with all connectivity and groups, and binary STL of twice as many triangles.
// A file may be named instead of the torus that is made here: io_bench FILE.obj. Times are processor times; files lie in memory after the
// first reading, so the disk is not measured.
#include "dlfl/group_table.h"
#include "io/output.h"
#include "io/read.h"
#include "ops/make.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <unistd.h>

namespace druse {
namespace {

namespace fs = std::filesystem;

fs::path given; // on the command line

/// A folder for files of this run.
const fs::path& folder()
{
    static const struct Folder {
        fs::path path = fs::temp_directory_path() / ("druse-bench-" + std::to_string(getpid()));
        Folder() { fs::create_directories(path); }
        ~Folder()
        {
            std::error_code ignored;
            fs::remove_all(path, ignored);
        }
    } it;
    return it.path;
}

Model torus(std::int64_t quads)
{
    const auto n = static_cast<int>(std::lround(std::sqrt(double(quads))));
    Progress progress;
    Model model;
    model.mesh = make_torus(n, n, 3.0, 1.0, progress);
    for (const Face f : model.mesh.faces()) model.mesh.set_group(f, 1 + static_cast<int>(f.index) / n % 8); // stripes in eight colours
    return model;
}

void write(const Model& model, const fs::path& file)
{
    OutputSet output;
    output.write({.mesh = model.mesh, .groups = model.groups}, file);
    output.commit();
}

const fs::path& coloured_obj(std::int64_t quads)
{
    static std::map<std::int64_t, fs::path> made;
    if (!given.empty()) return given;
    fs::path& file = made[quads];
    if (file.empty()) {
        file = folder() / (std::to_string(quads) + ".obj");
        write(torus(quads), file);
    }
    return file;
}

void report(benchmark::State& state, const fs::path& file, std::size_t faces)
{
    state.counters["MB"] = double(fs::file_size(file)) / 1e6;
    state.counters["faces_per_s"] = benchmark::Counter(double(faces), benchmark::Counter::kIsIterationInvariantRate);
}

void read_obj(benchmark::State& state)
{
    const fs::path& file = coloured_obj(state.range(0));
    std::size_t faces = 0;
    for (auto _ : state) {
        const Model model = read_model(file);
        faces = model.mesh.face_count();
    }
    report(state, file, faces);
}

void write_stl(benchmark::State& state)
{
    const Model model = torus(state.range(0));
    const fs::path file = folder() / "out.stl";
    for (auto _ : state) write(model, file);
    report(state, file, 2 * model.mesh.face_count());
}

void write_obj(benchmark::State& state)
{
    const Model model = torus(state.range(0));
    const fs::path file = folder() / "out.obj";
    for (auto _ : state) write(model, file);
    report(state, file, model.mesh.face_count());
}

#define SIZES ->Unit(benchmark::kMillisecond)->Arg(10'000)->Arg(100'000)->Arg(1'000'000)
BENCHMARK(read_obj) SIZES;
BENCHMARK(write_stl) SIZES;
BENCHMARK(write_obj) SIZES;

} // namespace
} // namespace druse

int main(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    if (argc > 1) druse::given = argv[1];
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
