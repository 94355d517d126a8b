#include "ui/menu.h"

#include "ui/layout.h"
#include "ui/operator_tree.h"
#include "ui/theme.h"

#include <FL/fl_draw.H>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace druse::ui {

namespace {

constexpr std::array<const char*, 14> order{"File",     "Edit", "Make",  "Select", "Group", "Extrude", "Remesh",
                                            "Topology", "Rind", "Graph", "Tile",   "Cell",  "View",    "Help"};

/// The path with the letter marked that opens its menu with Alt.
std::string with_mnemonic(const std::string& path)
{
    constexpr std::pair<std::string_view, std::size_t> unusual[] = {{"Extrude/", 1}, {"Rind/", 1}, {"Graph/", 2}, {"Tile/", 2}};
    std::size_t at = 0;
    for (const auto& [menu, letter] : unusual)
        if (path.starts_with(menu)) at = letter;
    return path.substr(0, at).append("&").append(path, at);
}

/// What the File and Edit menus offer in their own way.
bool has_own_entry(const Operator& op) { return op.kind == Operator::Kind::travel || op.name == "document.open"; }

} // namespace

std::string menu_path(const Operator& op)
{
    const std::string family = op.family(), title = family_title(family);
    for (const char* of_edit : {"document", "mesh", "face", "check"})
        if (family == of_edit) return "Edit/" + title + "/" + op.title();
    for (const char* of_tile : {"pane", "tile", "cell"})
        if (family == of_tile) return "Tile/" + title + "/" + op.title();
    return title + "/" + op.title();
}

Menu::Menu(const Registry& registry, const Actions& actions, int x, int y, int w, int h) : Fl_Menu_Bar(x, y, w, h)
{
    box(FL_FLAT_BOX);
    color(theme().header);
    textsize(layout().font());
    selection_color(theme().accent);
    // Menus in the order of the page; a family that none of them is for gets one of its own before View.
    std::vector<std::string> titles(order.begin(), order.end());
    for (const Operator& op : registry.operators()) {
        const std::string path = menu_path(op), title = path.substr(0, path.find('/'));
        if (std::find(titles.begin(), titles.end(), title) == titles.end()) titles.insert(titles.end() - 2, title);
    }
    for (const std::string& title : titles) {
        for (const Action& action : actions)
            if (action.path.starts_with(title + "/")) {
                const int flags = (action.is_on ? FL_MENU_TOGGLE : 0) | (action.divider ? FL_MENU_DIVIDER : 0);
                add_entry(&action, nullptr, action.path, action.shortcut, flags);
            }
        for (const Operator& op : registry.operators())
            if (const std::string path = menu_path(op); path.starts_with(title + "/") && !has_own_entry(op)) add_entry(nullptr, &op, path, 0, 0);
    }
    refresh();
}

void Menu::add_entry(const Action* action, const Operator* op, const std::string& path, int shortcut, int flags)
{
    entries_.push_back(std::make_unique<Entry>(Entry{this, action, op, path}));
    paths_.push_back(path);
    add(with_mnemonic(path).c_str(), shortcut, [](Fl_Widget*, void* data) {
        const auto* entry = static_cast<const Entry*>(data);
        entry->menu->run(*entry);
    }, entries_.back().get(), flags);
}

void Menu::run(const Entry& entry)
{
    if (on_pick) on_pick(entry.path);
    if (entry.action) entry.action->run();
    else if (on_operator) on_operator(*entry.op);
    refresh();
}

bool Menu::pick(const std::string& path)
{
    for (const auto& entry : entries_)
        if (entry->path == path) {
            run(*entry);
            return true;
        }
    return false;
}

void Menu::refresh()
{
    for (int i = 0; i < size(); ++i) {
        const Fl_Menu_Item& item = menu()[i];
        if (!item.label() || !item.user_data()) continue;
        const auto* entry = static_cast<const Entry*>(item.user_data());
        if (!entry->action || !entry->action->is_on) continue;
        const bool on = entry->action->is_on();
        mode(i, on ? item.flags | FL_MENU_VALUE : item.flags & ~FL_MENU_VALUE);
    }
}

void Menu::draw()
{
    Fl_Menu_Bar::draw();
    fl_color(theme().border);
    fl_xyline(x(), y() + h() - 1, x() + w() - 1);
}

} // namespace druse::ui
