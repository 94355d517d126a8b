#pragma once

#include "app/document.h"
#include "dlfl/measures.h"
#include "render/draw_lists.h"
#include "render/mesh_delta.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace druse::ui {

/// How many faces a group has.
struct GroupSize {
    int id = 0;
    std::uint32_t faces = 0;
    friend bool operator==(const GroupSize&, const GroupSize&) = default;
};
/// The groups that faces are in, by ascending id; 0 too, if faces are in none. Cost: linear, and for ids far above the number of faces that
/// of sorting.
std::vector<GroupSize> group_sizes(const Mesh& mesh);

/// Everything that the window shows of a document, in a copy of its own: it stays while a command works on the document.
struct Display {
    DrawLists lists;
    Counts counts; // of the mesh, or of the lines that are shown without one
    std::optional<MeshFacts> facts; // of the state shown; nothing while they are not counted yet
    Shared<GroupTable> groups;
    Shared<std::vector<GroupSize>> group_sizes;
    Shared<Selection> selection;
    std::vector<Point> starts; // start corners of the selected faces, a little way into the face

    std::string beginning;          // how step 0 came to be
    std::vector<std::string> steps; // the commands of the history, undone ones too
    std::size_t done = 0;           // how many of them are in the state shown
    std::size_t first = 0;          // states before this one are forgotten
};

/// What changed between two states of a document: made on the thread that changed it, taken over on the one that shows it.
class DisplayChange {
public:
    DisplayChange() = default;
    /// `delta` holds at least what changed in the mesh. Facts are counted if the mesh is small enough to wait for it, and lists
    /// made anew here if that is the larger part of the work.
    /// `draws_sources`: of a document without faces the lines of its source are drawn.
    DisplayChange(const Document& document, MeshDelta delta, bool draws_sources = true);

    /// Brings a display to the state of the document, which must be the one that the change was made for.
    void apply_to(Display& display, const Document& document);

private:
    MeshDelta delta_;
    std::optional<DrawLists> lists_;
    std::optional<Graph> lines_; // of a pane: most of them are as they were
    std::optional<MeshFacts> facts_;
    std::optional<std::vector<GroupSize>> group_sizes_; // if they may have changed
    std::vector<Point> starts_;
};

/// Everything changed.
MeshDelta whole_delta();
/// The union of two deltas, the second of which ends at the state `mesh`.
MeshDelta both(MeshDelta a, const MeshDelta& b, const Mesh& mesh);

} // namespace druse::ui
