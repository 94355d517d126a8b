#pragma once

#include "ui/divider.h"
#include "ui/editor_window.h"
#include "ui/file_commands.h"
#include "ui/history_panel.h"
#include "ui/parameter_panel.h"
#include "ui/pictures.h"
#include "ui/plane_canvas.h"
#include "ui/preferences.h"
#include "ui/relief_picture.h"
#include "ui/section.h"
#include "ui/session.h"
#include "ui/slider.h"
#include "ui/status_bar.h"
#include "ui/tile_bar.h"
#include "ui/tile_drawing.h"
#include "ui/tile_view.h"
#include "ui/timer.h"
#include "ui/view.h"
#include "ui/viewport.h"

#include <FL/Fl_Box.H>
#include <FL/Fl_Choice.H>

#include <functional>
#include <string>

namespace druse::ui {

class ReliefTool;

/// The tile editor: a document of its own with a tile, its plane on the left, the tile in space beside it, and what operators of tiles take.
class TileWindow : public EditorWindow {
public:
    TileWindow(const Registry& registry, Preferences& preferences, bool test, int w, int h);
    ~TileWindow() override;

    void show() override;
    void resize(int x, int y, int w, int h) override;
    int handle(int event) override;

    /// One line for everything that happens, as that of the main window.
    std::function<void(const std::string&)> on_event;
    /// After every change of the session.
    std::function<void()> on_change;
    /// A tile is done: its history, which ends with its mesh.
    std::function<void(Script)> on_export;

    Session& session() override { return session_; }
    TileView& plane() { return plane_; }
    View& space() { return space_; }
    const PlaneCanvas& canvas() const { return canvas_; }
    const Viewport& viewport() const { return viewport_; }

    void open(const std::filesystem::path& file) override;
    void choose(const Operator& op) override;
    bool is_in_view(int x, int y) const override;
    /// The mesh that was made is for the main window, with the history that it comes of.
    void hand_over();
    /// Asks about unsaved work. @return true if it may go
    bool may_close() { return files_.may_leave(); }

private:
    Actions make_actions();
    void add_plane_actions(Actions& list);
    void make_bar();
    void arrange();
    void refresh();
    void refresh_panels();
    void update_hint();
    void follow_tile();
    void follow_relief();
    bool shows_mesh() const;
    std::vector<StatusPart> facts() const;
    void choose_type();
    void choose_by_name(const char* name);
    void pass_selection();
    void take_selection();
    void select_all(bool outline, bool inside);
    void set_tool(TileView::Tool tool);
    void ask_for_picture();
    void export_drawing();
    void export_tile();
    bool has_tile();
    bool make_solid(const std::string& command);
    void export_solids(const LayeredTile& tile, const std::string& command);
    void escape();
    void close();

    Preferences& preferences_;
    bool test_;
    Session session_;
    FileCommands files_;
    TileView plane_;
    View space_;
    ReliefPicture relief_;
    ReliefTool* relief_tool_ = nullptr; // the view's
    std::uint64_t relief_version_ = 0;
    bool framed_ = false, was_extruded_ = false;
    std::vector<const Operator*> operators_; // of tiles

    Registry no_operators_; // the menu has those of tiles as its own entries
    Pictures pictures_;
    TileBar bar_;
    TileDrawing drawing_; // of the plane
    PlaneCanvas canvas_;
    Viewport viewport_;
    Fl_Box neighbours_label_;
    Slider neighbours_; // in space, how large
    HistoryPanel history_;
    Section history_section_;
    Fl_Choice operator_choice_;
    ParameterPanel parameters_;
    Divider middle_, right_divider_, history_divider_;
    StatusBar status_;
    Timer show_progress_, animate_, follow_relief_, settle_;
    double relief_seconds_ = 0; // that the last one took
    bool panels_are_old_ = false;
    double split_ = 0.5; // of the room for the two views
    int right_width_, history_height_;
    bool closing_ = false;
};

} // namespace druse::ui
