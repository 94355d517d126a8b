#pragma once

#include "ui/plane_editor.h"
#include "ui/shown_tile.h"
#include "ui/tile_offset.h"

#include "render/image.h"

#include <optional>
#include <string>

namespace druse::ui {

/// What lies under the pointer: a point, or an edge of the outline, or the inside of a copy of the tile.
struct TileHit {
    std::size_t copy = 0; // of those that are drawn
    int point = -1;       // of the tile; −1: none
    int edge = -1;        // of the outline, from this point to the next; −1: none
    bool inside = false;
    Point2 at{0.0};       // the pointer's place, pulled back to the tile

    friend bool operator==(const TileHit&, const TileHit&) = default;
};

/// A point that is dragged, where it was asked to go and could not.
struct RefusedPlace {
    std::size_t copy = 0;
    int point = 0;
    Point2 at{0.0}; // pulled back to the tile
};

/// The plane of a tile without its window: what is drawn of it, and what the mouse does.
class TileView : public PlaneEditor {
public:
    enum class Tool { edit, heights, offset };
    struct Shown {
        bool neighbours = true, triangles = true, centres = true, arrows = false, grid = true;
        bool snap = false;    // new places are those of the grid
        bool colours = false; // the tiling in its colours, instead of grey
    };

    explicit TileView(Session& session) : PlaneEditor(session) {}

    // --- what is shown ------------------------------------------------------------------------------------------------------------

    const ShownTile& tile() const { return tile_; }
    void session_changed() override;
    const Shown& shown() const { return shown_; }
    void set_shown(const Shown& shown);
    /// The picture to draw after, where there is one that can be read.
    const Image* picture() const { return picture_.width > 0 ? &picture_ : nullptr; }
    /// Another picture, or the same elsewhere, is shown until the tile changes.
    void try_trace(const std::optional<TileTrace>& trace);

    const std::optional<TileHit>& hovered() const { return hovered_; }
    const std::optional<RefusedPlace>& refused() const { return refused_; }
    /// Where the layer above would lie, while that is dragged.
    const std::optional<TileOffset>& offset() const { return offset_; }
    std::string hint() const override;
    std::string invitation() const override;

    /// The names of what is selected as a command takes them; empty if nothing is.
    std::string selected_text() const;

    // --- the mouse ----------------------------------------------------------------------------------------------------------------

    Tool tool() const { return tool_; }
    void set_tool(Tool tool);
    void hover(const Pointer& pointer) override;
    void leave() override;
    void remove() override;
    bool cancel() override;

private:
    enum class Dragged { point, offset, trace };

    TileHit hit(const Point2& picture) const;
    int point_near(const Point2& place, std::size_t copy) const;
    void move_to(const Point2& picture);
    void drag_corner_to(const Point2& at);
    void add_point(const TileHit& at);
    void drag_offset(const Point2& picture);
    void drag_trace(const Point2& picture);
    void load_picture();

    std::optional<Line> framed() const override;
    bool snaps() const override { return shown_.snap; }
    bool may_constrain() const override { return tool_ == Tool::edit; }
    Gesture begin(const Pointer& pointer) override;
    Gesture begin_drag(const Pointer& pointer) override;
    void click(const Pointer& pointer) override;
    void drag_to(const Point2& picture) override;
    void end_drag() override;
    void end_constraint(const Point2& picture) override;
    std::optional<Point2> constraint_start() const override;
    void select_box(const Point2& low, const Point2& high, const Pointer& pointer) override;
    void forget_refused() override;

    ShownTile tile_;
    std::uint64_t tile_version_ = 0;
    Shown shown_;
    Image picture_;
    std::string picture_name_; // the file it is of, or could not be read from

    Tool tool_ = Tool::edit;
    Dragged dragged_ = Dragged::point;
    TileHit grabbed_;         // what was pressed
    TilePoint grabbed_point_; // as it was then: what comes of a drag may have fewer points
    Point2 grip_{0.0};        // from the pointer to the point, pulled back
    std::optional<TileHit> hovered_;
    std::optional<TileOffset> offset_;
    Point2 offset_start_{0.0};
    TileTrace grabbed_trace_;
    std::optional<RefusedPlace> refused_;
};

} // namespace druse::ui
