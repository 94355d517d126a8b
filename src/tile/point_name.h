#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>

namespace druse {

/// How a point of a layered tile is called: `v0` a corner, `e0:2` the second point of path 0, `e0:2m` its mirror image on a path that is the same
/// backwards, `m1` the middle of path 1, `i5` a point inside. Several edges may have the same path: without more, the first of them is meant, and
/// `e0:2@3` is the point on edge 3.
struct PointName {
    enum class Kind : std::uint8_t { corner, path, mirrored, middle, interior };

    Kind kind = Kind::corner;
    int path = 0;  // of points of a path
    int index = 0; // from 0: of corners, of points inside, and of points in a path
    int edge = -1; // of points of a path, where it is not the first with that path

    static PointName corner(int k) { return {Kind::corner, 0, k, -1}; }
    static PointName interior(int i) { return {Kind::interior, 0, i, -1}; }

    /// @throws CommandError where it is no name of a point
    static PointName parse(std::string_view text);
    std::string text() const;
    bool is_of_path() const { return kind == Kind::path || kind == Kind::mirrored || kind == Kind::middle; }

    friend auto operator<=>(const PointName&, const PointName&) = default;
};

} // namespace druse
