#pragma once

#include "ops/scene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace druse {

/// A line of states of a scene, each reached from the one before by a command.
///
/// A step keeps what leads from one state to the other: the pages of the mesh that differ, and the selection, groups and source
/// where they differ. Going back or forth exchanges them with the scene's, exactly, at a cost that follows the change.
class History {
public:
    struct Step {
        std::string text; // the command, as a script writes it
        MeshChange mesh;
        Shared<GroupTable> groups;
        Shared<Selection> selection;
        Shared<Source> source;
        std::size_t bytes() const;
    };

    /// Forgets everything: the scene as it is now becomes step 0. `text` is how it came to be (`document.open file=…`), or empty.
    void begin(std::string text);

    /// Adds the step that has just been made; states that had been undone are dropped, and the oldest steps while the budget is passed.
    void add(Step step);

    /// Steps done, and steps there are. Undone steps follow the done ones.
    std::size_t done() const { return done_; }
    std::size_t size() const { return steps_.size(); }
    const Step& operator[](std::size_t i) const { return steps_[i]; }
    /// How many steps were dropped before step 0 because of the budget: then the history no longer starts at the beginning.
    std::size_t dropped() const { return dropped_; }
    const std::string& beginning() const { return beginning_; }

    void undo(Scene& scene); // precondition: done() > 0
    void redo(Scene& scene); // precondition: done() < size()
    /// Takes the last done step back and out of the history. Precondition: done() == size() > 0
    Step take_last(Scene& scene);

    std::size_t bytes() const { return bytes_; }
    void set_budget(std::size_t bytes) { budget_ = bytes; }

    /// The commands from the beginning to the present state, one a line. Empty if the first ones were dropped.
    std::vector<std::string> script() const;

private:
    void exchange(Scene& scene, Step& step);

    std::vector<Step> steps_;
    std::size_t done_ = 0, dropped_ = 0, bytes_ = 0;
    std::size_t budget_ = std::size_t(1) << 30;
    std::string beginning_;
};

} // namespace druse
