#pragma once

#include "dlfl/column.h"
#include "dlfl/mesh.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace druse {

/// The correspondence table of a crust: which face lies under which, and one pair of corners that belong together.
///
/// A crust is a surface and its copy turned inside out, so the boundaries of two such faces run against each other, and all other
/// corners follow from the one pair. The table stands beside the mesh and is not told what operators do to it: an entry is *live* while
/// both faces have the vertices they had, in the order they had (or both in the opposite one, as after a reflection). It remembers a sum
/// over the vertices of each face, so asking costs O(sides); where vertices lie does not matter.
///
/// Like the columns of a mesh it records what a command changes in it, so that a step of the history holds that alone.
/// Source: Özener, Akleman & Srinivasan 2005, *Interactive step*.
class Rind {
    /// What a face knows of the one it belongs to.
    struct Mate {
        Face other;
        Vertex vertex;          // where the corresponding corner is
        std::uint64_t ring = 0; // the sum over the vertices from there on

        friend bool operator==(const Mate&, const Mate&) = default;
    };

public:
    using Change = ColumnChange<Mate>; // what one command changed; see Column::exchange

    /// An entry as a file holds it: two faces and, of each, the place of the corner, counted from the start corner.
    struct Pair {
        Face first, second;
        std::uint32_t first_corner = 0, second_corner = 0;

        friend bool operator==(const Pair&, const Pair&) = default;
    };

    Rind() = default;
    /// Preconditions: the faces of each pair are alive, different and have equally many corners; no face is in two pairs.
    Rind(const Mesh& mesh, std::span<const Pair> pairs);
    /// Face i belongs to face count + i for all i below `count`, start corner to start corner. Cost: O(corners).
    static Rind of_copies(const Mesh& mesh, std::uint32_t count);

    /// True if it never had an entry, or was emptied as a whole.
    bool empty() const { return mates_.size() == 0; }
    /// The two corners that belong together, that of the lower face first; nothing where `f` has no live entry. Cost: O(sides).
    std::optional<std::array<Corner, 2>> find(const Mesh& mesh, Face f) const;
    /// Takes the entry of a face out, if it has one.
    void remove(Face f);
    /// The live entries, ascending. Cost: O(corners).
    std::vector<Pair> pairs(const Mesh& mesh) const;

    /// See the functions of Mesh with these names.
    void begin_change() { mates_.begin_change(); }
    Change end_change() { return mates_.end_change(); }
    void exchange(Change& change) { mates_.exchange(change); }
    void roll_back() { mates_.roll_back(); }
    /// True if a whole new table took the place of the old one since begin_change().
    bool is_replaced() const { return mates_.changed_whole(); }

    friend bool operator==(const Rind& a, const Rind& b);

private:
    const Mate* mate(Face f) const { return f.index < mates_.size() && mates_[f.index].other.valid() ? &mates_[f.index] : nullptr; }

    Column<Mate> mates_; // by face
};

/// Closes the holes of a mesh, and gives the faces of a table that belongs to it their new ids. Cost: that of Mesh::compact(), and
/// O(corners) if vertices or faces are renumbered while the table has entries.
Renumbering close_holes(Mesh& mesh, Rind& rind);

} // namespace druse
