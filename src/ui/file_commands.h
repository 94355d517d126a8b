#pragma once

#include "ui/session.h"

#include <filesystem>
#include <functional>
#include <string>

namespace druse::ui {

/// What the File menu does: asks for names, asks about unsaved work, and hands the rest to the session.
class FileCommands {
public:
    explicit FileCommands(Session& session) : session_(session) {}

    /// Of files that have no name yet.
    std::string usual_extension = ".obj";
    /// Opens a file that is none for this document somewhere else. @return true if it has done so
    std::function<bool(const std::filesystem::path&)> open_elsewhere;

    void start_over();
    void open();
    void open(const std::filesystem::path& file);
    bool save();
    bool save_as();
    void export_copy();
    /// `uris` as dropped: one file opens, more are merged as further parts.
    void drop(const std::string& uris);
    /// Asks about unsaved work. @return true if it may go
    bool may_leave();

private:
    bool save_to(const std::filesystem::path& file);
    std::filesystem::path proposal(const char* extension) const;

    Session& session_;
};

/// The files in a `text/uri-list`: one a line, percent-decoded, `file:` and the host taken off. Other lines are left out.
std::vector<std::filesystem::path> files_of_uris(std::string_view uris);

} // namespace druse::ui
