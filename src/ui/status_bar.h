#pragma once

#include "ui/panel.h"
#include "ui/session.h"

#include <FL/Fl_Button.H>
#include <FL/Fl_Progress.H>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace druse::ui {

/// One part of the status line.
struct StatusPart {
    std::string text;
    bool warns = false;
};
/// Counts, genus, parts, watertight or not, size and selection of what is shown.
std::vector<StatusPart> status_parts(const Display& display, const std::string& unit);

/// Something that takes its time, beside what the session does.
struct SideWork {
    std::string doing;
    double fraction = 0;
    std::function<void()> cancel;
};

/// The line at the bottom: what there is, what the mouse does or what went wrong, and how far a long job has come.
class StatusBar : public Panel {
public:
    StatusBar(Session& session, int x, int y, int w, int h);

    /// Shows what the session has now.
    void update(const std::string& unit);
    /// What the mouse does now; shown where there is no message.
    void set_hint(const std::string& hint);
    void update_progress();
    /// What to say in place of what the mesh is like.
    std::function<std::vector<StatusPart>()> parts;
    /// What goes on beside the session; nothing: nothing.
    std::function<std::optional<SideWork>()> side_work;

protected:
    void arrange() override;
    void draw() override;

private:
    std::optional<SideWork> work() const;

    Session& session_;
    std::vector<StatusPart> parts_;
    std::string hint_;
    Fl_Progress progress_;
    Fl_Button cancel_;
};

} // namespace druse::ui
