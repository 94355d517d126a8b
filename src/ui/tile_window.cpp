#include "ui/tile_window.h"

#include "ui/dialogs.h"
#include "ui/layout.h"
#include "ui/relief_tool.h"
#include "ui/tile_dialogs.h"
#include "ui/tile_source.h"
#include "ui/type_chooser.h"
#include "ui/type_picture.h"

#include "tile/tile_solid.h"

#include <FL/Fl.H>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace druse::ui {

namespace {

// Seconds.
constexpr double tile_frame_time = 1.0 / 60;
constexpr double quick_relief = 0.006; // one that takes longer to make and to draw follows a drag in the plane when that pauses
constexpr double relief_delay = 0.15;

double now_in_seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

} // namespace

TileWindow::TileWindow(const Registry& registry, Preferences& preferences, bool test, int w, int h)
    : SourceWindow(registry, preferences, test, "tile", "Tile editor", [this](const Mesh& solid, int size) { return viewport_.picture_of(solid, size); }, w, h),
      plane_(session_), space_(session_), bar_("The type of tiling: a click chooses another, with what of the tile still fits", "Type…", 88), canvas_(plane_, [this](bool dark, double scale, Image& image) { drawing_.draw(plane_, dark, scale, image); }, 0, 0, 10, 10),
      viewport_(session_, space_, 0, 0, 10, 10), neighbours_label_(0, 0, 1, 1, "neighbours"), neighbours_(0, 0, 1, 1), history_divider_(true),
      animate_([this] { space_.animate(now_in_seconds()); }), follow_relief_([this] { follow_relief(); }), right_width_(layout().tile_side_width()),
      history_height_(layout().px(180))
{
    actions_ = make_actions();
    make_bar();
    add_parts({&bar_, &canvas_, &viewport_, &neighbours_label_, &neighbours_, &middle_, &right_divider_, &history_divider_});
    space_.set_animated(!test);

    neighbours_label_.labelsize(layout().small_font());
    neighbours_label_.align(FL_ALIGN_LEFT | FL_ALIGN_INSIDE);
    neighbours_.tooltip("The tiles around it in space: 0 hides them, 1 is touching");
    neighbours_.set_range(0, 1, 0.05);
    neighbours_.on_slide = [this](double value) { relief_.neighbours = value, follow_relief(); };
    space_.stand_in = [this]() -> const DrawLists* { return shows_mesh() ? nullptr : &relief_.lists; };
    auto tool = std::make_unique<ReliefTool>(session_, space_.camera(), plane_, relief_);
    relief_tool_ = tool.get();
    space_.use_tool(std::move(tool));

    space_.on_event = [this](const std::string& line) { event(line); };
    plane_.on_select = [this] { take_selection(); };
    canvas_.on_pointer = [this] { settle(), update_hint(); };
    viewport_.on_frame = [this](int frame) {
        event("frame " + std::to_string(frame));
        if (space_.is_animating()) animate_.start(tile_frame_time);
    };
    viewport_.on_drop = [this](const std::string& uris) { files_.drop(uris); };
    middle_.on_drag = [this](int x) { split_ = double(x) / std::max(1, this->w() - right_width_), place_parts(), redraw(); };
    right_divider_.on_drag = [this](int x) { right_width_ = this->w() - x, place_parts(), redraw(); };
    history_divider_.on_drag = [this](int y) { history_height_ = y - history_section_.y(), place_parts(), redraw(); };
    start();
}

TileWindow::~TileWindow()
{
    plane_.on_select = nullptr;
    plane_.on_redraw = nullptr;
    space_.on_event = nullptr;
    dismantle();
}

void TileWindow::show()
{
    const bool first = !shown();
    SourceWindow::show();
    if (first) viewport_.show();
    canvas_.take_focus();
}

// --- where everything is --------------------------------------------------------------------------------------------------------------

