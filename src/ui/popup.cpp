#include "ui/popup.h"

#include <FL/Fl_Menu_Item.H>

namespace druse::ui {

namespace {

/// FLTK takes an `&` for the mark of a key.
std::string escaped(const std::string& label)
{
    std::string text;
    for (const char c : label) text.append(c == '&' ? 2 : 1, c);
    return text;
}

} // namespace

void show_popup(const std::vector<PopupEntry>& entries, int x, int y)
{
    std::vector<std::string> labels;
    labels.reserve(entries.size());
    std::vector<Fl_Menu_Item> items;
    for (const PopupEntry& entry : entries) {
        labels.push_back(escaped(entry.label));
        items.push_back({labels.back().c_str(), 0, nullptr, nullptr, (entry.divider ? FL_MENU_DIVIDER : 0) | (entry.run ? 0 : FL_MENU_INACTIVE), 0, 0, 0, 0});
    }
    items.push_back({nullptr, 0, nullptr, nullptr, 0, 0, 0, 0, 0});
    const Fl_Menu_Item* picked = items.data()->popup(x, y);
    if (picked) entries[std::size_t(picked - items.data())].run();
}

} // namespace druse::ui
