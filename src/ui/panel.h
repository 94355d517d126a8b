#pragma once

#include <FL/Fl_Group.H>

namespace druse::ui {

/// A group that places its children itself, instead of stretching them in proportion as FLTK does.
class Panel : public Fl_Group {
public:
    Panel(int x, int y, int w, int h) : Fl_Group(x, y, w, h)
    {
        resizable(nullptr);
    }
    void resize(int x, int y, int w, int h) override
    {
        Fl_Widget::resize(x, y, w, h);
        arrange();
    }

protected:
    /// Puts the children where they belong in x(), y(), w(), h().
    virtual void arrange() = 0;
};

} // namespace druse::ui
