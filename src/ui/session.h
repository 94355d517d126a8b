#pragma once

#include "ui/arguments.h"
#include "ui/display.h"
#include "ui/implied.h"
#include "ui/worker.h"

#include "app/document.h"
#include "app/preset_file.h"
#include "app/script.h"

#include <chrono>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace druse::ui {

/// One line for the status bar.
struct Message {
    enum class Kind { note, error };
    Kind kind = Kind::note;
    std::string text;
};

/// What a window does, without the window: a document, what is shown of it, the operator that is chosen and its values, and the
/// one worker on which every command runs.
///
/// A command gets `patience` to be done before the caller goes on without it; until it is, busy() is true, the display stays as it
/// was, and `wake` is called (on the worker's thread) when finish() has something to take over. All other functions belong to
/// one thread.
class Session {
public:
    static constexpr std::chrono::milliseconds patience{40};
    static constexpr std::chrono::milliseconds too_slow_for_live{2000};

    explicit Session(const Registry& registry);

    // --- who listens ----------------------------------------------------------------------------------------------------

    std::function<void()> wake;                       // on the worker's thread; see finish()
    std::function<void()> on_change;                  // display, operator, message or busy() is not as it was
    std::function<void(const std::string&)> on_event; // one line for the event log
    std::function<void(const std::string& title, const std::string& text)> on_output; // what a query found

    /// The lines of a graph, pane or tile are not among what is shown: the window has its own picture of it.
    void leave_out_sources() { draws_sources_ = false; }

    // --- what is shown --------------------------------------------------------------------------------------------------

    const Display& display() const { return display_; }
    /// Grows with everything that on_change tells of the display.
    std::uint64_t display_version() const { return display_version_; }
    const Message& message() const { return message_; } // an empty text: nothing to say
    void say(Message::Kind kind, std::string text);
    const std::vector<Message>& log() const { return log_; }
    /// Faces that the last command could not work on.
    const std::vector<Face>& failed_faces() const { return failed_; }
    void forget_failed_faces() { failed_.clear(); }
    const Registry& registry() const { return registry_; }
    /// The mesh itself, for looking up corners; null while a command works on it. What runs in the background only reads it.
    const Mesh* mesh() const { return is_working() ? nullptr : &document_.scene().mesh; }
    /// All that the document holds; null at the same times.
    const Scene* scene() const { return is_working() ? nullptr : &document_.scene(); }
    /// Which of its faces are a crust's; null at the same times.
    const Rind* rind() const { return is_working() ? nullptr : &document_.scene().rind; }

    // --- the chosen operator --------------------------------------------------------------------------------------------

    /// Chooses an operator, or none. Each keeps the values it was given.
    void choose(const Operator* op);
    const Operator* chosen() const { return chosen_; }
    const Arguments& arguments() const; // precondition: chosen()
    /// What some of them work out to where the command leaves them out.
    const Implied& implied() const { return implied_; }
    /// The text of a parameter of the chosen operator as a panel shows it. Precondition: chosen()
    std::string shown_text(std::string_view parameter) const;
    /// Sets a value of the chosen operator. If its last step is still bound to the panel and live is on, runs that step again.
    void set(std::string_view parameter, std::string_view text);
    /// The same of a value that was chosen in a menu or dialog; the event log tells of it.
    void choose_value(std::string_view parameter, std::string_view text);
    void reset_arguments();
    /// Sets the values of a preset, and all others back to their defaults.
    void take_preset(const Preset& preset);
    /// The preset of that name, a person's own or a registered one. @throws CommandError if there is none
    void take_preset(const std::string& name);
    /// Keeps the values there are, the faces and the like left out, as a person's own preset. @throws CommandError, SystemError
    void store_preset(const std::string& name);
    void forget_preset(const std::string& name);
    PresetFile& presets() { return presets_; }

    bool live() const { return live_; }
    void set_live(bool on);
    /// True while the last step can be adjusted: it was made with the chosen operator, and nothing happened since.
    bool is_bound() const { return bound_.has_value(); }
    /// Leaves the last step as it is: values that are set from here on are for the next one.
    void let_go() { bound_.reset(); }
    /// The arguments beside the panel's that the bound step was made with; empty if nothing is bound.
    std::string bound_target() const;

    // --- doing ----------------------------------------------------------------------------------------------------------

    using Overrides = std::vector<std::pair<std::string, std::string>>;

