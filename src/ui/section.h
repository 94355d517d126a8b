#pragma once

#include "ui/panel.h"

#include <functional>
#include <string>

namespace druse::ui {

/// A bar with a title over a widget; a click on the bar folds the widget away.
class Section : public Panel {
public:
    /// Takes `content` in. Its height, when it is open, is for whoever places the section.
    Section(std::string title, Fl_Widget& content);
    ~Section() override { remove(content_); } // it belongs to whoever made it

    bool is_open() const { return open_; }
    void set_open(bool open);
    std::function<void()> on_fold;
    /// A note at the right end of the bar.
    void set_note(const std::string& note);

    int handle(int event) override;

protected:
    void arrange() override;
    void draw() override;

private:
    std::string title_, note_;
    Fl_Widget& content_;
    bool open_ = true, hovered_ = false;
};

} // namespace druse::ui
