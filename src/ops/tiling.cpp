#include "ops/tiling.h"

#include "dlfl/errors.h"

namespace druse {

Tiling::Orbit Tiling::tier()
{
    orbits_.push_back({vertices_per_edge_, 1, 0});
    vertices_per_edge_ += 1;
    ++tiers_;
    return {static_cast<int>(orbits_.size()) - 1};
}

std::array<Tiling::Orbit, 2> Tiling::paired_tier()
{
    const int first = static_cast<int>(orbits_.size());
    orbits_.push_back({vertices_per_edge_, 2, 0});
    orbits_.push_back({vertices_per_edge_, 2, 1});
    vertices_per_edge_ += 2;
    ++tiers_;
    return {Orbit{first}, Orbit{first + 1}};
}

Tiling::Orbit Tiling::apex()
{
    ASSERT(single_vertices_ == 0, "at most one apex");
    orbits_.push_back({vertices_per_edge_, 0, 0});
    single_vertices_ = 1;
    ++tiers_;
    return {static_cast<int>(orbits_.size()) - 1};
}

int Tiling::local(Spot spot, int edge, int n) const
{
    const int i = ((edge + spot.offset) % n + n) % n;
    if (spot.orbit < 0) return i;
    const Place& place = orbits_[static_cast<std::size_t>(spot.orbit)];
    return n + n * place.before + place.stride * i + place.phase;
}

const Patch& Tiling::on(int n) const
{
    std::unique_ptr<Patch>& patch = patches_[n];
    if (patch) return *patch;
    patch = std::make_unique<Patch>(n, new_vertices(n));
    std::vector<int> polygon;
    if (has_top()) {
        for (int i = 0; i < n; ++i) polygon.push_back(local({top_, 0}, i, n));
        patch->add(polygon);
    }
    for (const auto& row : rows_)
        for (int i = 0; i < n; ++i) {
            polygon.clear();
            for (const Spot spot : row) polygon.push_back(local(spot, i, n));
            patch->add(polygon);
        }
    patch->connect();
    return *patch;
}

} // namespace druse
