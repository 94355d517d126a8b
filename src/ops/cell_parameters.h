#pragma once

// How points, edges and triangles of a cell are parameters.

#include "cell/cell_point_name.h"
#include "cell/parallelohedron.h"
#include "ops/pane_parameters.h"

#include <string>
#include <vector>

namespace druse {

class CellTile;
class Mesh;
struct Selection;

template <>
struct ParameterType<CellPointName> {
    static constexpr auto type = Parameter::Type::text;
    static CellPointName parse(std::string_view t, const Domain&) { return CellPointName::parse(t); }
    static std::string text(const CellPointName& x, const Domain&) { return x.text(); }
};

/// A vector in space: all three of its numbers.
struct SpaceVector {
    Vector v{0.0};
};
template <>
struct ParameterType<SpaceVector> {
    static constexpr auto type = Parameter::Type::point;
    static SpaceVector parse(std::string_view t, const Domain& d);
    static std::string text(const SpaceVector& x, const Domain& d) { return ParameterType<Vector>::text(x.v, d); }
};

/// Names of points in one pane, as `v0,i0`.
struct CellPath {
    std::vector<CellPointName> points;
};
template <>
struct ParameterType<CellPath> {
    static constexpr auto type = Parameter::Type::texts;
    static CellPath parse(std::string_view t, const Domain& d);
    static std::string text(const CellPath& x, const Domain& d);
};

/// A triangle of a pane, as `p3:7`.
struct CellTriangle {
    int pane = 0, triangle = 0;
};
template <>
struct ParameterType<CellTriangle> {
    static constexpr auto type = Parameter::Type::text;
    static CellTriangle parse(std::string_view t, const Domain& d);
    static std::string text(const CellTriangle& x, const Domain& d);
};

/// Points of a cell: names, or `all`, `outline` (corners and points of edges), `interior`, `none` and `selected`, which are the selected vertices of the mesh that
/// cell.solid made of the cell as it is, by number.
struct CellPoints {
    std::vector<std::string> words;

    /// In the order in which they are named, each perhaps more than once; of an orbit the one that is named or selected, else the first.
    /// @throws CommandError where there is no such point, none is selected, or the mesh is not that solid
    std::vector<OrbitMember> resolve(const CellTile& tile, const Mesh& mesh, const Selection& selection) const;
};
template <>
struct ParameterType<CellPoints> {
    static constexpr auto type = Parameter::Type::texts;
    static CellPoints parse(std::string_view t, const Domain& d);
    static std::string text(const CellPoints& x, const Domain& d);
};

} // namespace druse
