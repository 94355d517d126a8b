#include "ui/context_menu.h"

#include "ui/main_window.h"

#include "render/picking.h"

#include <FL/Fl.H>
#include <FL/Fl_Menu_Item.H>

#include <fmt/format.h>

#include <functional>
#include <string>
#include <vector>

namespace druse::ui {

namespace {

struct Entry {
    std::string label;
    std::function<void()> run;
    bool divider = false;
};

std::vector<Entry> entries_at(MainWindow& window, const Pointer& p)
{
    Session& session = window.session();
    View& view = window.view();
    const DrawLists& lists = session.display().lists;
    std::vector<Entry> list;
    if (const auto hit = pick_face(lists, view.camera().ray(p.x, p.y))) {
        const std::uint32_t face = hit->face.index;
        const int group = lists.group(hit->face);
        const Operator* op = session.chosen();
        if (op && acts_on_click(*op) && op->find("faces"))
            list.push_back({fmt::format("{} on face {}", op->title(), face), [&session, face] { session.apply_chosen({{"faces", std::to_string(face)}}); }, true});
        list.push_back({fmt::format("Select face {}", face), [&session, face] { session.run(fmt::format("select.faces faces={}", face)); }});
        if (group > 0)
            list.push_back({fmt::format("Select group {}", group), [&session, group] { session.run(fmt::format("select.faces faces=group:{}", group)); }});
        list.push_back({"Put the selection into a new group", [&session] { session.run("group.assign faces=selected id=new"); }, true});
    }
    list.push_back({"Select all", [&session] { session.run("select.faces faces=all"); }});
    list.push_back({"Select none", [&session] { session.run("select.faces faces=none"); }, true});
    list.push_back({"Frame all", [&view] { view.frame_all(); }});
    list.push_back({"Frame selection", [&view] { view.frame_selection(); }});
    return list;
}

} // namespace

void show_context_menu(MainWindow& window, const Pointer& pointer)
{
    const std::vector<Entry> entries = entries_at(window, pointer);
    std::vector<Fl_Menu_Item> items;
    for (const Entry& entry : entries) items.push_back({entry.label.c_str(), 0, nullptr, nullptr, entry.divider ? FL_MENU_DIVIDER : 0, 0, 0, 0, 0});
    items.push_back({nullptr, 0, nullptr, nullptr, 0, 0, 0, 0, 0});
    const Fl_Menu_Item* picked = items.data()->popup(Fl::event_x(), Fl::event_y());
    if (picked) entries[std::size_t(picked - items.data())].run();
}

} // namespace druse::ui
