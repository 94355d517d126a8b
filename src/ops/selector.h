#pragma once

#include "ops/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace druse {

/// One part of a selector, between the `+` signs; see the grammar at parse().
struct SelectorTerm {
    enum class Kind { all, none, selected, ids, group, sides, component, normal, strut, ball, valence, ends };
    struct Range {
        std::uint32_t first, last;
        friend bool operator==(const Range&, const Range&) = default;
    };
    Kind kind = Kind::selected;
    std::vector<Range> ids;        // ids; ends: the two end vertices as a range
    std::int64_t number = 0;       // group, sides, component, strut, ball, valence
    Vector direction{0.0};         // normal
    double angle = 0.0;            // normal, degrees

    friend bool operator==(const SelectorTerm&, const SelectorTerm&) = default;
};

/// Names elements of the mesh without naming a mesh: `all`, `none`, `selected`, ids `0,4,7-9`, joined by `+`; faces also
/// `group:3`, `sides:5`, `component:0`, `normal:x,y,z,angle`, and of a graph's edge or vertex `strut:4`, `ball:9`; vertices `valence:3`; edges
/// their end vertices `4~9`.
template <class H>
class Selector {
public:
    Selector() : terms_(1) {} // selected
    /// @throws CommandError that names what was expected
    static Selector parse(std::string_view text);
    static Selector all();
    static Selector none();
    static Selector of(const std::vector<H>& handles);

    std::string text() const;

    /// The elements meant, ascending. Cost: O(mesh) at most; O(result) for ids and the selection.
    /// @throws CommandError for ids, groups or components that are not there, and for an empty selection
    std::vector<H> resolve(const Scene& scene) const;

    friend bool operator==(const Selector&, const Selector&) = default;

private:
    std::vector<SelectorTerm> terms_;
};

using FaceSelector = Selector<Face>;
using EdgeSelector = Selector<Edge>;
using VertexSelector = Selector<Vertex>;

/// One element named by a command; resolve() finds it or throws CommandError. An edge may be given by its ends, `4~9`.
struct FaceId {
    std::uint32_t id = 0;
    Face resolve(const Mesh& mesh) const;
};
struct VertexId {
    std::uint32_t id = 0;
    Vertex resolve(const Mesh& mesh) const;
};
struct EdgeId {
    std::uint32_t id = 0, other_end = Edge::none; // with other_end: `id` is a vertex, and this another one
    Edge resolve(const Mesh& mesh) const;
};
/// `FACE:K`, the K-th corner of a face from 0 at its start corner.
struct CornerId {
    std::uint32_t face = 0, place = 0;
    Corner resolve(const Mesh& mesh) const;
};

} // namespace druse
