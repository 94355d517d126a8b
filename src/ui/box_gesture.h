#pragma once

#include "ui/gesture.h"
#include "ui/tool.h"

namespace druse::ui {

/// Selects what lies inside a rectangle of the picture: faces, edges or vertices whose every vertex is seen in it; or what the tool makes of it.
class BoxGesture : public Gesture {
public:
    BoxGesture(Element element, Session& session, const Camera& camera, Tool& tool, const Pointer& start)
        : element_(element), session_(session), camera_(camera), tool_(tool), start_(start), end_(start)
    {
    }
    void move(const Pointer& pointer) override { end_ = pointer; }
    void release(const Pointer& pointer) override;
    void add_to(Overlay& overlay) const override;

private:
    Element element_;
    Session& session_;
    const Camera& camera_;
    Tool& tool_;
    Pointer start_, end_;
};

} // namespace druse::ui