    /// Runs the chosen operator with its values; `target` says what to act on, e.g. {{"faces", "17"}}. The step stays bound.
    void apply_chosen(const Overrides& target = {});
    /// Runs the command of the last step of the chosen operator again, on the selection there is now.
    void repeat();
    /// Runs any command.
    void run(const std::string& command);
    /// Runs a command in place of the last step, which stands if it is refused; of several that wait only the newest is run.
    void run_again(const std::string& command) { submit({.task = Request::Task::again, .command = command}); }
    /// The same of one that was chosen in a menu or dialog; the event log tells of it.
    void run_chosen(const std::string& command);
    /// Makes a script's commands, run from an empty document, the history: the document has no file then.
    void run_script(Script script);
    void undo() { run("document.undo"); }
    void redo() { run("document.redo"); }
    void go_to(std::size_t step);

    void open(const std::filesystem::path& file);
    /// Writes the mesh (or what the extension says) to the file and makes it the document's own.
    void save(const std::filesystem::path& file);
    /// Writes it and keeps the document's own file.
    void export_to(const std::filesystem::path& file);
    /// Writes the mesh to this file and the history, if a script can tell it, beside it, and says nothing about it.
    void keep_copy(const std::filesystem::path& file);
    /// An empty document, without a file.
    void start_over();

    bool busy() const { return in_flight_; }
    /// Busy with something a person waits for.
    bool is_working() const { return in_flight_ && !is_background(request_); }
    double fraction() const { return worker_.fraction(); }
    /// What is being done, for the progress bar.
    const std::string& doing() const { return doing_; }
    void cancel();
    /// Takes over what the worker has done, and starts what was waiting for it. Nothing happens if it is not done yet.
    void finish();
    /// Waits until nothing runs or waits.
    void wait();

    /// Counts the facts of a mesh that was too large to count them with its command.
    void count_facts();

    // --- the file -------------------------------------------------------------------------------------------------------

    const std::filesystem::path& file() const { return file_; }
    /// That of the file, or else the one the program is in: what commands name files from.
    std::filesystem::path folder() const;
    std::string title() const; // `cube.obj*`
    bool is_changed() const;
    /// The step that was saved last; nothing if that state is out of reach.
    std::optional<std::size_t> saved_step() const { return saved_; }
    /// The history as a script. Precondition: not busy().
    std::string script() const;
    /// Forgets that the document has a file: what was opened is a copy of something unsaved.
    void detach();
    /// Grows with every change of the document. Precondition: not busy().
    std::uint64_t document_version() const { return document_.version(); }

private:
    struct Request {
        enum class Task { command, again, open, script, save, copy, count, clear };
        Task task = Task::command;
        std::string command = {};
        std::filesystem::path file = {};
        bool keep_file = false;               // save: only an export
        Script script = {};
        std::optional<Overrides> target = {}; // the step stays bound to the panel with this
    };
    struct Result {
        std::exception_ptr error;
        Document::Outcome outcome;
        std::optional<DisplayChange> change;
        std::optional<MeshFacts> facts;
        std::size_t before = 0; // steps done
        std::chrono::milliseconds took{0};
    };

    static bool is_background(const Request& request) { return request.task == Request::Task::count || request.task == Request::Task::copy; }
    void arguments_changed();
    void submit(Request request);
    void begin(Request request);
    void perform(const Request& request, Progress& progress, Result& result);
    MeshDelta run_command(const Request& request, Progress& progress, Result& result);
    void take_over();
    void report(const Request& request, const Result& result, const std::optional<MeshFacts>& before);
    void report_error(const Request& request, const std::exception_ptr& error);
    void follow_saved_state(const Request& request, const Result& result);
    std::size_t position() const { return document_.history().done(); }
    void changed();
    void event(const std::string& line);

    const Registry& registry_;
    Document document_;
    Display display_;
    std::uint64_t display_version_ = 0;
    Message message_;
    std::vector<Message> log_;
    std::vector<Face> failed_;

    const Operator* chosen_ = nullptr;
    std::map<const Operator*, Arguments> arguments_;
    Implied implied_; // by the chosen operator's
    PresetFile presets_;
    std::optional<Overrides> bound_;
    bool live_ = true;
    std::set<const Operator*> not_live_; // too slow to run while a slider moves

    std::filesystem::path file_;
    std::optional<std::size_t> saved_ = 0;

    bool in_flight_ = false;
    Request request_;
    std::optional<Request> waiting_;
    Result result_;
    std::string doing_;
    bool draws_sources_ = true;
    Worker worker_; // last: it is done before anything it works on goes
};

} // namespace druse::ui
