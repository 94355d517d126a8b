#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace druse::ui {

/// A key with what is held down, as FLTK numbers them.
struct Key {
    int key = 0, state = 0;
    friend bool operator==(const Key&, const Key&) = default;
};

/// `Ctrl+Shift+Z`, `Escape`, `F12`, `a`; empty for a key without a name.
std::string key_text(Key key);
std::optional<Key> key_from_text(std::string_view text);

} // namespace druse::ui
