#pragma once

#include "ui/layout.h"
#include "ui/main_window.h"
#include "ui/slider.h"
#include "ui/theme.h"

#include "app/registry.h"

#include <FL/Fl.H>

#include <gtest/gtest.h>

#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>

namespace druse::ui {

inline void at(int x, int y, int state)
{
    Fl::e_x = Fl::e_x_root = x;
    Fl::e_y = Fl::e_y_root = y;
    Fl::e_keysym = FL_Button + 1;
    Fl::e_state = state;
    Fl::e_is_click = 1;
    Fl::e_clicks = 0;
}

class Widgets : public testing::Test {
protected:
    Widgets()
    {
        set_layout(Layout(1));
        use_theme(true);
        session.emplace(all_operators());
        window.emplace(*session, preferences, MainWindow::Options{.test = true}, 1280, 800);
    }
    void run(const std::string& command)
    {
        session->run(command);
        session->wait();
    }
    void choose(const char* name) { window->choose(all_operators().get(name)); }
    void push(int x, int y, int state = 0)
    {
        at(x, y, FL_BUTTON1 | state);
        Fl::handle(FL_PUSH, &*window);
    }
    void drag(int x, int y)
    {
        at(x, y, FL_BUTTON1);
        Fl::handle(FL_DRAG, &*window);
    }
    void release(int x, int y, int state = 0)
    {
        at(x, y, state);
        Fl::handle(FL_RELEASE, &*window);
        Fl::pushed(nullptr);
        session->wait();
    }
    void click(int x, int y, int state = 0)
    {
        push(x, y, state);
        release(x, y, state);
    }
    void click_twice(int x, int y)
    {
        click(x, y);
        at(x, y, FL_BUTTON1);
        Fl::e_clicks = 1;
        Fl::handle(FL_PUSH, &*window);
        release(x, y);
    }
    void key(int key, int state, const char* text)
    {
        static char buffer[8];
        std::strncpy(buffer, text, sizeof buffer - 1);
        Fl::e_keysym = key;
        Fl::e_state = state;
        Fl::e_text = buffer;
        Fl::e_length = int(std::strlen(buffer));
        Fl::handle(FL_SHORTCUT, &*window);
        session->wait();
    }
    /// The slider in the row of a parameter.
    Slider& slider(const char* parameter, int place = -1)
    {
        ParameterRow* row = window->parameters().row(parameter, place);
        for (int i = 0; row && i < row->children(); ++i)
            if (auto* found = dynamic_cast<Slider*>(row->child(i))) return *found;
        throw std::runtime_error("no slider");
    }

    Preferences preferences;
    std::optional<Session> session;
    std::optional<MainWindow> window;
};

} // namespace druse::ui
