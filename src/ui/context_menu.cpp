#include "ui/context_menu.h"

#include "ui/main_window.h"
#include "ui/popup.h"

#include "render/picking.h"

#include <FL/Fl.H>

#include <fmt/format.h>

#include <string>
#include <vector>

namespace druse::ui {

namespace {

std::vector<PopupEntry> entries_at(MainWindow& window, const Pointer& p)
{
    Session& session = window.session();
    View& view = window.view();
    const DrawLists& lists = session.display().lists;
    std::vector<PopupEntry> list;
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
    show_popup(entries_at(window, pointer), Fl::event_x(), Fl::event_y());
}

} // namespace druse::ui
