#pragma once

#include "ops/scene.h"

#include <cstddef>
#include <deque>
#include <filesystem>
#include <string>
#include <vector>

namespace druse {

/// A command as a script writes it. Where it names files, they are relative to `folder`.
struct ScriptCommand {
    std::string text;
    std::filesystem::path folder; // absolute; empty where the command names no file

    friend bool operator==(const ScriptCommand&, const ScriptCommand&) = default;
};

/// A line of states of a scene, each reached from the one before by a command.
///
/// A step keeps what leads from one state to the other: the pages of the mesh that differ, what edits of a pane changed, and another
/// source, the selection and the groups where they differ. Going back or forth exchanges them with the scene's, exactly, at a cost that follows the change.
///
/// States are counted from 0, the beginning; state k is the one after k steps. Where the steps pass the memory budget, the oldest
/// states are dropped, never the last step's. Their commands stay, so that the whole history can always be written as a script.
class History {
public:
    struct Step {
        ScriptCommand command;
        MeshChange mesh;
        Rind::Change rind;
        Shared<GroupTable> groups;
        Shared<Selection> selection;
        HeldSource::Change source;
        std::size_t bytes = 0; // what it holds that the scene does not share; kept up to date by History
    };

    /// Forgets everything: the scene as it is now becomes the beginning. `command` is how it came to be (`document.open file=…`), or
    /// empty for an empty scene.
    void begin(ScriptCommand command);

    /// Adds the step that led to `scene`; states that had been undone are dropped, and the oldest while the budget is passed.
    /// If it throws (std::bad_alloc), neither the history nor the step has changed.
    void add(Step&& step, const Scene& scene);

    /// Steps done, and steps there are. Undone steps follow the done ones.
    std::size_t done() const { return done_; }
    std::size_t size() const { return steps_.size(); }
    const Step& operator[](std::size_t i) const { return steps_[i]; }
    /// The first state that can be gone back to: 0, or more once the budget was passed. Always ≤ done().
    std::size_t first() const { return first_; }
    const ScriptCommand& beginning() const { return beginning_; }

    void undo(Scene& scene); // precondition: done() > first()
    void redo(Scene& scene); // precondition: done() < size()
    /// Goes to state `k`. Precondition: first() ≤ k ≤ size().
    void go_to(Scene& scene, std::size_t k);
    /// Takes the last done step back and out of the history. Precondition: done() == size() > first()
    Step take_last(Scene& scene);
    /// Does again what take_last() took back. Precondition: the scene is as it left it.
    void put_last(Scene& scene, Step&& step);
    /// Says that another command led from the same state to the present one. Precondition: done() == size() > 0
    void rename_last(ScriptCommand command);

    std::size_t bytes() const { return bytes_; }
    std::size_t budget() const { return budget_; }
    /// Drops what passes the new budget at the next add().
    void set_budget(std::size_t bytes) { budget_ = bytes; }

    /// The commands from the beginning to the present state.
    std::vector<ScriptCommand> script() const;

private:
    static void exchange(Scene& scene, Step& step);
    void drop_state(std::size_t k);

    std::deque<Step> steps_;
    std::size_t done_ = 0, first_ = 0, bytes_ = 0;
    std::size_t budget_ = std::size_t(1) << 30;
    ScriptCommand beginning_;
};

} // namespace druse
