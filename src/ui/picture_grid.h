#pragma once

#include "ui/panel.h"
#include "ui/scroll_bar.h"

#include <functional>
#include <optional>

namespace druse::ui {

/// Things to choose from by their pictures, in rows: arrow keys go from one to the next, a click or Enter takes one and closes the window. What a cell shows is for
/// the class that is made of it.
class PictureGrid : public Panel {
public:
    /// @param rows how many are seen at once; what is more can be scrolled to
    PictureGrid(int x, int y, int columns, int rows, int cell_width, int cell_height);

    /// What there is, and which of it is marked at first.
    void set_cells(int count, int marked);
    int marked() const { return marked_; }
    const std::optional<int>& chosen() const { return chosen_; }
    std::function<void()> on_mark; // another one is marked

    int handle(int event) override;

protected:
    void arrange() override;
    void draw() override;

    /// Draws one into its cell, whose background is done. The font is the small one.
    virtual void draw_cell(int cell, int left, int top, bool is_marked) = 0;
    /// Said where there is nothing.
    virtual const char* nothing() const { return ""; }

private:
    int cell_at(int px, int py) const;
    void mark(int cell, bool scroll);
    void show_marked();
    void take(int cell);
    bool key(int key);

    int columns_, cell_width_, cell_height_;
    int count_ = 0, marked_ = 0;
    std::optional<int> chosen_;
    ScrollBar bar_;
};

} // namespace druse::ui
