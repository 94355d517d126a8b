#include "ui/session.h"

#include "app/command.h"
#include "app/save.h"
#include "ops/shown_lines.h"
#include "ops/text.h"

#include <fmt/format.h>

#include <new>

namespace druse::ui {

namespace {

constexpr std::size_t longest_log = 1000;

/// Does it say what a command acts on, rather than how?
bool is_target(const Parameter& p)
{
    using Type = Parameter::Type;
    return p.type == Type::faces || p.type == Type::edges || p.type == Type::vertices || p.type == Type::id || p.type == Type::corner;
}

/// `parts 2 → 1, genus 0 → 1`; empty if neither is another, or they are not counted.
std::string topology_text(const std::optional<MeshFacts>& before, const std::optional<MeshFacts>& after)
{
    if (!before || !after || (before->components == after->components && before->genus == after->genus)) return {};
    const auto change = [](const char* what, std::int64_t from, std::int64_t to) {
        return from == to ? fmt::format("{} {}", what, to) : fmt::format("{} {} → {}", what, from, to);
    };
    return change("parts", before->components, after->components) + ", " + change("genus", before->genus, after->genus);
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

} // namespace

Session::Session(const Registry& registry) : registry_(registry), document_(registry)
{
    DisplayChange(document_, whole_delta()).apply_to(display_, document_);
}

// --- what is shown ------------------------------------------------------------------------------------------------------------

void Session::say(Message::Kind kind, std::string text)
{
    message_ = {kind, first_line(text)};
    if (message_.text.empty()) return;
    if (log_.size() == longest_log) log_.erase(log_.begin());
    log_.push_back(message_);
    if (kind == Message::Kind::error) event("error " + message_.text);
}

void Session::changed()
{
    ++display_version_;
    if (on_change) on_change();
}

void Session::event(const std::string& line)
{
    if (on_event) on_event(line);
}

// --- the chosen operator ------------------------------------------------------------------------------------------------------

void Session::choose(const Operator* op)
{
    if (op == chosen_) return;
    chosen_ = op;
    bound_.reset();
    implied_ = op ? implied_values(arguments_.try_emplace(op, *op).first->second, folder()) : Implied();
    message_ = {};
    event(op ? "chosen " + op->name : "chosen nothing");
    changed();
}

const Arguments& Session::arguments() const
{
    ASSERT(chosen_, "an operator is chosen");
    return arguments_.at(chosen_);
}

void Session::set(std::string_view parameter, std::string_view text)
{
    ASSERT(chosen_, "an operator is chosen");
    Arguments& arguments = arguments_.at(chosen_);
    if (arguments.text(parameter) == text) return;
    try {
        arguments.set(parameter, text);
    } catch (const CommandError& e) {
        say(Message::Kind::error, fmt::format("{}: {}={}: {}", chosen_->name, parameter, text, e.what()));
        changed();
        return;
    }
    if (message_.kind == Message::Kind::error) message_ = {};
    arguments_changed();
}

void Session::choose_value(std::string_view parameter, std::string_view text)
{
    event(fmt::format("set {} {}", parameter, text));
    set(parameter, text);
}

void Session::reset_arguments()
{
    if (!chosen_) return;
    arguments_.at(chosen_).reset();
    arguments_changed();
}

std::string Session::shown_text(std::string_view parameter) const
{
    const auto in_full = implied_.find(parameter);
    return in_full == implied_.end() ? arguments().text(parameter) : in_full->second.text;
}

/// Whoever depends on the values of the chosen operator follows them: what they imply, and the step that is bound to the panel.
void Session::arguments_changed()
{
    Arguments& arguments = arguments_.at(chosen_);
    implied_ = implied_values(arguments, folder());
    for (const auto& [name, value] : implied_) { // a number for each tier of a solid that is no longer the one
        const auto given = split(arguments.text(name), ',').size();
        if (given > 1 && given != split(value.text, ',').size()) arguments.set(name, "");
    }
    if (bound_ && live_ && !not_live_.contains(chosen_))
        submit({.task = Request::Task::again, .command = arguments.command(*bound_), .target = bound_});
    else changed();
}

// --- presets ------------------------------------------------------------------------------------------------------------------

void Session::take_preset(const Preset& preset)
{
    if (!chosen_) return;
    Arguments taken = arguments_.at(chosen_);
    for (const Parameter& p : chosen_->parameters)
        if (!is_target(p)) taken.set(p.name, "");
    try {
        for (const auto& [key, value] : parse_command(chosen_->name + " " + preset.arguments).arguments) {
            if (!chosen_->find(key)) throw CommandError(fmt::format("unknown parameter '{}'", key));
            taken.set(key, value);
        }
    } catch (const CommandError& e) {
        say(Message::Kind::error, fmt::format("{}: preset={}: {}", chosen_->name, preset.name, e.what()));
        changed();
        return;
    }
    arguments_.at(chosen_) = std::move(taken);
    event("preset " + preset.name);
    arguments_changed();
}

void Session::take_preset(const std::string& name)
{
    if (!chosen_) return;
    const std::vector<Preset> own = presets_.of(*chosen_);
    for (const auto* list : {&own, &chosen_->presets})
        for (const Preset& preset : *list)
            if (preset.name == name) return take_preset(preset);
    throw CommandError(fmt::format("{} has no preset '{}'", chosen_->name, name));
}

void Session::store_preset(const std::string& name)
{
    if (!chosen_) return;
    std::string values;
    const Arguments& arguments = arguments_.at(chosen_);
    for (const Parameter& p : chosen_->parameters)
        if (!is_target(p) && !arguments.is_default(p.name)) values.append(values.empty() ? "" : " ").append(argument_text(p.name, arguments.text(p.name)));
    presets_.store(*chosen_, {name, values});
    event("stored preset " + name);
    say(Message::Kind::note, fmt::format("stored as preset={} of {}", name, chosen_->name));
    changed();
}

void Session::forget_preset(const std::string& name)
{
    if (!chosen_) return;
    presets_.forget(*chosen_, name);
    event("forgot preset " + name);
    changed();
}

void Session::set_live(bool on)
{
    live_ = on;
    changed();
}

std::string Session::bound_target() const
{
    std::string text;
    if (bound_)
        for (const auto& [key, value] : *bound_) text += (text.empty() ? "" : " ") + argument_text(key, value);
    return text;
}

// --- doing --------------------------------------------------------------------------------------------------------------------

void Session::apply_chosen(const Overrides& target)
{
    if (!chosen_) return;
    submit({.command = arguments_.at(chosen_).command(target), .target = target});
}

void Session::repeat()
{
    if (chosen_) apply_chosen();
    else say(Message::Kind::note, "choose an operator first; Space repeats it on the selection"), changed();
}

void Session::run(const std::string& command) { submit({.command = presets_.expand(registry_, command)}); }

void Session::run_chosen(const std::string& command)
{
    event("run " + command);
    run(command);
}

void Session::run_script(Script script) { submit({.task = Request::Task::script, .script = std::move(script)}); }

void Session::go_to(std::size_t step) { run(fmt::format("document.goto step={}", step)); }

void Session::open(const std::filesystem::path& file) { submit({.task = Request::Task::open, .file = std::filesystem::absolute(file)}); }

void Session::save(const std::filesystem::path& file) { submit({.task = Request::Task::save, .file = std::filesystem::absolute(file)}); }

void Session::export_to(const std::filesystem::path& file)
{
    submit({.task = Request::Task::save, .file = std::filesystem::absolute(file), .keep_file = true});
}

void Session::keep_copy(const std::filesystem::path& file) { submit({.task = Request::Task::copy, .file = file}); }

void Session::start_over() { submit({.task = Request::Task::clear}); }

void Session::count_facts()
{
    if (!busy() && !display_.facts) submit({.task = Request::Task::count});
}

void Session::submit(Request request)
{
    if (!in_flight_) {
        begin(std::move(request));
        return;
    }
    // While a slider moves only its newest value counts. Nobody waits for an autosave: what comes meanwhile follows it; nor for a
    // count of facts, which gives way and is taken up again later.
    const bool newest = request.task == Request::Task::again && request_.task == Request::Task::again;
    const bool place_is_free = !waiting_ || waiting_->task == Request::Task::again || is_background(*waiting_);
    if (newest || (is_background(request_) && place_is_free)) {
        waiting_ = std::move(request);
        if (request_.task == Request::Task::count) {
            worker_.cancel();
            if (worker_.wait(patience)) take_over();
        }
        return;
    }
    say(Message::Kind::note, fmt::format("still busy with {}; Escape cancels it", doing_));
    changed();
}

void Session::begin(Request request)
{
    request_ = std::move(request);
    result_ = Result();
    result_.before = position();
    in_flight_ = true;
    switch (request_.task) {
    case Request::Task::open: doing_ = "opening " + request_.file.filename().string(); break;
    case Request::Task::script: doing_ = request_.script.name; break;
    case Request::Task::save: doing_ = "writing " + request_.file.filename().string(); break;
    case Request::Task::copy: doing_ = "autosave"; break;
    case Request::Task::count: doing_ = "counting"; break;
    case Request::Task::clear: doing_ = "clearing"; break;
    default: doing_ = request_.command.substr(0, request_.command.find(' '));
    }
    worker_.start([this](Progress& progress) {
        const auto start = std::chrono::steady_clock::now();
        try {
            perform(request_, progress, result_);
        } catch (...) {
            result_.error = std::current_exception();
        }
        result_.took = std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - start);
    });
    if (!is_background(request_) && worker_.wait(patience)) {
        take_over();
        return;
    }
    if (wake) worker_.when_done(wake);
    changed();
}

/// Runs on the worker: nothing but the document and the result may be touched.
void Session::perform(const Request& request, Progress& progress, Result& result)
{
    switch (request.task) {
    case Request::Task::command:
    case Request::Task::again: {
        const std::uint64_t version = document_.version();
        const bool shown = shows_source(document_.scene());
        MeshDelta delta = run_command(request, progress, result);
        delta.whole = delta.whole || shown || shows_source(document_.scene());
        if (document_.version() != version) result.change.emplace(document_, std::move(delta), draws_sources_);
        break;
    }
    case Request::Task::open:
        result.outcome = document_.open(request.file, progress);
        result.change.emplace(document_, whole_delta(), draws_sources_);
        break;
    case Request::Task::script: {
        Document fresh(registry_);
        result.outcome = fresh.run(request.script, progress);
        if (result.outcome.failed) break;
        document_ = std::move(fresh);
        result.change.emplace(document_, whole_delta(), draws_sources_);
        break;
    }
    case Request::Task::clear:
        document_ = Document(registry_);
        result.change.emplace(document_, whole_delta(), draws_sources_);
        break;
    case Request::Task::save: {
        OutputSet output;
        write_document(document_, output, request.file);
        output.commit();
        result.outcome.notes = output.notes();
        break;
    }
    case Request::Task::copy: {
        OutputSet output;
        write_document(document_, output, request.file);
        try {
            write_document(document_, output, std::filesystem::path(request.file).replace_extension(".druse"));
        } catch (const CommandError&) {
            // A document without a history that a script could tell.
        }
        output.commit();
        break;
    }
    case Request::Task::count: result.facts = facts(document_.scene().mesh, progress); break;
    }
}

MeshDelta Session::run_command(const Request& request, Progress& progress, Result& result)
{
    const Mesh& mesh = document_.scene().mesh;
    const History& history = document_.history();
    const std::size_t before = position();

    if (request.task == Request::Task::again && history.done() > history.first() && history.done() == history.size()) {
        // What is on the screen is neither the state before the step nor the one after it: what differs from it lies in both.
        MeshDelta taken_back = difference(mesh, history[history.done() - 1].mesh);
        result.outcome = document_.apply_again(request.command, progress, folder());
        return both(std::move(taken_back), difference(mesh, history[history.done() - 1].mesh), mesh);
    }

    result.outcome = document_.apply(request.command, progress, folder());
    if (position() == before + 1) return difference(mesh, history[history.done() - 1].mesh);
    if (position() + 1 == before) return difference(mesh, history[history.done()].mesh);
    return whole_delta();
}

void Session::finish()
{
    if (in_flight_ && !worker_.busy()) take_over();
}

void Session::wait()
{
    while (in_flight_) {
        worker_.wait();
        take_over();
    }
}

void Session::cancel()
{
    if (!in_flight_) return;
    waiting_.reset();
    worker_.cancel();
}

void Session::take_over()
{
    const Request request = std::move(request_);
    Result result = std::move(result_);
    in_flight_ = false;
    const std::optional<MeshFacts> before = display_.facts;
    if (result.change) result.change->apply_to(display_, document_);
    if (result.facts) display_.facts = std::move(result.facts);
    report(request, result, before);
    if (waiting_) {
        Request next = std::move(*waiting_);
        waiting_.reset();
        begin(std::move(next));
        return;
    }
    changed();
}

void Session::report(const Request& request, const Result& result, const std::optional<MeshFacts>& before)
{
    if (result.error) {
        report_error(request, result.error);
        return;
    }
    if (is_background(request)) return;

    failed_.clear();
    if ((request.task == Request::Task::open || request.task == Request::Task::script) && result.outcome.failed) { // a strict query in the script: nothing was opened
        say(Message::Kind::error, result.outcome.failure);
        return;
    }
    if (request.task != Request::Task::save) bound_.reset();
    follow_saved_state(request, result);

    message_ = {};
    if (request.target && request.task == Request::Task::command) say(Message::Kind::note, topology_text(before, display_.facts));
    for (const std::string& note : result.outcome.notes) say(Message::Kind::note, note);
    const std::string name = request.file.filename().string();
    switch (request.task) {
    case Request::Task::open:
        event("opened " + request.file.string());
        if (result.outcome.notes.empty()) say(Message::Kind::note, "opened " + name);
        break;
    case Request::Task::save:
        event((request.keep_file ? "exported " : "saved ") + request.file.string());
        if (result.outcome.notes.empty()) say(Message::Kind::note, (request.keep_file ? "exported " : "saved ") + name);
        break;
    case Request::Task::script: event("took " + request.script.name); break;
    case Request::Task::clear: event("cleared"); break;
    default: {
        const std::string operator_name = result.outcome.text.substr(0, result.outcome.text.find(' '));
        event(fmt::format("{} {} faces={}", request.task == Request::Task::again ? "adjusted" : "applied", operator_name, display_.counts.faces));
        const Operator* op = registry().find(operator_name);
        if (request.target && op == chosen_ && op && op->kind == Operator::Kind::edit) bound_ = request.target;
        if (!result.outcome.output.empty()) {
            say(result.outcome.failed ? Message::Kind::error : Message::Kind::note,
                operator_name + (result.outcome.failed ? ": found something wrong" : ": done"));
            if (on_output) on_output(operator_name, result.outcome.output);
        }
        if (request.task == Request::Task::again && request.target && result.took > too_slow_for_live) {
            not_live_.insert(chosen_);
            say(Message::Kind::note, operator_name + " is too slow here to follow a slider: press Apply");
        }
    }
    }
}

void Session::report_error(const Request& request, const std::exception_ptr& error)
{
    const auto fail = [this](std::string text) { say(Message::Kind::error, std::move(text)); };
    try {
        std::rethrow_exception(error);
    } catch (const Cancelled&) {
        if (is_background(request)) return;
        event("cancelled");
        say(Message::Kind::note, "cancelled");
        return;
    } catch (const InternalError& e) {
        fail(std::string("internal error, nothing was changed: ") + e.what());
    } catch (const std::bad_alloc&) {
        fail("not enough memory, nothing was changed");
    } catch (const std::exception& e) {
        fail(e.what());
    }
    if (request.target)
        for (const auto& [key, value] : *request.target)
            if ((key == "faces" || key == "from" || key == "to") && display_.lists.has_faces()) try {
                    for (const Face f : FaceSelector::parse(value).resolve(document_.scene())) failed_.push_back(f);
                } catch (const CommandError&) {
                }
}

/// The state on disk stays within reach until a new step takes its place in the history.
void Session::follow_saved_state(const Request& request, const Result& result)
{
    using Task = Request::Task;
    if (request.task == Task::open || request.task == Task::clear) {
        file_ = request.file;
        saved_ = position();
    } else if (request.task == Task::script) {
        file_.clear();
        saved_.reset();
    } else if (request.task == Task::save) {
        if (request.keep_file) return;
        file_ = request.file;
        saved_ = position();
    } else if (saved_) {
        const bool new_step = result.change && (request.task == Task::again || position() == result.before + 1) &&
                              document_.history().done() == document_.history().size();
        const std::size_t reached = request.task == Task::again ? result.before - 1 : result.before;
        if (new_step && *saved_ > reached) saved_.reset();
    }
}

// --- the file -----------------------------------------------------------------------------------------------------------------

std::filesystem::path Session::folder() const
{
    return file_.empty() ? std::filesystem::current_path() : file_.parent_path();
}

bool Session::is_changed() const { return !saved_ || *saved_ != display_.done; }

void Session::detach()
{
    file_.clear();
    saved_.reset();
    changed();
}

std::string Session::title() const
{
    return (file_.empty() ? std::string("untitled") : file_.filename().string()) + (is_changed() ? "*" : "");
}

std::string Session::script() const
{
    ASSERT(!busy(), "nothing works on the document");
    return document_.script(folder());
}

} // namespace druse::ui
