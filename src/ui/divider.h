#pragma once

#include <FL/Fl_Widget.H>

#include <functional>

namespace druse::ui {

/// The line between two columns: a drag moves it, a double click folds the column away. It can be taken a little beside the line.
class Divider : public Fl_Widget {
public:
    explicit Divider(bool across = false) : Fl_Widget(0, 0, 1, 1), across_(across) {}
    std::function<void(int place)> on_drag; // wanted place in the window
    std::function<void()> on_fold;
    int handle(int event) override;

protected:
    void draw() override;

private:
    bool across_; // it lies between an upper and a lower part
    bool hovered_ = false;
};

} // namespace druse::ui
