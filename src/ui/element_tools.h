#pragma once

#include "ui/tool.h"

namespace druse::ui {

/// The armed operator on the edge that is clicked.
class EdgeTool : public Tool {
public:
    using Tool::Tool;
    std::optional<Target> under(const Pointer& pointer) const override;
    void act(const Target& target, const Pointer& pointer) override;
    std::string hint() const override { return "click an edge: " + session_.chosen()->title(); }
};

/// The armed operator on the vertex that is clicked.
class VertexTool : public Tool {
public:
    using Tool::Tool;
    std::optional<Target> under(const Pointer& pointer) const override;
    void act(const Target& target, const Pointer& pointer) override;
    std::string hint() const override { return "click a vertex: " + session_.chosen()->title(); }
};

/// Selects what is clicked; Shift adds, Ctrl removes, a double click takes the whole group of a face.
class SelectTool : public Tool {
public:
    SelectTool(Element element, Session& session, const Camera& camera) : Tool(session, camera), element_(element) {}
    std::optional<Target> under(const Pointer& pointer) const override;
    void act(const Target& target, const Pointer& pointer) override;
    void act_on_nothing() override;
    std::string hint() const override;
    bool only_selects() const override { return true; }

private:
    Element element_;
};

} // namespace druse::ui
