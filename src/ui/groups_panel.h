#pragma once

#include "ui/group_list.h"
#include "ui/panel.h"
#include "ui/session.h"
#include "ui/slider.h"
#include "ui/view.h"

#include <FL/Fl_Button.H>

#include <functional>
#include <memory>
#include <vector>

namespace druse::ui {

/// The palette of face groups: the list, buttons for what is done with groups, and the brush that paints faces with one of them.
class GroupsPanel : public Panel {
public:
    GroupsPanel(Session& session, View& view, int x, int y, int w, int h);
    void update(); // shows what the session has now

    GroupList& list() { return list_; }

    // What buttons and menu entries do.
    void make_group();     // of the selected faces
    void select();         // the faces of the chosen group
    void clear();          // takes the selected faces out of their groups
    void default_colours();
    void toggle_brush();
    bool has_brush() const { return session_.chosen() == &brush_operator(); }
    void resize_brush(double by); // pixels
    /// Runs after the brush has become another, or its size.
    std::function<void()> on_change;

protected:
    void arrange() override;
    void draw() override;

private:
    Fl_Button& add_button(const char* label, const char* tip, void (GroupsPanel::*press)());
    const Operator& brush_operator() const;
    void paint_with(const std::string& id);
    void ask_colour() { list_.ask_colour(); }
    int buttons_height() const;

    Session& session_;
    View& view_;
    GroupList list_;
    std::vector<std::unique_ptr<Fl_Button>> buttons_;
    Fl_Button *plus_, *select_, *clear_, *colour_, *paint_, *defaults_;
    Slider size_;
    int largest_ = 0;           // id, when a new group was asked for
    bool awaits_group_ = false; // it shall be chosen when it is there
};

} // namespace druse::ui