void TileWindow::place_parts()
{
    const Layout& l = layout();
    const int bar = l.button_height() + 2 * l.gap(), top = l.menu_height() + bar, bottom = h() - l.status_height(), line = l.divider();
    right_width_ = std::clamp(right_width_, l.least_side_width(), std::max(l.least_side_width(), w() / 3));
    const int room = w() - right_width_ - 2 * line;
    const int left = std::clamp(static_cast<int>(split_ * room), std::min(l.px(240), room / 2), std::max(room - l.px(240), room / 2));
    menu_->resize(0, 0, w(), l.menu_height());
    bar_.resize(0, l.menu_height(), w(), bar);
    canvas_.resize(0, top, left, bottom - top);
    middle_.resize(left, top, line, bottom - top);
    const int strip = bottom - l.row_height(), label = l.px(84), pad = l.margin();
    viewport_.resize(left + line, top, room - left, strip - top);
    neighbours_label_.resize(left + line + pad, strip, label, l.row_height());
    neighbours_.resize(left + line + pad + label, strip, std::max(1, std::min(l.px(220), room - left - label - 2 * pad)), l.row_height());
    const int side = w() - right_width_;
    right_divider_.resize(side - line, top, line, bottom - top);
    history_height_ = std::clamp(history_height_, l.px(90), std::max(l.px(90), bottom - top - l.px(220)));
    const int history = history_section_.is_open() ? history_height_ : l.header_height();
    history_section_.resize(side, top, right_width_, history);
    history_divider_.resize(side, top + history, right_width_, line);
    place_operators(side, top + history + line + l.gap(), right_width_, bottom);
    status_.resize(0, bottom, w(), l.status_height());
}

// --- following the session ------------------------------------------------------------------------------------------------------------

void TileWindow::follow_source()
{
    relief_.is_shown = !shows_mesh();
    follow_tile();
    plane_.session_changed();
    relief_tool_->go_on();
}

bool TileWindow::is_dragging() const { return plane_.is_dragging() || relief_tool_->is_raising(); }

void TileWindow::refresh_parts()
{
    space_.session_changed();
    const IsohedralType* type = plane_.tile().type;
    bar_.set_type(type ? type->name() : std::string(), [type](int height) { return type_picture(*type, height); });
}

/// The relief follows the tile; the camera frames what it has not shown yet.
void TileWindow::follow_tile()
{
    const Scene* scene = session_.scene();
    if (!scene || session_.document_version() == relief_version_) return;
    relief_version_ = session_.document_version();
    if (plane_.is_dragging() && relief_seconds_ + viewport_.frame_seconds() > quick_relief) follow_relief_.start(relief_delay);
    else follow_relief();
}

void TileWindow::follow_relief()
{
    const Scene* scene = session_.scene();
    if (!scene) {
        follow_relief_.start(relief_delay);
        return;
    }
    const double start = now_in_seconds();
    const LayeredTile* tile = layered_tile(*scene);
    relief_.follow(tile);
    relief_seconds_ = now_in_seconds() - start;
    if (!relief_tool_->is_raising()) update_status();
    if (!tile) framed_ = false;
    else if (!framed_ || shows_mesh() || tile->is_extruded() != was_extruded_) space_.frame_all(), framed_ = true;
    was_extruded_ = tile && tile->is_extruded();
    viewport_.redraw();
}

std::vector<StatusPart> TileWindow::facts() const
{
    std::vector<StatusPart> parts;
    const ShownTile& tile = plane_.tile();
    if (!tile.type) return parts;
    parts.push_back({fmt::format("{}, size {:.4g} {}", tile.type->name(), tile.size, preferences_.unit)});
    parts.push_back({fmt::format("outline {}, inside {}", tile.outline, tile.points.size() - std::size_t(tile.outline))});
    if (tile.thickness) {
        if (!relief_.trouble.empty()) parts.push_back({relief_.trouble, true});
        else if (relief_.thinnest) parts.push_back({fmt::format("thickness {:.4g}, least {:.4g}", *tile.thickness, *relief_.thinnest)});
        if (relief_.volume) parts.push_back({fmt::format("volume {:.5g} {}³", *relief_.volume, preferences_.unit)});
        if (relief_.trouble.empty() && relief_.solids > 1) parts.push_back({fmt::format("fills space with {} solids", relief_.solids)});
        else if (relief_.trouble.empty() && relief_.solids == 1) parts.push_back({"fills space"});
    }
    if (!plane_.selected().empty()) parts.push_back({fmt::format("sel {}", plane_.selected().size())});
    return parts;
}

