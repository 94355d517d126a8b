#pragma once

#include <optional>
#include <string>

namespace druse::ui {

/// Size and place of a window as X programs take them: `1280x800`, `1280x800+0+0`, `+0+0`.
struct Geometry {
    std::optional<int> width, height; // both or neither
    std::optional<int> x, y;          // both or neither

    /// Of an empty text: nothing given. @throws CommandError
    static Geometry parse(const std::string& text);
};

} // namespace druse::ui
