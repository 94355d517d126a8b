#pragma once

#include "ui/tool.h"

#include <cstdint>
#include <vector>

namespace druse::ui {

/// A brush that puts faces into a group: the one that `id` of the chosen operator names, or with Ctrl none.
///
/// A stroke is one command. The brush is a disc of the settings' radius about the pointer; it takes the face under the pointer, and
/// what lies inside the disc and hangs together with that face without turning away from the eye.
class PaintTool : public Tool {
public:
    PaintTool(Session& session, const Camera& camera, const ToolSettings& settings) : Tool(session, camera), settings_(settings) {}

    std::optional<Target> under(const Pointer& pointer) const override;
    void act(const Target& target, const Pointer& pointer) override;
    std::unique_ptr<Gesture> press(const Pointer& start, const ShowTarget& show) override;
    void preview(const Target& target, Overlay& overlay) const override;
    void add_pointer(const Pointer& pointer, Overlay& overlay) const override;
    std::string hint() const override;
    std::string pressed_hint() const override { return "release to put them into the group; Escape cancels"; }

    /// Adds to `faces` what the brush touches here and was not `taken` yet. Precondition: `taken` has a place for every face.
    void touch(const Pointer& pointer, std::vector<std::uint8_t>& taken, std::vector<Face>& faces) const;
    /// How far the pointer may go between two touches without a gap, in pixels.
    double stride() const;
    void paint(const std::vector<Face>& faces, const Pointer& pointer);
    Colour colour(const Pointer& pointer) const;
    std::uint32_t face_limit() const { return lists().face_limit(); }

private:
    bool is_armed() const;
    std::string id(const Pointer& pointer) const;

    const ToolSettings& settings_;
};

/// Puts faces into a group by dropping it on one of them.
class DropGroupTool : public Tool {
public:
    DropGroupTool(Session& session, const Camera& camera, int group) : Tool(session, camera), group_(group) {}
    std::optional<Target> under(const Pointer& pointer) const override { return face_under(pointer); }
    void act(const Target& target, const Pointer& pointer) override;
    void preview(const Target& target, Overlay& overlay) const override;
    std::string hint() const override;
    std::string pressed_hint() const override { return hint(); }

private:
    int group_;
};

} // namespace druse::ui
