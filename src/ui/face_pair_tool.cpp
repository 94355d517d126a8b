#include "ui/face_pair_tool.h"

#include "ui/layout.h"

#include "ops/handle.h"

#include <fmt/format.h>

#include <algorithm>

namespace druse::ui {

namespace {

constexpr std::size_t most_lines = 5000;
constexpr double most_pairings = 4e6; // to be tried out while the pointer moves

/// Is the pairing of two faces found at once?
bool is_quick(const Mesh& mesh, Face a, Face b)
{
    const double n = mesh.valence(a), m = mesh.valence(b);
    return (n == m ? n * n : std::max(n, m) * n * m) <= most_pairings;
}

} // namespace

std::optional<FacePairTool::Clicked> FacePairTool::clicked(const Pointer& pointer) const
{
    const auto target = CornerTool::under(pointer);
    const Mesh* mesh = session_.mesh();
    if (!target || !mesh) return {};
    const auto corner = place(*mesh, *target->face, *target->vertex);
    return Clicked{*target->face, corner.value_or(0), lists().shape_version()};
}

std::optional<Target> FacePairTool::under(const Pointer& pointer) const
{
    auto target = CornerTool::under(pointer);
    look_ahead(target ? clicked(pointer) : std::nullopt, pointer.shift);
    if (target && !pointer.shift) target->vertex.reset(); // it does not matter which
    return target;
}

void FacePairTool::act(const Target&, const Pointer& pointer)
{
    const auto now = clicked(pointer);
    if (!now) return;
    if (!has_first()) first_ = now;
    else if (now->face == first_->face) first_.reset();
    else session_.apply_chosen(target(*now, pointer.shift)); // if it fails, the first face stays; else it is of a shape that is gone
}

bool FacePairTool::take_back()
{
    const bool had = has_first();
    first_.reset();
    preview_ = {};
    return had;
}

Session::Overrides FacePairTool::target(const Clicked& second, bool nearest) const
{
    Session::Overrides result{{"from", std::to_string(first_->face.index)}, {"to", std::to_string(second.face.index)}};
    if (nearest) result.push_back({"corners", fmt::format("{},{}", first_->corner, second.corner)});
    return result;
}

// --- what it will make --------------------------------------------------------------------------------------------------------

void FacePairTool::look_ahead(const std::optional<Clicked>& second, bool nearest) const
{
    const Mesh* mesh = session_.mesh();
    if (!second || !mesh || !has_first() || second->face == first_->face) {
        preview_ = {};
        return;
    }
    const Session::Overrides pair = target(*second, nearest);
    if (preview_.version == second->version && preview_.command == session_.arguments().command(pair)) return;
    preview_ = is_quick(*mesh, first_->face, second->face) ? preview_of(pair, *mesh) : Preview();
}

FacePairTool::Preview FacePairTool::preview_of(const Session::Overrides& target, const Mesh& mesh) const
{
    const Operator& op = *session_.chosen();
    Preview result{session_.arguments().command(target), lists().shape_version(), {}, {}};
    try {
        const std::shared_ptr<void> values = op.make();
        for (const Parameter& p : op.parameters) {
            const auto given = std::ranges::find(target, p.name, [](const auto& argument) { return argument.first; });
            const std::string text = given != target.end() ? given->second : session_.arguments().text(p.name);
            if (!text.empty()) p.set(values.get(), text);
        }
        Progress progress;
        result.lines = preview_band(op, values.get(), mesh, progress);
    } catch (const CommandError& e) {
        result.failure = e.what();
    }
    if (result.lines.size() > most_lines) result.lines.resize(most_lines);
    return result;
}

void FacePairTool::add_marks(Overlay& overlay) const
{
    if (has_first()) overlay.pressed.push_back(first_->face);
}

void FacePairTool::add_pointer(const Pointer& pointer, Overlay& overlay) const
{
    look_ahead(clicked(pointer), pointer.shift);
    for (const auto& [from, to] : preview_.lines) overlay.lines.push_back({from, to, overlay.highlight, 2 * layout().scale, 1});
}

std::string FacePairTool::hint() const
{
    const std::string title = session_.chosen()->title();
    if (!has_first()) return "click the first face: " + title;
    if (!preview_.failure.empty()) return preview_.failure;
    return fmt::format("click the second face: {}; Shift joins the nearest corners, Escape drops face {}", title, first_->face.index);
}

} // namespace druse::ui
