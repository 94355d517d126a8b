#pragma once

#include "geom/point.h"
#include "geom/progress.h"

#include <cstddef>
#include <memory>
#include <span>

namespace druse {

class Mesh;

/// A run of a remeshing operator on one mesh, kept to be done again with parameters that move the new vertices and change nothing else, as a
/// slider does that is dragged: all connectivity stays, and nothing but positions is made.
class RemeshAgain {
public:
    virtual ~RemeshAgain() = default;

    /// Writes where the new vertices are, by number, to the bit as a run with these parameters has them.
    /// @return false, with nothing written, where they make another mesh than those for which the run was kept
    /// @throws as the operator does
    virtual bool place(const void* parameters, std::span<Point> to, Progress& progress) = 0;

    /// Memory held, in bytes.
    virtual std::size_t bytes() const = 0;
};

/// Keeps a run on a mesh that was done with the parameters `before`, for `now`: null where these make another mesh. Cost: less than that run.
using KeepRun = std::unique_ptr<RemeshAgain> (*)(const Mesh& mesh, const void* before, const void* now, Progress& progress);

} // namespace druse
