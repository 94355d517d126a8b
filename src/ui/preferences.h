#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace druse::ui {

/// What the window remembers from one day to the next.
struct Preferences {
    int x = -1, y = -1, width = 0, height = 0; // of the window; 0: never shown yet
    double ui_scale = 1;
    bool dark = true;
    std::string unit = "mm";
    std::vector<std::filesystem::path> recent; // files, the newest first

    static constexpr std::size_t most_recent = 10;
    /// Puts a file at the front of the recent ones.
    void remember(const std::filesystem::path& file);

    /// Reads them; what is not there keeps its default.
    static Preferences load();
    void store() const;
};

} // namespace druse::ui
