#include "ui/facts_panel.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/fl_draw.H>

#include <fmt/format.h>

#include <utility>

namespace druse::ui {

std::vector<Fact> print_facts(const Display& display, const std::string& unit)
{
    using Tone = Fact::Tone;
    std::vector<Fact> list;
    if (!display.facts) return {{"counting", "…", Tone::plain}};
    const MeshFacts& f = *display.facts;
    if (f.counts.faces == 0) return {{"nothing to print", "", Tone::plain}};

    if (f.boundary_edges == 0) list.push_back({"watertight", "yes", Tone::good});
    else list.push_back({"watertight", fmt::format("no, {} open edges", f.boundary_edges), Tone::warning});
    list.push_back({"outward", f.volume > 0 ? "yes" : f.volume < 0 ? "no" : "no volume", f.volume > 0 ? Tone::good : Tone::warning});
    list.push_back({"parts", std::to_string(f.components), Tone::plain});
    const Vector size = f.bounds.size();
    list.push_back({"size " + unit, fmt::format("{:.4g}×{:.4g}×{:.4g}", size.x, size.y, size.z), Tone::plain});
    list.push_back({"volume", fmt::format("{:.5g} {}³", f.volume, unit), Tone::plain});
    list.push_back({"area", fmt::format("{:.5g} {}²", f.area, unit), Tone::plain});
    list.push_back({"edges", fmt::format("{:.3g} to {:.3g} {}", f.shortest_edge, f.longest_edge, unit), Tone::plain});
    const double warp = f.mean_edge > 0 ? f.max_nonplanarity / f.mean_edge : 0;
    list.push_back({"flat faces", warp < 1e-6 ? "yes" : fmt::format("off by {:.2g} {}", f.max_nonplanarity, unit), Tone::plain});
    if (f.point_spheres > 0) list.push_back({"point spheres", std::to_string(f.point_spheres), Tone::warning});
    if (f.zero_thickness_walls > 0) list.push_back({"zero-thickness walls", std::to_string(f.zero_thickness_walls), Tone::warning});
    return list;
}

void FactsPanel::show_facts(std::vector<Fact> facts)
{
    facts_ = std::move(facts);
    refresh();
}

void FactsPanel::draw_row(int row, int x, int y, int w, int h)
{
    const Layout& l = layout();
    const Fact& fact = facts_[std::size_t(row)];
    const Fl_Color tone = fact.tone == Fact::Tone::good ? theme().good : fact.tone == Fact::Tone::warning ? theme().amber : theme().text;
    fl_font(FL_HELVETICA, l.small_font());
    draw_text(fact.name, x + l.margin(), y, w - 2 * l.margin(), h, theme().faint_text);
    draw_text(fact.value, x + l.px(90), y, w - l.px(90) - l.margin(), h, tone, FL_ALIGN_RIGHT);
}

} // namespace druse::ui
