#pragma once

#include "ui/scroll_bar.h"

#include <FL/Fl_Group.H>

#include <string>

namespace druse::ui {

/// A list of rows of one height that scrolls; what a row shows and does is for the class that is made of it.
class ListView : public Fl_Group {
public:
    ListView(int x, int y, int w, int h);
    void resize(int x, int y, int w, int h) override;
    int handle(int event) override;

    /// The number of rows, or what they show, changed.
    void refresh();
    void scroll_to(int row);
    int current() const { return current_; }
    void set_current(int row); // −1: none

    /// Would a press at the place of the present event open a dialog?
    virtual bool asks() const { return false; }

protected:
    void draw() override;

    virtual int rows() const = 0;
    /// Draws a row into this rectangle, its background done.
    virtual void draw_row(int row, int x, int y, int w, int h) = 0;
    /// A button was pressed on a row, `x` pixels from its left end.
    virtual void press_row(int row, int x, int button, bool twice) = 0;
    /// The left button was released on the row on which it was pressed once, and did not go elsewhere in between.
    virtual void click_row(int /*row*/, int /*x*/) {}
    /// The arrow keys made another row the current one.
    virtual void go_to_row(int /*row*/) {}
    /// Enter was pressed, or the like.
    virtual void enter_row(int row) { press_row(row, 0, 1, false); }
    virtual bool is_selected(int row) const { return row == current_; }
    virtual std::string tip(int) const { return {}; }
    /// Dragging from one row, with the left button, to another place: where the pointer is now. −1: outside.
    /// @return true if something comes of it when it is released on that row, which is then marked
    virtual bool drag_row(int /*from*/, int /*to*/) { return false; }
    /// Where it was released.
    virtual void drop_row(int /*from*/, int /*to*/) {}
    /// Escape: nothing comes of it.
    virtual void cancel_drag() {}
    bool is_dragging() const { return dragging_; }
    /// Makes it the current row where it is.
    void keep_current(int row) { current_ = row; }

    int row_at(int y) const; // −1: none
    int row_top(int row) const;
    int row_height() const;
    int list_width() const;

private:
    int handle_press();
    void stop_drag();
    void handle_drag();
    void handle_release();
    int handle_key();
    void show_tip();

    ScrollBar bar_;
    std::string tip_;
    int current_ = -1, hovered_ = -1;
    int dragged_ = -1; // where the button was pressed
    int target_ = -1;  // where something would come of releasing it
    int pressed_x_ = 0, pressed_y_ = 0;
    bool dragging_ = false, pressed_twice_ = false;
};

} // namespace druse::ui
