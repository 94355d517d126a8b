#include "ui/file_commands.h"

#include "ui/dialogs.h"

#include "app/command.h"
#include "ops/text.h"

#include <algorithm>

namespace druse::ui {

bool FileCommands::may_leave()
{
    if (session_.is_working()) { // what is not done yet is not part of the work
        session_.cancel();
        session_.wait();
    }
    if (!session_.is_changed()) return true;
    std::string name = session_.title();
    name.pop_back(); // the mark
    switch (ask_about_changes(name)) {
    case Unsaved::save: return save();
    case Unsaved::discard: return true;
    case Unsaved::cancel: break;
    }
    return false;
}

void FileCommands::start_over()
{
    if (may_leave()) session_.start_over();
}

void FileCommands::open()
{
    if (const auto file = ask_for_model("Open")) open(*file);
}

void FileCommands::open(const std::filesystem::path& file)
{
    if (open_elsewhere && open_elsewhere(file)) return;
    if (!may_leave()) return;
    session_.open(file);
}

std::filesystem::path FileCommands::proposal(const char* extension) const
{
    std::filesystem::path file = session_.file().empty() ? std::filesystem::current_path() / "untitled" : session_.file();
    return file.replace_extension(extension);
}

bool FileCommands::save_to(const std::filesystem::path& file)
{
    if (session_.is_working()) {
        session_.say(Message::Kind::note, "still busy with " + session_.doing() + "; Escape cancels it");
        return false;
    }
    session_.save(file);
    session_.wait();
    if (session_.message().kind == Message::Kind::error) {
        show_failure(session_.message().text);
        return false;
    }
    return true;
}

bool FileCommands::save()
{
    // Some formats know triangles only: whoever opened such a file is asked where to keep the polygons.
    const std::filesystem::path& file = session_.file();
    const auto is = [&file](const char* extension) { return file.extension() == extension; };
    if (file.empty() || is(".stl") || is(".glb") || is(".gltf") || is(".3mf")) return save_as();
    return save_to(file);
}

bool FileCommands::save_as()
{
    const auto file = ask_where_to_save("Save as", proposal(usual_extension.c_str()));
    return file && save_to(*file);
}

void FileCommands::export_copy()
{
    if (const auto file = ask_where_to_save("Export", proposal(".stl"))) session_.export_to(*file);
}

void FileCommands::drop(const std::string& uris)
{
    const auto files = files_of_uris(uris);
    if (files.empty()) return;
    if (files.size() == 1) {
        open(files[0]);
        return;
    }
    if (!may_leave()) return;
    session_.open(files[0]);
    session_.wait();
    for (std::size_t i = 1; i < files.size(); ++i) {
        session_.run("mesh.merge " + argument_text("file", files[i].string()));
        session_.wait();
    }
}

std::vector<std::filesystem::path> files_of_uris(std::string_view uris)
{
    const auto digit = [](char c) { return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1; };
    std::vector<std::filesystem::path> files;
    for (std::string_view line : split(uris, '\n')) {
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        constexpr std::string_view scheme = "file:";
        if (line.starts_with(scheme)) {
            line.remove_prefix(scheme.size());
            if (line.starts_with("//")) line.remove_prefix(std::min(line.find('/', 2), line.size()));
        }
        if (!line.starts_with('/')) continue;
        std::string path;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const bool escape = line[i] == '%' && i + 2 < line.size() && digit(line[i + 1]) >= 0 && digit(line[i + 2]) >= 0;
            path += escape ? static_cast<char>(16 * digit(line[i + 1]) + digit(line[i + 2])) : line[i];
            if (escape) i += 2;
        }
        files.emplace_back(path);
    }
    return files;
}

} // namespace druse::ui
