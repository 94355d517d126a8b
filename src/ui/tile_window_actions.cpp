// What is in the menus of the tile editor, and on the strip below them.
#include "ui/tile_window.h"

#include <FL/Fl.H>

#include <tuple>

namespace druse::ui {

Actions TileWindow::make_actions()
{
    Actions list = file_actions([this] { choose_type(); }, [this] { export_tile(); }, {{.path = "File/Export drawing…", .run = [this] { export_drawing(); }}});
    list.push_back({"Edit/Remove", FL_Delete, [this] { plane_.remove(); }});
    list.push_back({.path = "Edit/Constrain by a drag", .shortcut = 'c', .run = [this] { plane_.start_constraint(), update_hint(); }, .divider = true});
    list.push_back({"Edit/Select all", 'a', [this] { select_all(true, true); }});
    list.push_back({"Edit/Select the inside", 'i', [this] { select_all(false, true); }});
    list.push_back({"Edit/Select the outline", 'o', [this] { select_all(true, false); }});
    list.push_back({"Edit/Select by a box", 'b', [this] { plane_.start_box(), space_.start_box_select(), update_hint(); }});
    list.push_back({"Edit/Select none", 0, [this] { plane_.select({}); }});
    for (const auto& [path, key, tool] : {std::tuple("Tile/Edit the plane", FL_F + 2, TileView::Tool::edit), std::tuple("Tile/Select heights", FL_F + 3, TileView::Tool::heights),
                                          std::tuple("Tile/Drag the layer above", FL_F + 4, TileView::Tool::offset)})
        list.push_back({path, key, [this, t = tool] { set_tool(t); }, [this, t = tool] { return plane_.tool() == t; }});
    list.back().divider = true;
    add_operator_actions(list, "Tile");
    add_plane_actions(list);
    return list;
}

void TileWindow::add_plane_actions(Actions& list)
{
    const auto toggle = [&](const char* path, int key, bool TileView::Shown::*what) {
        list.push_back({path, key,
                        [this, what] {
                            TileView::Shown shown = plane_.shown();
                            shown.*what = !(shown.*what);
                            plane_.set_shown(shown);
                            bar_.refresh();
                        },
                        [this, what] { return plane_.shown().*what; }});
    };
    list.push_back({"View/Frame the tile", FL_Home, [this] { plane_.frame(), space_.frame_all(); }});
    list.push_back({"View/Zoom in", '+', [this] { plane_.zoom(1.25); }});
    list.push_back({.path = "View/Zoom out", .shortcut = '-', .run = [this] { plane_.zoom(0.8); }, .divider = true});
    toggle("View/Neighbours", 'n', &TileView::Shown::neighbours);
    toggle("View/Triangles", 't', &TileView::Shown::triangles);
    toggle("View/Centres of rotation", 'r', &TileView::Shown::centres);
    toggle("View/Arrows to neighbours", 'm', &TileView::Shown::arrows);
    toggle("View/Colours of the tiling", 'l', &TileView::Shown::colours);
    toggle("View/Grid", 'g', &TileView::Shown::grid);
    toggle("View/Snap to the grid", 's', &TileView::Shown::snap);
    list.push_back({.path = "View/Tracing image…", .shortcut = 'p', .run = [this] { ask_for_picture(); }, .divider = true});
    for (const auto& [path, key, angles] : {std::tuple("View/Front", '1', ViewAngles{0, 0}), std::tuple("View/Right", '3', ViewAngles{90, 0}),
                                            std::tuple("View/Top", '7', ViewAngles{0, 90})})
        list.push_back({path, key, [this, a = angles] { space_.look(a); }});
    list.push_back({"View/Parallel", '5', [this] { space_.set_parallel(!space_.camera().parallel()); }, [this] { return space_.camera().parallel(); }});
    list.push_back({"View/Free orbit", 0, [this] { space_.set_free_orbit(!space_.is_free_orbit()); }, [this] { return space_.is_free_orbit(); }});
}

void TileWindow::make_bar()
{
    bar_.on_type = [this] { choose_type(); };
    const auto tool = [this](const char* label, const char* tip, TileView::Tool kind, bool apart) {
        bar_.add_button(label, tip, [this, kind] { set_tool(kind); }, [this, kind] { return plane_.tool() == kind; }, apart);
    };
    tool("Plane", "Click adds a point, drag moves one, c and a drag constrains, Delete removes (F2)", TileView::Tool::edit, true);
    tool("Heights", "Click points or drag a box around them, then raise them in space (F3)", TileView::Tool::heights, false);
    tool("Offset", "Drag the layer above over the tiling (F4)", TileView::Tool::offset, false);
    const auto toggle = [this](const char* label, const char* tip, bool TileView::Shown::*what, bool apart) {
        bar_.add_button(label, tip,
                        [this, what] {
                            TileView::Shown shown = plane_.shown();
                            shown.*what = !(shown.*what);
                            plane_.set_shown(shown);
                        },
                        [this, what] { return plane_.shown().*what; }, apart);
    };
    toggle("Neighbours", "Copies of the tile around it (N)", &TileView::Shown::neighbours, true);
    toggle("Triangles", "The Delaunay triangulation of the tile (T)", &TileView::Shown::triangles, false);
    toggle("Centres", "About which points the tiling turns (R)", &TileView::Shown::centres, false);
    toggle("Arrows", "Which motions lead to the neighbours (M)", &TileView::Shown::arrows, false);
    toggle("Colours", "The tiling in its colours, which tile.colors sets (L)", &TileView::Shown::colours, false);
    toggle("Grid", "Lines at round coordinates (G)", &TileView::Shown::grid, true);
    toggle("Snap", "New places are those of the grid (S)", &TileView::Shown::snap, false);
    bar_.add_button("Image…", "A picture to draw after, behind the tile", [this] { ask_for_picture(); }, [this] { return plane_.tile().look.trace.has_value(); }, true);
    bar_.add_button("Export tile…", "Make its mesh a document of the main window (Ctrl+E)", [this] { export_tile(); }, {}, false, true);
    bar_.refresh();
}

} // namespace druse::ui
