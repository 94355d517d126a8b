#pragma once

#include "ui/panel.h"
#include "ui/session.h"
#include "ui/view.h"

#include <FL/Fl_Button.H>

#include <memory>
#include <string>
#include <vector>

namespace druse::ui {

/// The strip over the view: the document's name, what clicks select, and how the mesh is drawn.
class ViewBar : public Panel {
public:
    ViewBar(Session& session, View& view, int x, int y, int w, int h);
    void refresh();

protected:
    void arrange() override;
    void draw() override;

private:
    struct Switch {
        std::unique_ptr<Fl_Button> button;
        std::function<void()> press;
        std::function<bool()> is_on;
        std::function<std::string()> trouble = {}; // why it has no effect though it is on; empty: it has
    };
    Switch& add_switch(const char* label, const char* tip, std::function<void()> press, std::function<bool()> is_on);
    void add_element(const char* label, const char* tip, Element element);

    Session& session_;
    View& view_;
    std::vector<Switch> switches_;
    std::string title_;
};

} // namespace druse::ui
