#include "ui/status_bar.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/fl_draw.H>

#include <fmt/format.h>

#include <algorithm>

namespace druse::ui {

std::vector<StatusPart> status_parts(const Display& display, const std::string& unit)
{
    std::vector<StatusPart> parts;
    const Counts& c = display.counts;
    parts.push_back({fmt::format("V {}  E {}  F {}", c.vertices, c.edges, c.faces)});
    if (const auto& f = display.facts; f && c.vertices > 0) {
        std::string genus = fmt::format("genus {}", f->genus);
        if (f->components > 1 && f->components <= 4) {
            for (std::size_t i = 0; i < f->component_genus.size(); ++i) genus += fmt::format("{}{}", i == 0 ? " (" : ", ", f->component_genus[i]);
            genus += ")";
        }
        parts.push_back({genus});
        parts.push_back({fmt::format("parts {}", f->components)});
        if (c.faces > 0) {
            if (f->boundary_edges == 0) parts.push_back({"watertight"});
            else parts.push_back({fmt::format("{} open edges", f->boundary_edges), true});
            const Vector size = f->bounds.size();
            parts.push_back({fmt::format("{:.4g}×{:.4g}×{:.4g} {}", size.x, size.y, size.z, unit)});
        }
    }
    const Selection& s = *display.selection;
    if (!s.faces.empty() || (s.edges.empty() && s.vertices.empty())) parts.push_back({fmt::format("sel {}", s.faces.size())});
    if (!s.edges.empty()) parts.push_back({fmt::format("sel edges {}", s.edges.size())});
    if (!s.vertices.empty()) parts.push_back({fmt::format("sel vertices {}", s.vertices.size())});
    return parts;
}

StatusBar::StatusBar(Session& session, int x, int y, int w, int h)
    : Panel(x, y, w, h), session_(session), progress_(0, 0, 1, 1), cancel_(0, 0, 1, 1, "@#-31+")
{
    end();
    box(FL_FLAT_BOX);
    color(theme().header);
    progress_.box(FL_THIN_DOWN_BOX);
    progress_.color(theme().sunken, theme().accent);
    progress_.minimum(0);
    progress_.maximum(1);
    progress_.hide();
    cancel_.label("×");
    cancel_.box(FL_FLAT_BOX);
    cancel_.color(theme().header);
    cancel_.tooltip("Cancel (Escape)");
    cancel_.callback([](Fl_Widget*, void* p) {
        if (const auto work = static_cast<StatusBar*>(p)->work()) work->cancel();
    }, this);
    cancel_.hide();
    arrange();
}

/// What a person may be waiting for.
std::optional<SideWork> StatusBar::work() const
{
    if (session_.is_working()) return SideWork{session_.doing(), session_.fraction(), [this] { session_.cancel(); }};
    return side_work ? side_work() : std::nullopt;
}

void StatusBar::arrange()
{
    const Layout& l = layout();
    const int size = h() - 2 * l.gap();
    cancel_.resize(x() + w() - l.margin() - size, y() + l.gap(), size, size);
    progress_.resize(cancel_.x() - l.gap() - l.progress_width(), y() + l.gap(), l.progress_width(), size);
}

void StatusBar::update(const std::string& unit)
{
    parts_ = parts ? parts() : status_parts(session_.display(), unit);
    if (!work()) {
        progress_.hide();
        cancel_.hide();
    }
    redraw();
}

void StatusBar::set_hint(const std::string& hint)
{
    if (hint == hint_) return;
    hint_ = hint;
    redraw();
}

void StatusBar::update_progress()
{
    const auto present = work();
    if (!present) return;
    progress_.value(static_cast<float>(present->fraction));
    progress_.show();
    cancel_.show();
    redraw();
}

void StatusBar::draw()
{
    const Layout& l = layout();
    fl_color(theme().header);
    fl_rectf(x(), y(), w(), h());
    fl_color(theme().border);
    fl_xyline(x(), y(), x() + w() - 1);

    fl_font(FL_HELVETICA, l.small_font());
    int at = x() + l.margin();
    for (const StatusPart& part : parts_) {
        const int width = static_cast<int>(fl_width(part.text.c_str()) + 1);
        draw_text(part.text, at, y(), width, h(), part.warns ? theme().amber : theme().text);
        at += width + l.margin();
        fl_color(theme().border);
        fl_yxline(at, y() + l.px(8), y() + h() - l.px(8));
        at += l.margin();
    }
    const int right = progress_.visible() ? progress_.x() - l.gap() : x() + w() - l.margin();
    const Message& message = session_.message();
    const bool error = message.kind == Message::Kind::error && !message.text.empty();
    const auto present = progress_.visible() ? work() : std::nullopt;
    const std::string& text = present ? present->doing : message.text.empty() ? hint_ : message.text;
    draw_text(text, at, y(), right - at, h(), error && !progress_.visible() ? theme().error : theme().faint_text);
    draw_children();
}

} // namespace druse::ui
