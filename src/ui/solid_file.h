#pragma once

#include <filesystem>
#include <string>

namespace druse::ui {

/// The command that makes a solid, and the file it goes to.
struct SolidFile {
    std::string command;
    std::filesystem::path file;
};

} // namespace druse::ui
