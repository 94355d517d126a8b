#include "ui/main_actions.h"

#include "ui/main_window.h"
#include "ui/palette.h"

#include <FL/Fl.H>

#include <set>

namespace druse::ui {

namespace {

constexpr double brush_step = 8; // pixels

/// A toggle of something in the style.
template <class Get, class Set>
Action style_toggle(MainWindow& window, const char* path, int shortcut, Get get, Set set)
{
    View& view = window.view();
    return {.path = path,
            .shortcut = shortcut,
            .run =
                [&view, get, set] {
                    Style style = view.style();
                    set(style, !get(style));
                    view.set_style(style);
                },
            .is_on = [&view, get] { return get(view.style()); }};
}

Action looking(MainWindow& window, const char* path, int shortcut, ViewAngles angles)
{
    View& view = window.view();
    return {.path = path, .shortcut = shortcut, .run = [&view, angles] { view.look(angles); }};
}

Action command(MainWindow& window, const char* path, int shortcut, const char* text)
{
    Session& session = window.session();
    return {.path = path, .shortcut = shortcut, .run = [&session, text] { session.run(text); }};
}

Action element(MainWindow& window, const char* path, int shortcut, Element kind)
{
    View& view = window.view();
    return {.path = path,
            .shortcut = shortcut,
            .run = [&view, kind] { view.set_element(kind); },
            .is_on = [&view, kind] { return view.element() == kind; }};
}

void add_file_actions(Actions& list, MainWindow& w)
{
    FileCommands& files = w.files();
    list.push_back({"File/New", FL_CTRL + 'n', [&files] { files.start_over(); }});
    list.push_back({"File/Open…", FL_CTRL + 'o', [&files] { files.open(); }});
    list.push_back({.path = "File/Open recent…", .run = [&w] { show_recent_files(w); }, .divider = true});
    list.push_back({"File/Save", FL_CTRL + 's', [&files] { files.save(); }});
    list.push_back({"File/Save as…", FL_CTRL + FL_SHIFT + 's', [&files] { files.save_as(); }});
    list.push_back({"File/Export…", FL_CTRL + 'e', [&files] { files.export_copy(); }});
    list.push_back({.path = "File/Screenshot…", .shortcut = FL_F + 12, .run = [&w] { w.save_screenshot(); }, .divider = true});
    list.push_back({"File/Quit", FL_CTRL + 'q', [&w] { w.quit(); }});
}

void add_edit_actions(Actions& list, MainWindow& w)
{
    Session& session = w.session();
    list.push_back({"Edit/Undo", FL_CTRL + 'z', [&session] { session.undo(); }});
    list.push_back({"Edit/Redo", FL_CTRL + FL_SHIFT + 'z', [&session] { session.redo(); }});
    list.push_back({"Edit/Repeat on the selection", ' ', [&session] { session.repeat(); }});
    list.push_back({"Edit/Preferences…", 0, [&w] { w.edit_preferences(); }});
    list.push_back({.path = "Edit/Command palette…", .shortcut = FL_CTRL + 'p', .run = [&w] { show_palette(w); }, .divider = true});
}

void add_select_actions(Actions& list, MainWindow& w)
{
    View& view = w.view();
    Session& session = w.session();
    list.push_back(command(w, "Select/All", 'a', "select.faces faces=all"));
    list.push_back(command(w, "Select/None", 0, "select.faces faces=none"));
    list.push_back(command(w, "Select/Inverse", FL_CTRL + 'i', "select.invert"));
    list.push_back({"Select/Same group", 'g', [&session] {
                        // The groups of all selected faces.
                        const Display& display = session.display();
                        std::set<int> groups;
                        for (const Face f : display.selection->faces) groups.insert(display.lists.group(f));
                        std::string text;
                        for (const int group : groups) text += (text.empty() ? "group:" : "+group:") + std::to_string(group);
                        session.run("select.faces faces=" + (text.empty() ? "selected" : text));
                    }});
    list.push_back(command(w, "Select/More", ']', "select.grow"));
    list.push_back(command(w, "Select/Less", '[', "select.shrink"));
    list.push_back({.path = "Select/Box", .shortcut = 'b', .run = [&view] { view.start_box_select(); }, .divider = true});
    list.push_back(element(w, "Select/Faces by click", FL_F + 2, Element::face));
    list.push_back(element(w, "Select/Edges by click", FL_F + 3, Element::edge));
    list.push_back(element(w, "Select/Vertices by click", FL_F + 4, Element::vertex));
    list.back().divider = true;
}

void add_group_actions(Actions& list, MainWindow& w)
{
    GroupsPanel& groups = w.groups();
    list.push_back({"Group/New group of the selection", 0, [&groups] { groups.make_group(); }});
    list.push_back({"Group/Take the selection out", 0, [&groups] { groups.clear(); }});
    list.push_back({"Group/Select the chosen group", 0, [&groups] { groups.select(); }});
    list.push_back({"Group/Colour of the chosen group…", 0, [&groups] { groups.list().ask_colour(); }});
    list.push_back({"Group/Name of the chosen group", 0, [&groups] { groups.list().rename(); }});
    list.push_back({.path = "Group/Default colours", .run = [&groups] { groups.default_colours(); }, .divider = true});
    list.push_back({"Group/Paint faces", 'p', [&groups] { groups.toggle_brush(); }, [&groups] { return groups.has_brush(); }});
    list.push_back({"Group/Larger brush", '.', [&groups] { groups.resize_brush(brush_step); }});
    list.push_back({.path = "Group/Smaller brush", .shortcut = ',', .run = [&groups] { groups.resize_brush(-brush_step); }, .divider = true});
}

void add_tile_actions(Actions& list, MainWindow& w)
{
    list.push_back({"Tile/Tile editor", FL_F + 6, [&w] { w.tile_editor(); }});
    list.push_back({.path = "Tile/Cell editor", .shortcut = FL_F + 7, .run = [&w] { w.cell_editor(); }, .divider = true});
}

void add_view_actions(Actions& list, MainWindow& w)
{
    View& view = w.view();
    list.push_back({"View/Frame all", FL_Home, [&view] { view.frame_all(); }});
    list.push_back({"View/Frame selection", 'f', [&view] { view.frame_selection(); }});
    list.push_back({"View/Zoom in", '+', [&view] { view.zoom(1.25); }});
    list.push_back({.path = "View/Zoom out", .shortcut = '-', .run = [&view] { view.zoom(0.8); }, .divider = true});
    list.push_back(looking(w, "View/Front", '1', {0, 0}));
    list.push_back(looking(w, "View/Back", FL_CTRL + '1', {180, 0}));
    list.push_back(looking(w, "View/Right", '3', {90, 0}));
    list.push_back(looking(w, "View/Left", FL_CTRL + '3', {-90, 0}));
    list.push_back(looking(w, "View/Top", '7', {0, 90}));
    list.push_back(looking(w, "View/Bottom", FL_CTRL + '7', {0, -90}));
    list.push_back({.path = "View/Parallel",
                    .shortcut = '5',
                    .run = [&view] { view.set_parallel(!view.camera().parallel()); },
                    .is_on = [&view] { return view.camera().parallel(); }});
    list.push_back({.path = "View/Free orbit",
                    .run = [&view] { view.set_free_orbit(!view.is_free_orbit()); },
                    .is_on = [&view] { return view.is_free_orbit(); },
                    .divider = true});
    list.push_back(style_toggle(w, "View/Edges", 'e', [](const Style& s) { return s.edges; }, [](Style& s, bool on) { s.edges = on; }));
    list.push_back(style_toggle(w, "View/Wireframe", 'w', [](const Style& s) { return s.wireframe; }, [](Style& s, bool on) { s.wireframe = on; }));
    SmoothPreview& smooth = view.smooth();
    list.push_back({.path = "View/Smooth preview",
                    .shortcut = 's',
                    .run = [&smooth] { smooth.set_on(!smooth.is_on()); },
                    .is_on = [&smooth] { return smooth.is_on(); }});
    list.push_back(style_toggle(w, "View/Smooth shading", 0, [](const Style& s) { return s.shading == Style::Shading::smooth; },
                                [](Style& s, bool on) { s.shading = on ? Style::Shading::smooth : Style::Shading::flat; }));
    list.push_back(style_toggle(w, "View/Back faces", FL_SHIFT + 'b', [](const Style& s) { return s.back_faces; }, [](Style& s, bool on) { s.back_faces = on; }));
    list.push_back(style_toggle(w, "View/Transparent", 'x', [](const Style& s) { return s.see_through; }, [](Style& s, bool on) { s.see_through = on; }));
    list.back().divider = true;
    list.push_back({.path = "View/Side panels",
                    .shortcut = FL_Tab,
                    .run = [&w] { w.fold_sides(); },
                    .is_on = [&w] { return !w.sides_are_folded(); }});
    list.push_back({"View/Full screen", FL_F + 11, [&w] { w.full_screen(); }});
    list.push_back({"View/Log…", 0, [&w] { w.show_log(); }});
}

} // namespace

Actions main_actions(MainWindow& window)
{
    Actions list;
    add_file_actions(list, window);
    add_edit_actions(list, window);
    add_select_actions(list, window);
    add_group_actions(list, window);
    add_tile_actions(list, window);
    add_view_actions(list, window);
    list.push_back({"Help/This operator", FL_F + 1, [&window] { window.show_help(); }});
    return list;
}

} // namespace druse::ui
