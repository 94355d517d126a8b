#pragma once

#include "ui/view.h"

#include "app/registry.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace druse::ui {

/// A coloured cube of side 2 in a view of 400 by 400, seen from the front: its face 2 fills the middle. The bottom, face 0, is group 1,
/// the top, face 1, group 2, and the sides group 3.
class CubeView : public testing::Test {
protected:
    CubeView() : session(all_operators()), view(session)
    {
        session.on_change = [this] { view.session_changed(); };
        view.on_event = [this](const std::string& line) { events.push_back(line); };
        view.set_animated(false);
        session.open(DRUSE_MODELS "/colored_cube.obj");
        session.wait();
        view.resize(400, 400);
        view.look({0, 0});
        view.frame_all();
    }
    void arm(const char* name) { session.choose(&all_operators().get(name)); }
    void run(const std::string& command)
    {
        session.run(command);
        session.wait();
    }
    static Pointer at(double x, double y, int button = 1) { return {.x = x, .y = y, .button = button}; }
    void click(double x, double y)
    {
        view.press(at(x, y));
        view.release(at(x, y));
        session.wait();
    }
    std::string last_step() const { return session.display().steps.empty() ? "" : session.display().steps.back(); }

    Session session;
    View view;
    std::vector<std::string> events;
};

} // namespace druse::ui
