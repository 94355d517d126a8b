#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace druse {

/// A 32-bit index with a type, so that a vertex passed where a face is meant does not compile.
template <class Tag>
struct Handle {
    static constexpr std::uint32_t none = 0xffffffffu;
    std::uint32_t index = none;

    constexpr Handle() = default;
    constexpr explicit Handle(std::uint32_t i) : index(i) {}

    constexpr bool valid() const { return index != none; }
    friend constexpr bool operator==(Handle, Handle) = default;
    friend constexpr auto operator<=>(Handle, Handle) = default;
};

using Vertex = Handle<struct VertexTag>;
using Edge = Handle<struct EdgeTag>;
using Corner = Handle<struct CornerTag>; // one vertex as one face sees it, and the side of the face that starts there

/// A face, or the marked face that closes an open boundary. Boundary faces are numbered apart (the top bit is set), so that
/// the ids of faces are not touched by them.
struct Face : Handle<struct FaceTag> {
    static constexpr std::uint32_t boundary_bit = 0x80000000u;

    using Handle::Handle;
    static constexpr Face boundary(std::uint32_t i) { return Face(i | boundary_bit); }
    constexpr bool is_boundary() const { return valid() && (index & boundary_bit) != 0; }
    constexpr std::uint32_t boundary_index() const { return index & ~boundary_bit; }
};

} // namespace druse

template <class Tag>
struct std::hash<druse::Handle<Tag>> {
    std::size_t operator()(druse::Handle<Tag> h) const noexcept { return h.index; }
};
