#include "ops/tiling.h"

#include "dlfl/errors.h"

namespace druse {

std::vector<Tiling::Orbit> Tiling::tier(int vertices)
{
    std::vector<Orbit> made;
    for (int i = 0; i < vertices; ++i) {
        made.push_back({static_cast<int>(orbits_.size())});
        orbits_.push_back({orbits_per_wedge_, vertices, i});
    }
    orbits_per_wedge_ += vertices;
    ++tiers_;
    return made;
}

Tiling::Orbit Tiling::apex()
{
    ASSERT(!apex_, "at most one apex");
    apex_ = true;
    ++tiers_;
    orbits_.push_back({0, 0, 0});
    return {static_cast<int>(orbits_.size()) - 1};
}

int Tiling::local(Spot spot, int wedge, int n) const
{
    const int w = wedges(n), i = ((wedge + spot.wedge) % w + w) % w;
    if (spot.orbit < 0) return i * edges_ + (-1 - spot.orbit);
    const Place& place = orbits_[static_cast<std::size_t>(spot.orbit)];
    if (place.stride == 0) return n + orbits_per_wedge_ * w;
    return n + place.before * w + place.stride * i + place.phase;
}

std::vector<std::vector<int>> Tiling::polygons(int n) const
{
    std::vector<std::vector<int>> all;
    if (has_top(n)) {
        all.emplace_back();
        for (int i = 0; i < wedges(n); ++i)
            for (const Orbit orbit : top_) all.back().push_back(local(orbit(0), i, n));
    }
    for (const auto& row : rows_)
        for (int i = 0; i < wedges(n); ++i) {
            all.emplace_back();
            for (const Spot spot : row) all.back().push_back(local(spot, i, n));
        }
    return all;
}

const Patch& Tiling::on(int n) const
{
    std::unique_ptr<Patch>& patch = patches_[n];
    if (patch) return *patch;
    ASSERT(n % edges_ == 0, "a base of whole wedges");
    patch = std::make_unique<Patch>(n, new_vertices(n));
    for (const auto& polygon : polygons(n)) patch->add(polygon);
    patch->connect();
    return *patch;
}

} // namespace druse
