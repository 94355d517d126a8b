#include "ui/preferences.h"

#include <FL/Fl_Preferences.H>

#include <fmt/format.h>

#include <algorithm>

namespace druse::ui {

namespace {

std::string text(Fl_Preferences& prefs, const char* key, const std::string& otherwise)
{
    char* value = nullptr;
    prefs.get(key, value, otherwise.c_str());
    std::string result = value ? value : otherwise;
    std::free(value);
    return result;
}

} // namespace

void Preferences::remember(const std::filesystem::path& file)
{
    std::erase(recent, file);
    recent.insert(recent.begin(), file);
    if (recent.size() > most_recent) recent.resize(most_recent);
}

Preferences Preferences::load()
{
    Preferences p;
    Fl_Preferences prefs(Fl_Preferences::USER, "druse", "druse");
    Fl_Preferences window(prefs, "window"), files(prefs, "recent");
    window.get("x", p.x, p.x);
    window.get("y", p.y, p.y);
    window.get("width", p.width, p.width);
    window.get("height", p.height, p.height);
    window.get("scale", p.ui_scale, p.ui_scale);
    int dark = 1;
    window.get("dark", dark, dark);
    p.dark = dark != 0;
    p.unit = text(prefs, "unit", p.unit);
    for (std::size_t i = 0; i < most_recent; ++i)
        if (const std::string file = text(files, fmt::format("file{}", i).c_str(), ""); !file.empty()) p.recent.emplace_back(file);
    if (!(p.ui_scale >= 1 && p.ui_scale <= 2)) p.ui_scale = 1;
    return p;
}

void Preferences::store() const
{
    Fl_Preferences prefs(Fl_Preferences::USER, "druse", "druse");
    Fl_Preferences window(prefs, "window"), files(prefs, "recent");
    window.set("x", x);
    window.set("y", y);
    window.set("width", width);
    window.set("height", height);
    window.set("scale", ui_scale);
    window.set("dark", dark ? 1 : 0);
    prefs.set("unit", unit.c_str());
    files.deleteAllEntries();
    for (std::size_t i = 0; i < recent.size(); ++i) files.set(fmt::format("file{}", i).c_str(), recent[i].c_str());
}

} // namespace druse::ui
