#include "ui/dialogs.h"

#include "io/format.h"

#include <FL/Fl.H>
#include <FL/Fl_Color_Chooser.H>
#include <FL/Fl_Native_File_Chooser.H>
#include <FL/fl_ask.H>

namespace druse::ui {

namespace {

/// `Models\t*.{obj,stl,dlfl,druse}` and a line for each format.
std::string filters(bool all_together)
{
    std::string every, each;
    for (const Format& format : formats()) {
        every.append(format.extension).append(",");
        each.append("\n").append(format.title).append("\t*.").append(format.extension);
    }
    each += "\nHistory script\t*.druse";
    return all_together ? std::string("All models\t*.{").append(every).append("druse}").append(each) : each.substr(1);
}

std::optional<std::filesystem::path> choose(Fl_Native_File_Chooser& chooser)
{
    switch (chooser.show()) {
    case 0: return std::filesystem::path(chooser.filename());
    case -1: show_failure(chooser.errmsg()); return {};
    default: return {};
    }
}

} // namespace

std::optional<std::filesystem::path> ask_for_model(const char* title)
{
    Fl_Native_File_Chooser chooser(Fl_Native_File_Chooser::BROWSE_FILE);
    const std::string filter = filters(true);
    chooser.title(title);
    chooser.filter(filter.c_str());
    return choose(chooser);
}

std::optional<std::filesystem::path> ask_where_to_save(const char* title, const std::filesystem::path& proposed)
{
    Fl_Native_File_Chooser chooser(Fl_Native_File_Chooser::BROWSE_SAVE_FILE);
    const std::string filter = filters(false), folder = proposed.parent_path().string(), name = proposed.filename().string();
    chooser.title(title);
    chooser.filter(filter.c_str());
    chooser.options(Fl_Native_File_Chooser::NEW_FOLDER);
    if (!folder.empty()) chooser.directory(folder.c_str());
    chooser.preset_file(name.c_str());
    const auto file = choose(chooser);
    std::error_code none;
    if (file && std::filesystem::exists(*file, none) && !ask_to_replace(*file)) return {};
    return file;
}

std::optional<Colour> ask_for_colour(Colour before)
{
    uchar red = before.red, green = before.green, blue = before.blue;
    if (!fl_color_chooser("Colour", red, green, blue, 1)) return {};
    return Colour{red, green, blue};
}

std::optional<std::string> ask_for_text(const std::string& question, const std::string& before)
{
    const char* answer = fl_input("%s", before.c_str(), question.c_str());
    return answer ? std::optional<std::string>(answer) : std::nullopt;
}

Unsaved ask_about_changes(const std::string& name)
{
    switch (fl_choice("%s has changes that are not saved.", "Cancel", "Save", "Discard", name.c_str())) {
    case 1: return Unsaved::save;
    case 2: return Unsaved::discard;
    default: return Unsaved::cancel;
    }
}

Leftover ask_about_leftover(const std::filesystem::path& model)
{
    const char* question = "Druse ended before this work was saved:\n%s\n(its history lies beside it)";
    switch (fl_choice(question, "Later", "Recover", "Discard", model.c_str())) {
    case 1: return Leftover::recover;
    case 2: return Leftover::discard;
    default: return Leftover::keep;
    }
}

bool ask_to_replace(const std::filesystem::path& file)
{
    return fl_choice("%s exists already. Replace it?", "Cancel", "Replace", nullptr, file.filename().string().c_str()) == 1;
}

void show_failure(const std::string& text) { fl_alert("%s", text.c_str()); }

} // namespace druse::ui
