#pragma once

#include "ui/cell_faults.h"
#include "ui/cell_picture.h"
#include "ui/cell_plane.h"
#include "ui/cell_selection.h"
#include "ui/cell_tool.h"
#include "ui/divider.h"
#include "ui/facts_panel.h"
#include "ui/opposite_camera.h"
#include "ui/plane_canvas.h"
#include "ui/skew_widget.h"
#include "ui/slider.h"
#include "ui/source_bar.h"
#include "ui/source_window.h"
#include "ui/view.h"
#include "ui/viewport.h"

#include <FL/Fl_Box.H>
#include <FL/Fl_Choice.H>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace druse::ui {

/// The cell editor: a document of its own with a cell that fills space by translations. On the left a pane of it, flat; beside it the cell in space, from the side
/// of that pane and from the opposite one; below the history, what operators of cells take, the skew and what holds of the cell.
/// Source: Howison & Séquin 2009, section 3.
class CellWindow : public SourceWindow {
public:
    CellWindow(const Registry& registry, Preferences& preferences, bool test, int w, int h);
    ~CellWindow() override;

    void show() override;
    void choose(const Operator& op) override;
    bool is_in_view(int x, int y) const override;

private:
    void follow_source() override;
    bool is_dragging() const override { return plane_.is_dragging() || near_tool_->is_moving() || far_tool_->is_moving() || skew_.is_dragging(); }
    void refresh_parts() override;
    std::vector<StatusPart> facts() const override;
    std::string hint() const override;
    bool cancel_gesture() override;
    void refresh_bar() override { bar_.refresh(); }
    Fl_Widget& main_part() override { return canvas_; }
    void place_parts() override;
    bool other_key(int key) override;

    Actions make_actions();
    void add_view_actions(Actions& list);
    void make_bar();
    void make_view(View& view, Viewport& port, CellTool*& tool);
    void place_views(int x, int y, int w, int bottom);
    void place_strip(int y, int bottom);

    const CellTile* cell() const { return plane_.cell() ? &*plane_.cell() : nullptr; }
    /// That on the left, which is there alone in a single view.
    Viewport& first_port() { return swapped_ ? far_port_ : near_port_; }
    void look(ViewAngles angles);
    void zoom(double factor);
    void follow_cell();
    void follow_picture();
    void redraw_views();
    std::vector<Fact> cell_facts() const;
    void tell_selection();
    void pass_selection();

    bool shows_solid() const { return shows_mesh() && !shows_cell_again_; }
    void show_cell_again();
    bool has_cell();
    bool is_pane_flat() const; // or all are, where none is shown
    void choose_kind();
    void show_pane(int pane, bool far);
    void step_pane(int by);
    void go_to_panes();
    void go_to_shape();
    void select_all();
    void start_box();
    void forget_boxes();
    void set_mode(CellTool::Mode mode);
    void set_along(CellTool::Along along);
    void set_neighbours(double shrink);
    void frame_views();
    void set_single(bool single);
    void export_cell();

    CellPlane plane_;
    CellSelection selection_;
    CellPicture picture_;
    CellFaults faults_;
    View near_, far_; // from the side of the pane, and from the opposite one
    OppositeCamera link_;
    CellTool *near_tool_ = nullptr, *far_tool_ = nullptr; // the views'
    std::uint64_t picture_version_ = 0;
    bool framed_ = false;
    bool shows_cell_again_ = false; // though a mesh was made last
    std::optional<std::pair<ViewAngles, ViewAngles>> before_pane_; // how both views saw it when a pane was turned to
    std::pair<int, int> pointed_at_{-1, -1}; // orbits of a point and of an edge, in the flat pane
    std::string told_, told_skew_; // to the event log: of the selection, and where handles are

    SourceBar bar_;
    PlaneCanvas canvas_;
    Viewport near_port_, far_port_;
    Fl_Box neighbours_label_, shells_label_;
    Slider neighbours_;
    Fl_Choice shells_;
    SkewWidget skew_;
    FactsPanel facts_panel_;
    Section skew_section_, facts_section_;
    Divider middle_, strip_divider_;
    Timer animate_, follow_picture_, look_for_faults_;
    double picture_seconds_ = 0; // that the last one took
    double split_ = 0.42;        // of the room, for the pane
    int strip_height_;
    bool swapped_ = false, single_ = false;
};

} // namespace druse::ui
