#pragma once

#include "geom/point.h"

#include <cstdint>
#include <span>
#include <vector>

namespace druse {

/// Finds for each of some directions the one nearest to it: by the distance of their tips, which rounding spoils at no angle. Keeps its memory.
class NearestDirections {
public:
    /// Cost: n² for a few; for many, sorted along a line, each is compared with those as near to it along that line as its nearest.
    /// Precondition: of length 1, two at least.
    void find(std::span<const Vector> directions);

    std::uint32_t operator[](std::uint32_t i) const { return nearest_[i]; }

private:
    std::vector<std::uint32_t> order_, nearest_;
    std::vector<double> place_;
};

/// Between directions of length 1, radians. Exact to the last digits also near 0 and π, where acos is not.
double angle_between(const Vector& u, const Vector& w);

} // namespace druse
