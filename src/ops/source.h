#pragma once

#include "cell/cell_tile.h"
#include "graph/graph.h"
#include "pane/pane.h"
#include "tile/layered_tile.h"

#include <cstddef>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace druse {

/// What operators make a mesh from, edited by its own family.
using Source = std::variant<std::monostate, Graph, Pane, LayeredTile, CellTile>;

/// What a source is called in messages, `graph`; empty where there is none.
const char* name(const Source& source);
/// Memory that a source takes beside itself.
std::size_t bytes(const Source& source);

/// The source of a scene: at most one. Like a mesh it records what a command changes in it, for the history: of edits of a pane what they changed, of
/// anything else the source that was there.
class HeldSource {
public:
    /// The way from one state to another, and after exchange() the way back.
    struct Change {
        std::shared_ptr<Source> other;   // that was in its place
        std::vector<Pane::Change> edits; // or what was done to the pane, in order
        bool undone = false;             // the edits were

        std::size_t bytes() const;
    };

    const Source& operator*() const { return now_; }
    const Source* operator->() const { return &now_; }

    void replace_with(Source source);
    /// Runs f(pane), which makes one edit of the pane that is held, or throws and leaves the pane as it was. Cost: that of the edit.
    template <class F>
    void edit_pane(F&& f)
    {
        Pane& pane = std::get<Pane>(now_);
        const bool keep = recording_ && !change_.other;
        if (keep) change_.edits.reserve(change_.edits.size() + 1);
        f(pane);
        if (keep) change_.edits.push_back(pane.take_change());
    }

    Source release() && { return std::move(now_); }

    /// See the functions of Mesh with these names.
    void begin_change();
    Change end_change();
    void exchange(Change& change);
    void roll_back();

private:
    Source now_;
    Change change_;
    bool recording_ = false;
};

/// @throws CommandError `the document holds a pane, not a graph`, or that it holds none, with the hint
[[noreturn]] void refuse_source(const Source& source, const char* wanted, const char* hint);

/// The source of one kind, called `wanted`. @throws CommandError where the source is none of that kind
template <class T>
const T& held(const HeldSource& source, const char* wanted, const char* hint)
{
    if (const T* found = std::get_if<T>(&*source)) return *found;
    refuse_source(*source, wanted, hint);
}

} // namespace druse
