#pragma once

#include "cell/cell_point_name.h"
#include "cell/parallelohedron.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace druse {

/// A matrix, row by row.
using CellMatrix = std::array<double, 9>;

/// Detail that was put into the triangles of a pane in phase II, in the order in which it was done.
struct CellDetail {
    enum class Kind { triangle, edge, flip };

    Kind kind = Kind::triangle;
    int pane = 0;
    int triangle = 0;                     // by number: that of the pane's own triangles, sorted; parts of one that was split come behind
    std::array<double, 3> at{};           // where in the triangle: weights of its corners
    std::array<CellPointName, 2> edge{};  // or which edge, by its ends in that pane, without the pane in their names
    double t = 0.5;                       // and where on it, from the first to the second
    std::string kept{};                   // what else its file says of it, as JSON

    bool makes_point() const { return kind != Kind::flip; }
    friend bool operator==(const CellDetail&, const CellDetail&) = default;
};

/// All that a cell tile is made from, as files keep it. Positions are in the frame of the cell, before the matrix.
struct CellDesign {
    struct Pane {
        std::vector<Point2> points; // inside, in pane coordinates
        std::vector<std::vector<CellPointName>> segments; // chains of points, without the pane in their names
        friend bool operator==(const Pane&, const Pane&) = default;
    };
    /// A pane that was rolled back to phase I.
    struct Flat {
        bool keep = true;       // new points take what their neighbours were moved
        std::vector<int> fresh; // which of its points are new
        std::string kept;       // what else its file says of it, as JSON
        friend bool operator==(const Flat&, const Flat&) = default;
    };

    CellKind cell = CellKind::bcc;
    double size = 1;
    std::optional<double> height; // of a prism
    CellMatrix matrix{1, 0, 0, 0, 1, 0, 0, 0, 1};
    std::vector<Pane> panes;
    std::vector<std::vector<double>> edges; // parameters of points, by edge orbit, ascending
    int phase = 1;
    std::map<CellPointName, Vector> moved; // of points with all that the lattice makes of them; 0 where there is none
    std::vector<CellDetail> details;
    std::map<int, Flat> flat; // by pane
    std::string kept;         // what else its file says, as JSON; written back as it is

    friend bool operator==(const CellDesign&, const CellDesign&) = default;
};

} // namespace druse
