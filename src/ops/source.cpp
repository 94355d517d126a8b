#include "ops/source.h"

#include "dlfl/errors.h"

#include <fmt/format.h>

#include <iterator>

namespace druse {

namespace {

std::size_t bytes_of(std::monostate) { return 0; }

std::size_t bytes_of(const Graph& graph)
{
    const StrutTable& struts = graph.struts;
    return graph.vertices.size() * sizeof(Point) + graph.edges.size() * sizeof(graph.edges[0]) + graph.normals.size() * sizeof(Vector) +
           (struts.ball_ends.size() + struts.cap_ends.size() + struts.vertex_ids.size() + struts.edge_ids.size()) * sizeof(std::uint32_t);
}

std::size_t bytes_of(const Pane& pane) { return pane.bytes(); }
std::size_t bytes_of(const LayeredTile& tile) { return tile.bytes(); }
std::size_t bytes_of(const CellTile& cell) { return cell.bytes(); }

} // namespace

const char* name(const Source& source)
{
    static constexpr const char* names[] = {"", "graph", "pane", "tile", "cell"};
    static_assert(std::size(names) == std::variant_size_v<Source>);
    return names[source.index()];
}

std::size_t bytes(const Source& source)
{
    return std::visit([](const auto& held) { return bytes_of(held); }, source);
}

std::size_t HeldSource::Change::bytes() const
{
    std::size_t sum = other ? sizeof(Source) + druse::bytes(*other) : 0;
    for (const Pane::Change& edit : edits) sum += edit.bytes();
    return sum;
}

void HeldSource::replace_with(Source source)
{
    if (recording_ && !change_.other) {
        auto before = std::make_shared<Source>();
        if (!change_.edits.empty()) exchange(change_); // what is kept is the pane as the command found it
        change_ = {std::move(before), {}, false};
        *change_.other = std::move(now_);
    }
    now_ = std::move(source);
}

void HeldSource::begin_change()
{
    change_ = {};
    recording_ = true;
}

HeldSource::Change HeldSource::end_change()
{
    recording_ = false;
    return std::exchange(change_, {});
}

void HeldSource::exchange(Change& change)
{
    if (change.other) std::swap(now_, *change.other);
    if (change.edits.empty()) return;
    Pane& pane = std::get<Pane>(now_);
    if (change.undone)
        for (Pane::Change& edit : change.edits) pane.redo(edit);
    else
        for (std::size_t i = change.edits.size(); i-- > 0;) pane.undo(change.edits[i]);
    change.undone = !change.undone;
}

void HeldSource::roll_back()
{
    Change change = end_change();
    exchange(change);
}

void refuse_source(const Source& source, const char* wanted, const char* hint)
{
    if (*name(source) != 0) throw CommandError(fmt::format("the document holds a {}, not a {}", name(source), wanted));
    throw CommandError(fmt::format("the document holds no {}; {}", wanted, hint));
}

} // namespace druse
