// What is in the menus of the cell editor, and on the strip below them.
#include "ui/cell_window.h"

#include <FL/Fl.H>

#include <tuple>

namespace druse::ui {

Actions CellWindow::make_actions()
{
    Actions list = file_actions([this] { choose_kind(); }, [this] { export_cell(); });
    list.push_back({"Edit/Remove", FL_Delete, [this] { plane_.remove(); }});
    list.push_back({.path = "Edit/Constrain by a drag", .shortcut = 'c', .run = [this] { plane_.start_constraint(), update_hint(); }, .divider = true});
    list.push_back({"Edit/Select by a box", 'b', [this] { start_box(); }});
    list.push_back({"Edit/Select all", 'a', [this] { select_all(); }});
    list.push_back({"Edit/Select none", 0, [this] { plane_.select({}), selection_.clear(); }});
    list.push_back({"Cell/Phase 1: panes…", FL_F + 2, [this] { go_to_panes(); }, [this] { return cell() && is_pane_flat(); }});
    list.push_back({"Cell/Phase 2: shape", FL_F + 3, [this] { go_to_shape(); }, [this] { return cell() && !is_pane_flat(); }});
    list.push_back({"Cell/Next pane", ']', [this] { step_pane(1); }});
    list.push_back({"Cell/Previous pane", '[', [this] { step_pane(-1); }});
    list.push_back({.path = "Cell/The whole cell", .run = [this] { show_pane(-1, false); }, .divider = true});
    for (const auto& [path, key, mode] : {std::tuple("Cell/Move points", FL_F + 4, CellTool::Mode::select), std::tuple("Cell/Split triangles and edges", FL_F + 5, CellTool::Mode::split),
                                          std::tuple("Cell/Flip edges", FL_F + 6, CellTool::Mode::flip)})
        list.push_back({path, key, [this, m = mode] { set_mode(m); }, [this, m = mode] { return near_tool_ && near_tool_->mode() == m; }});
    list.back().divider = true;
    for (const auto& [path, key, along] : {std::tuple("Cell/Along the radius", 'r', CellTool::Along::radial), std::tuple("Cell/Along the normal of the pane", 'v', CellTool::Along::normal),
                                           std::tuple("Cell/Along x", 'x', CellTool::Along::x), std::tuple("Cell/Along y", 'y', CellTool::Along::y), std::tuple("Cell/Along z", 'z', CellTool::Along::z)})
        list.push_back({path, key, [this, a = along] { set_along(a); }, [this, a = along] { return near_tool_ && near_tool_->along() == a; }});
    list.back().divider = true;
    add_operator_actions(list, "Cell");
    add_view_actions(list);
    return list;
}

void CellWindow::add_view_actions(Actions& list)
{
    const auto toggle = [&](const char* path, int key, bool CellPlane::Shown::*what) {
        list.push_back({path, key,
                        [this, what] {
                            CellPlane::Shown shown = plane_.shown();
                            shown.*what = !(shown.*what);
                            plane_.set_shown(shown);
                            bar_.refresh();
                        },
                        [this, what] { return plane_.shown().*what; }});
    };
    list.push_back({"View/Frame the cell", FL_Home, [this] { plane_.frame(), frame_views(); }});
    list.push_back({"View/Zoom in", '+', [this] { zoom(1.25); }});
    list.push_back({.path = "View/Zoom out", .shortcut = '-', .run = [this] { zoom(0.8); }, .divider = true});
    toggle("View/Triangles", 't', &CellPlane::Shown::triangles);
    toggle("View/Colours of orbits", 'o', &CellPlane::Shown::orbits);
    toggle("View/Grid", 'g', &CellPlane::Shown::grid);
    toggle("View/Snap to the grid", 's', &CellPlane::Shown::snap);
    list.back().divider = true;
    list.push_back({"View/Swap the two views", 'd', [this] {
                        swapped_ = !swapped_;
                        single_ ? set_single(true) : place_parts();
                        redraw();
                    }, [this] { return swapped_; }});
    list.push_back({"View/A single view", FL_SHIFT + 'd', [this] { set_single(!single_); }, [this] { return single_; }});
    list.push_back({.path = "View/Turn both together", .shortcut = 'l', .run = [this] { link_.set_linked(!link_.is_linked()), bar_.refresh(); },
                    .is_on = [this] { return link_.is_linked(); }, .divider = true});
    list.push_back({.path = "View/Neighbours", .shortcut = 'n', .run = [this] {
                        constexpr double opened = 0.7;
                        neighbours_.value(neighbours_.value() > 0 ? 0 : opened);
                        neighbours_.redraw();
                        set_neighbours(neighbours_.value());
                    }, .is_on = [this] { return neighbours_.value() > 0; }, .divider = true});
    for (const auto& [path, key, angles] : {std::tuple("View/Front", int('1'), ViewAngles{0, 0}), std::tuple("View/Back", FL_CTRL + '1', ViewAngles{180, 0}),
                                            std::tuple("View/Right", int('3'), ViewAngles{90, 0}), std::tuple("View/Left", FL_CTRL + '3', ViewAngles{-90, 0}),
                                            std::tuple("View/Top", int('7'), ViewAngles{0, 90}), std::tuple("View/Bottom", FL_CTRL + '7', ViewAngles{0, -90})})
        list.push_back({path, key, [this, a = angles] { look(a); }});
    list.push_back({"View/Parallel", '5', [this] {
                        const bool parallel = !near_.camera().parallel();
                        for (View* view : {&near_, &far_}) view->set_parallel(parallel);
                    }, [this] { return near_.camera().parallel(); }});
    list.push_back({"View/Free orbit", 0, [this] {
                        const bool free = !near_.is_free_orbit();
                        for (View* view : {&near_, &far_}) view->set_free_orbit(free);
                    }, [this] { return near_.is_free_orbit(); }});
}

void CellWindow::make_bar()
{
    bar_.on_type = [this] { choose_kind(); };
    bar_.add_button("1 Panes…", "The pane that is shown is flat: points and lines are edited on the left (F2)", [this] { go_to_panes(); }, [this] { return cell() && is_pane_flat(); }, true);
    bar_.add_button("2 Shape", "Points move in space (F3)", [this] { go_to_shape(); }, [this] { return cell() && !is_pane_flat(); });
    const auto mode = [this](const char* label, const char* tip, CellTool::Mode kind, bool apart) {
        bar_.add_button(label, tip, [this, kind] { set_mode(kind); }, [this, kind] { return near_tool_ && near_tool_->mode() == kind; }, apart);
    };
    mode("Move", "Click points, and drag them in space (F4)", CellTool::Mode::select, true);
    mode("Split", "A click splits a triangle or an edge (F5)", CellTool::Mode::split, false);
    mode("Flip", "A click turns an edge into the other diagonal (F6)", CellTool::Mode::flip, false);
    const auto along = [this](const char* label, const char* tip, CellTool::Along way, bool apart) {
        bar_.add_button(label, tip, [this, way] { set_along(way); }, [this, way] { return near_tool_ && near_tool_->along() == way; }, apart);
    };
    along("Radial", "The arrow goes from the centre through the point that was picked last (R)", CellTool::Along::radial, true);
    along("Normal", "The arrow goes along the normal of the pane (V)", CellTool::Along::normal, false);
    along("X", "The arrow goes along x (X)", CellTool::Along::x, false);
    along("Y", "The arrow goes along y (Y)", CellTool::Along::y, false);
    along("Z", "The arrow goes along z (Z)", CellTool::Along::z, false);
    const auto toggle = [this](const char* label, const char* tip, bool CellPlane::Shown::*what, bool apart) {
        bar_.add_button(label, tip,
                        [this, what] {
                            CellPlane::Shown shown = plane_.shown();
                            shown.*what = !(shown.*what);
                            plane_.set_shown(shown);
                        },
                        [this, what] { return plane_.shown().*what; }, apart);
    };
    toggle("Triangles", "The triangulation of the pane (T)", &CellPlane::Shown::triangles, true);
    toggle("Orbits", "Sides of the pane in the colours of their orbits (O)", &CellPlane::Shown::orbits, false);
    toggle("Grid", "Lines at round coordinates (G)", &CellPlane::Shown::grid, false);
    toggle("Snap", "New places are those of the grid (S)", &CellPlane::Shown::snap, false);
    bar_.add_button("Linked", "Both views turn together (L)", [this] { link_.set_linked(!link_.is_linked()); }, [this] { return link_.is_linked(); }, true);
    bar_.add_button("Export cell…", "Make its mesh a document of the main window (Ctrl+E)", [this] { export_cell(); }, {}, false, true);
    bar_.refresh();
}

} // namespace druse::ui
