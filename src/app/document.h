#pragma once

#include "app/command.h"
#include "app/history.h"
#include "geom/progress.h"
#include "io/model.h"
#include "ops/registry.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace druse {

struct Script;

/// A scene, its history, and the one door through which it changes.
///
/// apply() may run on a worker thread; meanwhile no other function of the document may be called. Whoever shows the document
/// keeps what it needs to draw beside it and asks version() afterwards.
class Document {
public:
    explicit Document(const Registry& registry);
    Document(Document&&) noexcept;
    Document& operator=(Document&&) noexcept;
    ~Document();

    /// What a command had to say when it succeeded.
    struct Outcome {
        std::string text;               // the command in canonical form
        std::vector<std::string> notes; // without `note:`
        std::string output;             // of a query: one JSON object
        bool failed = false;            // a query with strict=true found something wrong
        std::string failure;            // then: that, as an error line
    };

    /// Parses, validates, runs, compacts, checks and commits one command. An empty line or a comment does nothing.
    ///
    /// If anything is thrown the document is as it was, bit for bit: CommandError (its text begins with the operator's name),
    /// InputError from files, Cancelled, InternalError, std::bad_alloc. File parameters are relative to `folder` (empty: the working
    /// folder). `document.open` as the first command is open().
    Outcome apply(std::string_view command, Progress& progress, const std::filesystem::path& folder = {});
    Outcome apply(std::string_view command);

    /// Takes the last step back and runs this command in its place, as dragging a slider after a click does. If it throws, the last
    /// step stands again. Where both remesh the model, and differ in positions only, nothing but these is made; for the next such call more is kept
    /// until the document changes otherwise, if the memory budget of the history has room for it. Precondition: the present state is the end of the history, and it has a step that can be undone.
    /// @throws also CommandError for a command that is no step of the history
    Outcome apply_again(std::string_view command, Progress& progress, const std::filesystem::path& folder = {});

    /// Makes a file the beginning, as `druse apply IN` and File > Open do: step 0, which undo does not pass. A `.druse` file is
    /// run as a script from an empty document. If anything is thrown, or the outcome is `failed`, the document is as it was.
    Outcome open(const std::filesystem::path& file, Progress& progress);

    /// Makes a model that has no file the beginning. The history can then not be written as a script.
    Outcome open(Model model);

    /// Runs the commands of a script one after the other, up to a query that failed. Each is a step of its own: those before an
    /// error stand. @throws InputError `SCRIPT:LINE: OPERATOR: what is wrong`
    Outcome run(const Script& script, Progress& progress);

    const Scene& scene() const { return scene_; }
    Scene release() && { return std::move(scene_); }
    const History& history() const { return history_; }
    History& history() { return history_; } // for its budget
    const Registry& registry() const { return *registry_; }

    /// Grows with every change of the scene.
    std::uint64_t version() const { return version_; }

    /// The history as a script; file parameters are written relative to `folder` (empty: the working folder).
    /// @throws CommandError if the document began with a model without a file
    std::string script(const std::filesystem::path& folder) const;

    /// Scripts being run on the document, from the outermost in. None of them may be opened again meanwhile.
    void set_scripts(std::vector<std::filesystem::path> scripts) { scripts_ = std::move(scripts); }

private:
    Outcome run(const Invocation& call, Progress& progress, const std::filesystem::path& folder);
    Outcome open(const std::filesystem::path& file, ScriptCommand command, Progress& progress);
    bool place_again(const Invocation& call, Progress& progress);
    void keep_last(const Invocation& call, Progress& progress);
    void edit(const Invocation& call, Context& context);
    void query(const Invocation& call, Context& context);
    void travel(const Invocation& call);
    void check(const Operator& op, const MeshChange& before) const;
    void begin(Model&& model, ScriptCommand command);

    const Registry* registry_;
    Scene scene_;
    History history_;
    std::uint64_t version_ = 0;
    bool without_file_ = false; // began with a model that a script cannot open
    std::vector<std::filesystem::path> scripts_;

    struct Again;
    std::unique_ptr<Again> again_; // the last step, kept for another apply_again(); nothing else finds it here
};

} // namespace druse
