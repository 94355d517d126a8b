#pragma once

#include "ui/corner_tools.h"

#include "geom/point.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace druse::ui {

/// Takes two faces, one click each, and runs the armed operator from the first to the second. While the pointer is over the second one,
/// what it will make is drawn.
///
/// With Shift at the second click the first rung joins the corners that are nearest to the two clicks.
class FacePairTool : public CornerTool {
public:
    using CornerTool::CornerTool;
    std::optional<Target> under(const Pointer& pointer) const override;
    void act(const Target& target, const Pointer& pointer) override;
    void add_marks(Overlay& overlay) const override;
    void add_pointer(const Pointer& pointer, Overlay& overlay) const override;
    void act_on_nothing() override { first_.reset(); }
    bool take_back() override;
    std::string hint() const override;

private:
    struct Clicked {
        Face face;
        int corner = 0;            // the nearest, counted from the start corner
        std::uint64_t version = 0; // of the shape it belongs to
    };
    /// What was found out about a command before it is run.
    struct Preview {
        std::string command;
        std::uint64_t version = 0;
        std::vector<std::array<Point, 2>> lines;
        std::string failure;
    };

    bool has_first() const { return first_ && first_->version == lists().shape_version(); }
    std::optional<Clicked> clicked(const Pointer& pointer) const;
    Session::Overrides target(const Clicked& second, bool nearest) const;
    void look_ahead(const std::optional<Clicked>& second, bool nearest) const;
    Preview preview_of(const Session::Overrides& target, const Mesh& mesh) const;

    std::optional<Clicked> first_;
    mutable Preview preview_; // of what is under the pointer
};

} // namespace druse::ui
