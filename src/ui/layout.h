#pragma once

#include <cmath>

namespace druse::ui {

/// Every size of the window, in pixels; the only place with such numbers. Set once, before the first widget is made.
struct Layout {
    double scale = 1;
    explicit Layout(double s = 1) : scale(s) {}

    int px(double n) const { return static_cast<int>(std::lround(n * scale)); }

    int font() const { return px(13); }
    int small_font() const { return px(12); }

    int window_width() const { return px(1280); }
    int window_height() const { return px(800); }
    int least_width() const { return px(960); }
    int least_height() const { return px(640); }

    /// The side columns in a window of that width.
    int left_width(int window) const { return window < px(1100) ? px(256) : px(288); }
    int right_width(int window) const { return window < px(1100) ? px(216) : px(252); }
    int tile_side_width() const { return px(256); } // of the tile editor
    int least_side_width() const { return px(200); }
    int least_view_width() const { return px(320); }
    int tree_height() const { return px(300); }

    int menu_height() const { return px(28); }
    int status_height() const { return px(28); }
    int header_height() const { return px(28); }
    int row_height() const { return px(26); } // of a parameter, with the gap below it
    int control_height() const { return px(22); }
    int line_height() const { return px(22); } // in lists
    int button_height() const { return px(26); }

    int margin() const { return px(10); }
    int gap() const { return px(6); }
    int divider() const { return px(1); }
    int radius() const { return px(4); }

    int label_width() const { return px(88); }
    int field_width() const { return px(66); }
    int least_slider_width() const { return px(48); }
    int knob() const { return px(12); }
    int track() const { return px(4); }
    int swatch() const { return px(12); }
    int check() const { return px(14); }
    int scrollbar() const { return px(12); }
    int progress_width() const { return px(120); }
    int small_picture() const { return px(20); } // of a solid, in a line of a list
    int header_picture() const { return px(42); }
    int picture() const { return px(64); }
    int gallery_columns() const { return 9; }
    int palette_width() const { return px(520); }
    int palette_lines() const { return 12; }

    // In the view.
    int gizmo_radius() const { return px(34); }
    int gizmo_margin() const { return px(18); }
    double pick_radius() const { return 8 * scale; } // how far a vertex or edge may be from the pointer
    double click_slop() const { return 4 * scale; }  // a press that moves no farther is a click
};

/// The sizes in use.
const Layout& layout();
void set_layout(const Layout& l);

} // namespace druse::ui
