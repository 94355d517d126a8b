#include "app/document.h"

#include "app/document_operators.h"
#include "app/script.h"
#include "dlfl/check.h"
#include "dlfl/errors.h"
#include "dlfl/mesh_tables.h"
#include "dlfl/rind_upkeep.h"
#include "io/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <new>

namespace druse {

namespace fs = std::filesystem;

namespace {

bool names_a_file(const Invocation& call)
{
    for (std::size_t i = 0; i < call.given.size(); ++i)
        if (const Parameter& p = call.op->parameters[i]; call.given[i] && p.names_file(p.text(call.parameters.get()))) return true;
    return false;
}

ScriptCommand script_command(const Invocation& call, const fs::path& folder)
{
    if (!names_a_file(call)) return {call.text(), {}};
    return {call.text(), fs::absolute(folder.empty() ? fs::path(".") : folder).lexically_normal()};
}

template <class H>
bool ascends(const std::vector<H>& list, std::uint32_t limit)
{
    return std::ranges::adjacent_find(list, std::greater_equal<>()) == list.end() && (list.empty() || list.back().index < limit);
}

/// A file that a command calls `name`, as a script in `folder` calls it: relative, unless it was not and lies outside.
std::string renamed(const fs::path& name, const fs::path& its_folder, const fs::path& folder)
{
    const fs::path target = (its_folder / name).lexically_normal(), from = fs::absolute(folder.empty() ? fs::path(".") : folder).lexically_normal();
    const fs::path lexical = target.lexically_proximate(from);
    if (name.is_absolute() && lexical.begin()->string() == "..") return name.string();
    std::error_code error;
    // Where a folder on the way is a link, `..` leads elsewhere than the text says: then go by the real folders.
    if (fs::exists(target, error) && !fs::equivalent(from / lexical, target, error)) {
        const fs::path real = fs::proximate(target, from, error);
        return (error ? target : real).string();
    }
    return lexical.string();
}

void append(Document::Outcome& all, Document::Outcome&& one)
{
    std::move(one.notes.begin(), one.notes.end(), std::back_inserter(all.notes));
    if (!one.output.empty()) all.output += (all.output.empty() ? "" : "\n") + one.output;
}

} // namespace

struct Document::Again {
    const Operator* op;
    std::unique_ptr<RemeshAgain> run;
    std::uint64_t version; // of the document after it
    Column<Point> points;  // room for those of the next one
};

Document::Document(const Registry& registry) : registry_(&registry) {}
Document::Document(Document&&) noexcept = default;
Document& Document::operator=(Document&&) noexcept = default;
Document::~Document() = default;

// --- the door ---------------------------------------------------------------------------------------------------------------

Document::Outcome Document::apply(std::string_view text, Progress& progress, const fs::path& folder)
{
    const Command command = parse_command(text);
    if (command.name.empty()) return {};
    const Invocation call = bind(*registry_, command);
    if (const FilePath* file = opened_file(call); file && version_ == 0) {
        Outcome outcome = open(folder / file->path, script_command(call, folder), progress);
        if (outcome.failed) outcome.failure = fmt::format("{}: {}", call.op->name, outcome.failure);
        return outcome;
    }
    return run(call, progress, folder);
}

Document::Outcome Document::apply(std::string_view command)
{
    Progress progress;
    return apply(command, progress);
}

Document::Outcome Document::apply_again(std::string_view text, Progress& progress, const fs::path& folder)
{
    const Invocation call = bind(*registry_, parse_command(text));
    if (call.op->kind != Operator::Kind::edit) throw CommandError(call.op->name + ": is no step of the history");
    if (place_again(call, progress)) return {call.text(), {}, {}, false, {}};
    History::Step last = history_.take_last(scene_);
    try {
        return run(call, progress, folder);
    } catch (...) {
        history_.put_last(scene_, std::move(last));
        throw;
    }
}

/// Keeps the last step, if it is a run of the same remeshing, and the call changes nothing but where vertices are.
void Document::keep_last(const Invocation& call, Progress& progress)
{
    again_.reset();
    const KeepRun keep = call.op->keep;
    if (!keep || history_.done() != history_.size() || history_.done() == history_.first()) return;
    const History::Step& last = history_[history_.done() - 1];
    const Invocation before = bind(*registry_, parse_command(last.command.text));
    if (before.op != call.op || last.rind.whole) return; // each run says that it empties the rind
    History::Step step = history_.take_last(scene_);
    std::unique_ptr<RemeshAgain> run;
    try {
        run = keep(scene_.mesh, before.parameters.get(), call.parameters.get(), progress);
    } catch (...) {
        history_.put_last(scene_, std::move(step));
        throw;
    }
    history_.put_last(scene_, std::move(step));
    if (run && history_.bytes() + run->bytes() <= history_.budget()) again_ = std::make_unique<Again>(Again{call.op, std::move(run), version_, {}});
}

/// Moves the vertices to where this command would have put them instead of the last one. False where it would have done more than that.
bool Document::place_again(const Invocation& call, Progress& progress)
{
    if (!again_ || again_->version != version_ || again_->op != call.op) {
        try {
            keep_last(call, progress);
        } catch (const std::bad_alloc&) {
            return false; // a whole run needs less
        }
    }
    if (!again_) return false;
    Again& again = *again_;
    again.points.reserve(scene_.mesh.vertex_limit());
    again.points.truncate(0);
    const std::span<Point> to(again.points.extend(scene_.mesh.vertex_limit()), scene_.mesh.vertex_limit());
    try {
        if (!again.run->place(call.parameters.get(), to, progress)) return false;
    } catch (const CommandError& e) {
        throw CommandError(fmt::format("{}: {}", call.op->name, e.what()));
    }
    const auto beyond = std::ranges::find_if_not(to, is_in_reach);
    if (beyond != to.end()) throw CommandError(fmt::format("{}: vertex {} would lie beyond {}", call.op->name, beyond - to.begin(), largest_coordinate));
    MeshTables::exchange_positions(scene_.mesh, again.points);
    history_.rename_last({call.text(), {}});
    again.version = ++version_;
    return true;
}

Document::Outcome Document::run(const Invocation& call, Progress& progress, const fs::path& folder)
{
    again_.reset();
    progress.step(0.0);
    Context context{progress, folder, scripts_, {}, {}, false, [&](const fs::path& file) { return read_model(folder / file, progress).mesh; }};
    try {
        switch (call.op->kind) {
        case Operator::Kind::edit: edit(call, context); break;
        case Operator::Kind::query: query(call, context); break;
        case Operator::Kind::travel: travel(call); break;
        }
    } catch (const CommandError& e) {
        throw CommandError(fmt::format("{}: {}", call.op->name, e.what()));
    }
    return {call.text(), std::move(context.notes), std::move(context.output), context.failed,
            context.failed ? call.op->name + ": found something wrong, and strict=true" : ""};
}

void Document::edit(const Invocation& call, Context& context)
{
    History::Step before{script_command(call, context.folder), {}, {}, scene_.groups, scene_.selection, {}};
    const Shared<Selection> nothing;
    scene_.mesh.begin_change();
    scene_.rind.begin_change();
    scene_.source.begin_change();
    bool mesh_recording = true, rind_recording = true, source_recording = true;
    try {
        call.op->run(scene_, call.parameters.get(), context);
        settle(scene_);
        before.mesh = scene_.mesh.end_change();
        mesh_recording = false;
        if (const Vertex v = changed_out_of_reach(scene_.mesh, before.mesh); v.valid())
            throw CommandError(fmt::format("vertex {} would lie beyond {}", v.index, largest_coordinate));
        check(*call.op, before.mesh);
        // Of a mesh put in place of another nothing survives that could stay selected, or be opened.
        if (before.mesh.corner_vertex.whole) {
            if (scene_.selection.same_as(before.selection)) scene_.selection = nothing;
            if (!scene_.rind.empty() && !scene_.rind.is_replaced()) {
                scene_.mesh.exchange(before.mesh); // it belongs to the mesh that was there
                const bool was_openable = has_live_pair(scene_.rind, scene_.mesh);
                scene_.mesh.exchange(before.mesh);
                scene_.rind = {};
                if (was_openable) context.note("the rind can no longer be punched");
            }
        } else if (!scene_.rind.is_replaced()) {
            drop_dead_pairs(scene_.rind, scene_.mesh, before.mesh);
        }
        before.rind = scene_.rind.end_change();
        rind_recording = false;
        before.source = scene_.source.end_change();
        source_recording = false;
        history_.add(std::move(before), scene_);
    } catch (...) {
        if (mesh_recording) scene_.mesh.roll_back();
        else scene_.mesh.exchange(before.mesh);
        if (rind_recording) scene_.rind.roll_back();
        else scene_.rind.exchange(before.rind);
        if (source_recording) scene_.source.roll_back();
        else scene_.source.exchange(before.source);
        scene_.groups = before.groups;
        scene_.selection = before.selection;
        throw;
    }
    ++version_;
}

void Document::query(const Invocation& call, Context& context)
{
    const Shared<GroupTable> groups = scene_.groups;
    const Shared<Selection> selection = scene_.selection;
    const auto restore = [&] {
        scene_.mesh.roll_back();
        scene_.rind.roll_back();
        scene_.source.roll_back();
        scene_.groups = groups;
        scene_.selection = selection;
    };
    scene_.mesh.begin_change();
    scene_.rind.begin_change();
    scene_.source.begin_change();
    try {
        call.op->run(scene_, call.parameters.get(), context);
    } catch (...) {
        restore();
        throw;
    }
    restore();
}

void Document::travel(const Invocation& call)
{
    const std::size_t to = travel_destination(call, history_);
    if (to == history_.done()) return;
    history_.go_to(scene_, to);
    ++version_;
}

void Document::check(const Operator& op, [[maybe_unused]] const MeshChange& before) const
{
    const Mesh& mesh = scene_.mesh;
#ifdef DRUSE_FULL_CHECKS
    const std::string broken = druse::check(mesh);
#else
    const std::string broken = check_change(mesh, before);
#endif
    if (!broken.empty()) throw InternalError(fmt::format("internal error: {} left a mesh that is not sound: {}", op.name, broken));
    const Selection& selection = *scene_.selection;
    ASSERT(ascends(selection.faces, mesh.face_limit()) && ascends(selection.edges, mesh.edge_limit()) &&
               ascends(selection.vertices, mesh.vertex_limit()),
           "a selection that ascends without repeats");
}

// --- beginnings ---------------------------------------------------------------------------------------------------------------

Document::Outcome Document::open(const fs::path& file, Progress& progress) { return open(file, opening_command(file), progress); }

Document::Outcome Document::open(const fs::path& file, ScriptCommand command, Progress& progress)
{
    progress.step(0.0);
    Outcome outcome;
    if (is_script(file)) {
        Document fresh(*registry_);
        fresh.history_.set_budget(history_.budget());
        fresh.scripts_ = scripts_;
        outcome = fresh.run(Script::read(file), progress);
        outcome.text = command.text;
        if (outcome.failed) return outcome;
        again_.reset();
        scene_ = std::move(fresh.scene_);
        history_ = std::move(fresh.history_);
        without_file_ = fresh.without_file_;
        ++version_;
    } else {
        Model model = read_model(file, progress);
        progress.step(1.0);
        outcome.notes = std::move(model.notes);
        outcome.text = command.text;
        begin(std::move(model), std::move(command));
    }
    return outcome;
}

Document::Outcome Document::open(Model model)
{
    Outcome outcome;
    outcome.notes = std::move(model.notes);
    begin(std::move(model), {});
    without_file_ = true;
    return outcome;
}

void Document::begin(Model&& model, ScriptCommand command)
{
    Scene fresh;
    fill(fresh, std::move(model));
    again_.reset();
    scene_ = std::move(fresh);
    history_.begin(std::move(command));
    without_file_ = false;
    ++version_;
}

// --- scripts ------------------------------------------------------------------------------------------------------------------

Document::Outcome Document::run(const Script& script, Progress& progress)
{
    if (std::ranges::find(scripts_, script.path) != scripts_.end() && !script.path.empty())
        throw InputError(script.name, "this script is being run already: it would open itself without end");
    if (scripts_.size() >= Script::most_nested)
        throw InputError(script.name, fmt::format("scripts open each other more than {} deep", Script::most_nested));

    scripts_.push_back(script.path);
    Outcome all;
    std::string_view line;
    long number = 0;
    try {
        for (std::string_view rest = script.text; !rest.empty();) {
            line = next_line(rest);
            ++number;
            Outcome outcome = apply(line, progress, script.folder);
            all.failed = outcome.failed;
            if (outcome.failed) all.failure = fmt::format("{}:{}: {}", script.name, number, outcome.failure);
            append(all, std::move(outcome));
            if (all.failed) break;
        }
    } catch (const CommandError& e) {
        scripts_.pop_back();
        throw InputError(script.name, number, e.what());
    } catch (const InputError& e) {
        scripts_.pop_back();
        throw InputError(script.name, number, fmt::format("{}: {}", registry_->get(parse_command(line).name).name, e.what()));
    } catch (...) {
        scripts_.pop_back();
        throw;
    }
    scripts_.pop_back();
    return all;
}

std::string Document::script(const fs::path& folder) const
{
    if (without_file_) throw CommandError("the document began with standard input, which a script cannot open again");
    std::string text;
    for (const ScriptCommand& step : history_.script()) {
        if (step.folder.empty()) {
            text += step.text + "\n";
            continue;
        }
        Command command = parse_command(step.text);
        const Operator& op = registry_->get(command.name);
        for (auto& [key, value] : command.arguments) {
            const Parameter* p = op.find(key);
            if (!p || !p->names_file(value)) continue;
            value = renamed(value, step.folder, folder);
            if (!p->names_file(value)) value.insert(0, "./"); // or it would name something built in
        }
        text += bind(*registry_, command).text() + "\n";
    }
    return text;
}

} // namespace druse
