#pragma once

#include "graph/graph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace druse {

/// Which ends of edges lie at each vertex. Edge e has the ends 2e, at its first vertex, and 2e + 1.
class Incidence {
public:
    explicit Incidence(const Graph& graph) : first_(graph.vertices.size() + 1, 0), ends_(2 * graph.edges.size())
    {
        for (const auto& edge : graph.edges)
            for (const std::uint32_t v : edge) ++first_[v];
        std::uint32_t sum = 0;
        for (std::uint32_t& n : first_) n = sum += n;
        for (std::uint32_t end = static_cast<std::uint32_t>(ends_.size()); end-- > 0;) ends_[--first_[graph.edges[end / 2][end % 2]]] = end;
    }

    /// Ascending.
    std::span<const std::uint32_t> ends(std::size_t v) const { return {ends_.data() + first_[v], first_[v + 1] - first_[v]}; }
    std::uint32_t valence(std::size_t v) const { return first_[v + 1] - first_[v]; }

private:
    std::vector<std::uint32_t> first_, ends_; // of vertex v those from first_[v] to first_[v + 1]
};

} // namespace druse
