#pragma once

#include "ui/action.h"
#include "ui/menu.h"
#include "ui/session.h"

#include <FL/Fl_Double_Window.H>

#include <filesystem>
#include <memory>

namespace druse::ui {

/// What a window with a document of its own offers to those that record it, or play a recording to it.
class EditorWindow : public Fl_Double_Window {
public:
    EditorWindow(int w, int h, const char* title) : Fl_Double_Window(w, h, title) {}

    virtual Session& session() = 0;
    /// Chooses an operator and shows it; one without parameters runs.
    virtual void choose(const Operator& op) = 0;
    /// Opens a file without a question about what is there.
    virtual void open(const std::filesystem::path& file) = 0;
    /// Is that place of the window one of a view, where no button opens a menu at once?
    virtual bool is_in_view(int x, int y) const = 0;

    Menu& menu() { return *menu_; }
    const Actions& actions() const { return actions_; }

protected:
    Actions actions_;
    std::unique_ptr<Menu> menu_;
};

} // namespace druse::ui
