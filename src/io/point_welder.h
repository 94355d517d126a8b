#pragma once

#include "dlfl/column.h"
#include "dlfl/mesh_builder.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

namespace druse {

/// Gives points at exactly the same place, in single precision, one vertex. Cost: O(1) for each.
class PointWelder {
public:
    explicit PointWelder(MeshBuilder& builder) : builder_(builder) { make_slots(1u << 12); }

    /// The vertex at `p`; the first point at its place says where exactly that is.
    std::uint32_t vertex(const Point& p)
    {
        // Adding 0 makes −0 of the same bits as 0.
        const std::array<float, 3> place{static_cast<float>(p.x) + 0.0f, static_cast<float>(p.y) + 0.0f,
                                         static_cast<float>(p.z) + 0.0f};
        std::uint32_t at = slot_of(place);
        while (slots_[at].vertex != Vertex::none) {
            if (slots_[at].place == place) return slots_[at].vertex;
            at = (at + 1) & mask_;
        }
        const std::uint32_t v = builder_.add_vertex(p);
        slots_.set(at, {place, v});
        if (2 * std::uint64_t(v) > mask_) grow();
        return v;
    }

private:
    struct Slot {
        std::array<float, 3> place;
        std::uint32_t vertex;
    };
    std::uint32_t slot_of(const std::array<float, 3>& place) const;
    void make_slots(std::uint32_t count);
    void grow();

    MeshBuilder& builder_;
    Column<Slot> slots_; // a power of two, at most about half of them taken
    std::uint32_t mask_ = 0;
};

inline std::uint32_t PointWelder::slot_of(const std::array<float, 3>& place) const
{
    std::uint64_t low = 0;
    std::uint32_t high = 0;
    std::memcpy(&low, place.data(), 8);
    std::memcpy(&high, place.data() + 2, 4);
    std::uint64_t h = (low ^ (std::uint64_t(high) * 0x9E3779B97F4A7C15u)) * 0xD6E8FEB86659FD93u;
    h ^= h >> 32;
    h *= 0xD6E8FEB86659FD93u;
    return static_cast<std::uint32_t>(h >> 32) & mask_;
}

inline void PointWelder::make_slots(std::uint32_t count)
{
    slots_ = Column<Slot>();
    std::fill_n(slots_.extend(count), count, Slot{{}, Vertex::none});
    mask_ = count - 1;
}

inline void PointWelder::grow()
{
    const Column<Slot> old = std::move(slots_);
    make_slots(4 * (mask_ + 1));
    for (const Slot& slot : old.view()) {
        if (slot.vertex == Vertex::none) continue;
        std::uint32_t at = slot_of(slot.place);
        while (slots_[at].vertex != Vertex::none) at = (at + 1) & mask_;
        slots_.set(at, slot);
    }
}

} // namespace druse
