#include "ops/pane_parameters.h"

#include <fmt/format.h>

namespace druse {

PaneEdge ParameterType<PaneEdge>::parse(std::string_view t, const Domain&)
{
    const auto at = t.find('~');
    try {
        if (at != std::string_view::npos) return {PointId(parse_id(t.substr(0, at))), PointId(parse_id(t.substr(at + 1)))};
    } catch (const CommandError&) {
    }
    throw CommandError("expected an edge by the ids of its ends, like 4~9");
}

std::string ParameterType<PaneEdge>::text(PaneEdge x, const Domain&) { return fmt::format("{}~{}", std::uint32_t(x.a), std::uint32_t(x.b)); }

std::vector<PointId> ParameterType<std::vector<PointId>>::parse(std::string_view t, const Domain& d)
{
    const auto pieces = split(t, ',');
    check_length(pieces.size(), d.length, "ids");
    std::vector<PointId> list;
    list.reserve(pieces.size());
    for (const auto piece : pieces) list.push_back(PointId(parse_id(piece)));
    return list;
}

Point2 ParameterType<Point2>::parse(std::string_view t, const Domain&)
{
    const auto pieces = split(t, ',');
    try {
        if (pieces.size() == 2) return {parse_number(pieces[0]), parse_number(pieces[1])};
    } catch (const CommandError&) {
    }
    throw CommandError("expected a point x,y");
}

std::vector<Point2> ParameterType<std::vector<Point2>>::parse(std::string_view t, const Domain& d)
{
    const auto pieces = split(t, ',');
    if (double(pieces.size()) < d.length.min)
        throw CommandError(fmt::format("too-few-points: expected {} numbers, found {}", d.length.text(), pieces.size()));
    if (pieces.size() % 2 != 0) throw CommandError(fmt::format("expected x and y of each point, found {} numbers", pieces.size()));
    std::vector<Point2> places;
    places.reserve(pieces.size() / 2);
    for (std::size_t i = 0; i < pieces.size(); i += 2) places.emplace_back(parse_number(pieces[i]), parse_number(pieces[i + 1]));
    return places;
}

std::vector<std::vector<Point2>> ParameterType<std::vector<std::vector<Point2>>>::parse(std::string_view t, const Domain& d)
{
    std::vector<std::vector<Point2>> lists;
    for (const std::string_view piece : split(t, ' ')) lists.push_back(ParameterType<std::vector<Point2>>::parse(piece, d));
    return lists;
}

std::string ParameterType<std::vector<std::vector<Point2>>>::text(const std::vector<std::vector<Point2>>& x, const Domain& d)
{
    std::string text;
    for (const auto& list : x) text.append(text.empty() ? "" : " ").append(list_text(list, d));
    return text;
}

} // namespace druse
