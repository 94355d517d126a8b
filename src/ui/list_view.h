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

protected:
    void draw() override;

    virtual int rows() const = 0;
    /// Draws a row into this rectangle, its background done.
    virtual void draw_row(int row, int x, int y, int w, int h) = 0;
    /// A button was pressed on a row, `x` pixels from its left end.
    virtual void press_row(int row, int x, int button, bool twice) = 0;
    /// Enter was pressed, or the like.
    virtual void enter_row(int row) { press_row(row, 0, 1, false); }
    virtual bool is_selected(int row) const { return row == current_; }
    virtual std::string tip(int) const { return {}; }
    /// Dragging from one row, with the left button, to another place: where it was released. −1: outside.
    virtual void drop_row(int /*from*/, int /*to*/) {}

    int row_at(int y) const; // −1: none
    int row_height() const;

private:
    int list_width() const;
    void show_tip();

    ScrollBar bar_;
    std::string tip_;
    int current_ = -1, hovered_ = -1, dragged_ = -1;
};

} // namespace druse::ui
