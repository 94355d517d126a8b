#include "app/document_operators.h"

#include "app/document.h"
#include "app/registry.h"
#include "app/script.h"
#include "io/read.h"

#include <fmt/format.h>

#include <iterator>
#include <limits>

namespace druse {

namespace {

constexpr const char* open_name = "document.open";
constexpr const char* undo_name = "document.undo";
constexpr const char* redo_name = "document.redo";
constexpr const char* goto_name = "document.goto";

struct OpenFile {
    FilePath file;
};
struct Steps {
    int steps = 1;
};
struct GoTo {
    int step = 0;
};

/// Reads a file in place of what the scene holds; a script runs from an empty document of its own.
void open_file(Scene& scene, const OpenFile& p, Context& context)
{
    const std::filesystem::path file = context.folder / p.file.path;
    if (!is_script(file)) {
        Model model = read_model(file, context.progress);
        context.progress.step(1.0);
        context.notes = std::move(model.notes);
        fill(scene, std::move(model));
        return;
    }
    Document inner(all_operators());
    inner.set_scripts(context.scripts);
    Document::Outcome outcome = inner.open(file, context.progress);
    if (outcome.failed) throw CommandError(outcome.failure);
    context.notes = std::move(outcome.notes);
    context.output = std::move(outcome.output);
    Scene made = std::move(inner).release();
    scene.mesh.replace_with(std::move(made.mesh));
    scene.rind = std::move(made.rind);
    scene.groups = std::move(made.groups);
    scene.selection = std::move(made.selection);
    scene.source.replace_with(std::move(made.source).release());
}

} // namespace

void fill(Scene& scene, Model&& model)
{
    scene.mesh.replace_with(std::move(model.mesh));
    scene.rind = std::move(model.rind);
    scene.groups = std::move(model.groups);
    scene.selection = Selection();
    if (model.pane) scene.source.replace_with(std::move(*model.pane));
    else if (model.tile) scene.source.replace_with(std::move(*model.tile));
    else if (model.cell) scene.source.replace_with(std::move(*model.cell));
    else if (model.graph) scene.source.replace_with(std::move(*model.graph));
    else scene.source.replace_with({});
}

ScriptCommand opening_command(const std::filesystem::path& file)
{
    return {std::string(open_name) + " " + argument_text("file", file.string()), std::filesystem::current_path()};
}

const FilePath* opened_file(const Invocation& call)
{
    return call.op->name == open_name ? &static_cast<const OpenFile*>(call.parameters.get())->file : nullptr;
}

std::size_t travel_destination(const Invocation& call, const History& history)
{
    if (call.op->name == goto_name) {
        const auto step = static_cast<std::size_t>(static_cast<const GoTo*>(call.parameters.get())->step);
        if (step >= history.first() && step <= history.size()) return step;
        throw CommandError(fmt::format("step={}: expected {} to {}{}", step, history.first(), history.size(),
                                       step < history.first() ? "; earlier states are no longer kept" : ""));
    }
    const auto steps = static_cast<std::size_t>(static_cast<const Steps*>(call.parameters.get())->steps);
    const bool back = call.op->name == undo_name;
    const std::size_t most = back ? history.done() - history.first() : history.size() - history.done();
    if (most == 0) throw CommandError(fmt::format("there is nothing to {}", back ? "undo" : "redo"));
    if (steps > most) throw CommandError(fmt::format("steps={}: expected 1{}", steps, most > 1 ? fmt::format(" to {}", most) : ""));
    return back ? history.done() - steps : history.done() + steps;
}

void register_document(Registry& registry)
{
    // Travel is the document's own affair: see travel_destination().
    const auto never = [](Scene&, const auto&, Context&) { ASSERT(false, "travel done by the document"); };

    registry.add(define<OpenFile>(open_name, "Open a file in place of mesh and source")
                     .param(&OpenFile::file, "file", "a model or a script (.druse); as the first command it is the beginning")
                     .required()
                     .example("document.open file=cube.obj")
                     .cites("Druse")
                     .run(open_file));
    registry.add(define<Steps>(undo_name, "Take steps back")
                     .param(&Steps::steps, "steps", Unit::count, at_least(1), "how many")
                     .example("document.undo steps=2")
                     .cites("Druse")
                     .travel()
                     .run(never));
    registry.add(define<Steps>(redo_name, "Do steps again that were taken back")
                     .param(&Steps::steps, "steps", Unit::count, at_least(1), "how many")
                     .example("document.redo")
                     .cites("Druse")
                     .travel()
                     .run(never));
    registry.add(define<GoTo>(goto_name, "Go to a state of the history")
                     .param(&GoTo::step, "step", Unit::count, at_least(0), "how many steps have then been done; 0 is the beginning")
                     .required()
                     .example("document.goto step=0")
                     .cites("Druse")
                     .travel()
                     .run(never));
    registry.add(define<NoParameters>("document.clear", "Empty the document: mesh, source, groups and selection")
                     .example("document.clear")
                     .cites("Druse")
                     .run([](Scene& scene, const NoParameters&, Context&) { fill(scene, Model()); }));
}

} // namespace druse