std::string TileWindow::hint() const { return Fl::belowmouse() == &viewport_ ? space_.hint() : plane_.place_hint() + plane_.hint(); }

/// The heights of what is selected are those that the panel is about.
void TileWindow::pass_selection()
{
    if (session_.chosen() && session_.chosen()->name == "tile.height" && !plane_.selected().empty()) session_.set("points", plane_.selected_text());
}

void TileWindow::take_selection()
{
    pass_selection();
    plane_.forget_box(); // what was to be done by one is done
    space_.forget_box();
    viewport_.redraw();
    update_status();
    std::string line = "selected " + (plane_.selected().empty() ? "nothing" : plane_.selected_text());
    if (const int point = plane_.selected().size() == 1 ? plane_.tile().find(*plane_.selected().begin()) : -1;
        point >= 0 && std::uint32_t(point) < relief_.lists.vertex_limit())
        if (const auto seen = space_.camera().project(relief_.lists.position(std::uint32_t(point))))
            line += fmt::format(" seen at {:.0f},{:.0f}", viewport_.x() + seen->x, viewport_.y() + seen->y);
    event(line);
}

// --- commands -------------------------------------------------------------------------------------------------------------------------

void TileWindow::choose(const Operator& op)
{
    SourceWindow::choose(op);
    pass_selection();
}

void TileWindow::choose_type()
{
    const ShownTile& tile = plane_.tile();
    const auto type = choose_tile_type(tile.type ? tile.type->name() : std::string());
    if (!type) return;
    constexpr double usual_size = 20;
    session_.run_chosen(tile.type ? "tile.type type=" + *type : fmt::format("tile.new type={} size={}", *type, usual_size));
    session_.wait();
    plane_.frame();
    canvas_.take_focus();
}

void TileWindow::select_all(bool outline, bool inside)
{
    std::set<std::string> names;
    const ShownTile& tile = plane_.tile();
    for (std::size_t k = 0; k < tile.points.size(); ++k)
        if (int(k) < tile.outline ? outline : inside) names.insert(tile.points[k].name);
    plane_.select(std::move(names));
}

void TileWindow::set_tool(TileView::Tool tool)
{
    plane_.set_tool(tool);
    if (tool == TileView::Tool::heights && plane_.tile().type && !plane_.tile().thickness) choose_by_name("tile.extrude");
    update_hint();
    bar_.refresh();
}

/// Is there a tile? The status line says so if not.
bool TileWindow::has_tile()
{
    if (plane_.tile().type) return true;
    session_.say(Message::Kind::note, "choose a type of tile first");
    refresh();
    return false;
}

void TileWindow::ask_for_picture()
{
    if (!has_tile()) return;
    if (const auto command = ask_for_trace(plane_, session_.folder())) session_.run_chosen(*command);
    bar_.refresh();
}

void TileWindow::export_drawing()
{
    if (!has_tile()) return;
    std::filesystem::path proposal = session_.file().empty() ? session_.folder() / "tiling" : session_.file();
    if (const auto file = ask_where_to_save("Export drawing", proposal.replace_extension(".svg"))) session_.export_to(*file);
}

void TileWindow::export_tile()
{
    if (!has_tile()) return;
    const Scene* scene = session_.scene();
    if (!scene) return;
    const LayeredTile tile = *layered_tile(*scene); // as it is now: what is exported runs commands
    const auto asked = ask_how_to_export(facts(), tile_parts(tile).size());
    if (!asked) return;
    if (!asked->to_files) {
        if (make_solid(asked->command)) hand_over();
    } else if (const auto file = ask_for_solid_file()) {
        export_solids(solid_files(tile, asked->command, *file));
    }
}

bool TileWindow::is_in_view(int x, int y) const
{
    return y >= canvas_.y() && y < canvas_.y() + canvas_.h() && x < viewport_.x() + viewport_.w();
}

bool TileWindow::other_key(int key)
{
    if (key != FL_BackSpace) return false;
    plane_.remove();
    return true;
}

} // namespace druse::ui
