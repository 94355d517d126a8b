#pragma once

#include "ui/divider.h"
#include "ui/relief_picture.h"
#include "ui/slider.h"
#include "ui/plane_canvas.h"
#include "ui/source_bar.h"
#include "ui/source_window.h"
#include "ui/tile_drawing.h"
#include "ui/tile_view.h"
#include "ui/view.h"
#include "ui/viewport.h"

#include <FL/Fl_Box.H>

#include <string>

namespace druse::ui {

class ReliefTool;

/// The tile editor: a document of its own with a tile, its plane on the left, the tile in space beside it, and what operators of tiles take.
class TileWindow : public SourceWindow {
public:
    TileWindow(const Registry& registry, Preferences& preferences, bool test, int w, int h);
    ~TileWindow() override;

    void show() override;

    TileView& plane() { return plane_; }
    View& space() { return space_; }
    const PlaneCanvas& canvas() const { return canvas_; }
    const Viewport& viewport() const { return viewport_; }

    void choose(const Operator& op) override;
    bool is_in_view(int x, int y) const override;

private:
    void follow_source() override;
    bool is_dragging() const override;
    void refresh_parts() override;
    std::vector<StatusPart> facts() const override;
    std::string hint() const override;
    bool cancel_gesture() override { return space_.cancel() || plane_.cancel(); }
    void refresh_bar() override { bar_.refresh(); }
    Fl_Widget& main_part() override { return canvas_; }
    void place_parts() override;
    bool other_key(int key) override;

    Actions make_actions();
    void add_plane_actions(Actions& list);
    void make_bar();
    void follow_tile();
    void follow_relief();
    void choose_type();
    void pass_selection();
    void take_selection();
    void select_all(bool outline, bool inside);
    void set_tool(TileView::Tool tool);
    void ask_for_picture();
    void export_drawing();
    void export_tile();
    bool has_tile();

    TileView plane_;
    View space_;
    ReliefPicture relief_;
    ReliefTool* relief_tool_ = nullptr; // the view's
    std::uint64_t relief_version_ = 0;
    bool framed_ = false, was_extruded_ = false;

    SourceBar bar_;
    TileDrawing drawing_;
    PlaneCanvas canvas_;
    Viewport viewport_;
    Fl_Box neighbours_label_;
    Slider neighbours_; // in space, how large
    Divider middle_, right_divider_, history_divider_;
    Timer animate_, follow_relief_;
    double relief_seconds_ = 0; // that the last one took
    double split_ = 0.5; // of the room for the two views
    int right_width_, history_height_;
};

} // namespace druse::ui
