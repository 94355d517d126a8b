#pragma once

#include "ui/panel.h"
#include "ui/scroll_bar.h"

namespace druse::ui {

/// Widgets of one height below each other, of which it shows as many as there is room for.
class ScrollArea : public Panel {
public:
    ScrollArea();
    void add_row(Fl_Widget& row);
    void remove_row(Fl_Widget& row);
    void scroll_to_top() { bar_.set_top(0); }

    int handle(int event) override;

protected:
    void arrange() override;
    void draw() override;

private:
    ScrollBar bar_;
};

} // namespace druse::ui
