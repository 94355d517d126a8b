#pragma once

#include "ui/action.h"
#include "ui/session.h"

#include <FL/Fl_Menu_Bar.H>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace druse::ui {

/// The menu an operator is in: `Extrude/Dodecahedral`, `Edit/Mesh/Transform`.
std::string menu_path(const Operator& op);

/// The menu bar, made of the actions and of every operator in the registry.
class Menu : public Fl_Menu_Bar {
public:
    Menu(const Registry& registry, const Actions& actions, int x, int y, int w, int h);

    std::function<void(const Operator&)> on_operator;
    std::function<void(const std::string& path)> on_pick; // any entry, before it acts

    /// Brings the marks of the toggles up to date.
    void refresh();
    /// Does what the entry at that path does. @return false if there is none
    bool pick(const std::string& path);
    /// Opens the menu of that name below the bar, as a click on its title does.
    const std::vector<std::string>& paths() const { return paths_; }

protected:
    void draw() override;

private:
    struct Entry {
        Menu* menu;
        const Action* action;
        const Operator* op;
        std::string path;
    };
    void add_entry(const Action* action, const Operator* op, const std::string& path, int shortcut, int flags);
    void run(const Entry& entry);

    std::vector<std::unique_ptr<Entry>> entries_;
    std::vector<std::string> paths_;
};

} // namespace druse::ui
