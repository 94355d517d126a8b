#include "dlfl/errors.h"
#include "dlfl/mesh.h"

namespace druse {

void Mesh::reverse_components(std::span<const Face> faces)
{
    ASSERT(!has_holes(), "no holes when components are turned");
    std::vector<bool> turned(corner_limit(), false);
    std::vector<Corner> reached;
    const auto reach = [&](Corner c) {
        if (turned[c.index]) return;
        reached.push_back(c);
        for (Corner d = c; !turned[d.index]; d = next(d)) turned[d.index] = true;
    };
    for (const Face f : faces) reach(corner(f));
    for (std::size_t i = 0; i < reached.size(); ++i) {
        if (!edge(reached[i]).valid()) continue;
        Corner c = reached[i];
        do {
            reach(opposite(c));
            c = next(c);
        } while (c != reached[i]);
    }
    // The side that started at a corner now ends there, so it belongs to the corner after it.
    for (std::uint32_t e = 0; e < edge_limit(); ++e)
        if (const auto [a, b] = edge_corners_[e]; turned[a.index]) edge_corners_.set(e, {next(a), next(b)});
    for (const Corner first : reached) {
        Edge before = edge(previous(first));
        Corner c = first;
        do {
            const Corner after = next(c);
            const Edge own = edge(c);
            corner_next_.set(c.index, previous(c));
            corner_previous_.set(c.index, after);
            corner_edge_.set(c.index, before);
            before = own;
            c = after;
        } while (c != first);
    }
}

} // namespace druse
