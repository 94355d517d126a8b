#pragma once

// How points, segments and places of a pane are parameters.

#include "ops/parameter.h"
#include "pane/pane.h"

#include <vector>

namespace druse {

template <>
struct ParameterType<PointId> {
    static constexpr auto type = Parameter::Type::id;
    static PointId parse(std::string_view t, const Domain&) { return PointId(parse_id(t)); }
    static std::string text(PointId x, const Domain&) { return std::to_string(std::uint32_t(x)); }
};

template <>
struct ParameterType<SegmentId> {
    static constexpr auto type = Parameter::Type::id;
    static SegmentId parse(std::string_view t, const Domain&) { return SegmentId(parse_id(t)); }
    static std::string text(SegmentId x, const Domain&) { return std::to_string(std::uint32_t(x)); }
};

template <>
struct ParameterType<PaneEdge> {
    static constexpr auto type = Parameter::Type::id;
    static PaneEdge parse(std::string_view t, const Domain&);
    static std::string text(PaneEdge x, const Domain&);
};

template <>
struct ParameterType<std::vector<PointId>> {
    static constexpr auto type = Parameter::Type::integers;
    static std::vector<PointId> parse(std::string_view t, const Domain& d);
    static std::string text(const std::vector<PointId>& x, const Domain& d) { return list_text(x, d); }
};

template <>
inline constexpr int fixed_length<Point2> = 2;
template <>
struct ParameterType<Point2> {
    static constexpr auto type = Parameter::Type::point;
    static Point2 parse(std::string_view t, const Domain&);
    static std::string text(const Point2& x, const Domain&) { return number_text(x.x) + "," + number_text(x.y); }
};

/// Places, two numbers each. What is too large is left to the pane, which refuses it by its own word.
template <>
struct ParameterType<std::vector<Point2>> {
    static constexpr auto type = Parameter::Type::numbers;
    static std::vector<Point2> parse(std::string_view t, const Domain& d);
    static std::string text(const std::vector<Point2>& x, const Domain& d) { return list_text(x, d); }
};

/// Several such lists, with blanks between them.
template <>
struct ParameterType<std::vector<std::vector<Point2>>> {
    static constexpr auto type = Parameter::Type::numbers;
    static constexpr bool repeated = true;
    static std::vector<std::vector<Point2>> parse(std::string_view t, const Domain& d);
    static std::string text(const std::vector<std::vector<Point2>>& x, const Domain& d);
};

} // namespace druse
