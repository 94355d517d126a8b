#pragma once

#include "ui/view.h"

#include "render/renderer.h"

#include <FL/Fl_Gl_Window.H>

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace druse::ui {

/// The 3D view as a window: it turns FLTK's events into those of View, and draws with Renderer in a core context of its own.
class Viewport : public Fl_Gl_Window {
public:
    Viewport(Session& session, View& view, int x, int y, int w, int h);
    ~Viewport() override;

    void show() override;
    void hide() override;
    int handle(int event) override;

    std::function<void(int frame)> on_frame;
    /// Files were dropped on the view.
    std::function<void(const std::string& uris)> on_drop;
    /// Why there is no picture; empty if there is one.
    const std::string& reason() const { return reason_; }
    /// The name of the driver; empty before the first frame.
    std::string driver() const;
    /// How long the last frame took.
    double frame_seconds() const { return frame_seconds_; }
    /// What is shown, without widgets, `factor` times as large.
    Image picture(int factor, bool transparent);
    /// A solid by itself, `size` pixels wide and high, without a background; nothing while there is no context yet.
    /// @throws SystemError if there will be none
    std::optional<Image> picture_of(const Mesh& solid, int size);

protected:
    void draw() override;
    void flush() override;

private:
    bool make_renderer();
    void report_missing(const std::string& reason);

    Session& session_;
    View& view_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<Renderer> solids_; // another one, so that the mesh stays where it is while a solid is drawn
    std::string reason_;
    int frame_ = 0, samples_ = 0;
    double frame_seconds_ = 0;
    bool dropped_ = false;
};

} // namespace druse::ui
