#pragma once

#include "ui/tool.h"

#include <utility>

namespace druse::ui {

/// The corner of the face under the pointer that is nearest to it in the picture.
class CornerTool : public Tool {
public:
    using Tool::Tool;
    std::optional<Target> under(const Pointer& pointer) const override;
    /// Which corner of a face a vertex is, counted from the start corner; of several the first one.
    static std::optional<int> place(const Mesh& mesh, Face f, Vertex v);
};

/// Makes the clicked corner the start corner of its face, or of all selected faces that have its vertex if the face is one of them.
class StartCornerTool : public CornerTool {
public:
    using CornerTool::CornerTool;
    void act(const Target& target, const Pointer& pointer) override;
    std::string hint() const override { return "click a corner of a face: the face starts there; dots show the selected faces' starts"; }
};

/// Takes two corners, one click each, and runs the armed operator from the first to the second.
class CornerPairTool : public CornerTool {
public:
    using CornerTool::CornerTool;
    void act(const Target& target, const Pointer& pointer) override;
    void act_on_nothing() override { first_.clear(); }
    bool take_back() override { return !std::exchange(first_, {}).empty(); }
    std::string hint() const override { return first_.empty() ? "click the first corner" : "click the second corner; first is " + first_; }

private:
    std::string first_; // FACE:K
    std::uint64_t version_ = 0;
};

} // namespace druse::ui
