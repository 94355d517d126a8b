#pragma once

#include "geom/point.h"

#include <array>
#include <compare>
#include <optional>
#include <vector>

namespace druse {

/// The five convex solids whose translates fill space face to face: truncated octahedron, rhombic dodecahedron, cube, hexagonal prism, elongated
/// dodecahedron.
enum class CellKind { bcc, fcc, cube, hexprism, elongated };

/// `bcc`, `fcc`, `cube`, `hexprism`, `elongated`.
const char* name(CellKind kind);

/// A vector of a lattice, in steps along its three.
struct LatticeStep {
    int i = 0, j = 0, k = 0;

    friend auto operator<=>(const LatticeStep&, const LatticeStep&) = default;
    friend LatticeStep operator+(const LatticeStep& a, const LatticeStep& b) { return {a.i + b.i, a.j + b.j, a.k + b.k}; }
    friend LatticeStep operator-(const LatticeStep& a, const LatticeStep& b) { return {a.i - b.i, a.j - b.j, a.k - b.k}; }
    friend LatticeStep operator-(const LatticeStep& a) { return {-a.i, -a.j, -a.k}; }
};

/// One of the places where a point or an edge of an orbit lies: where its first one is, moved by a step.
struct OrbitMember {
    int orbit = 0;
    LatticeStep shift;

    friend bool operator==(const OrbitMember&, const OrbitMember&) = default;
};

/// A side of a pane: the edge of an orbit moved by a step, run through backwards or not.
struct CellSide {
    OrbitMember edge;
    bool reversed = false;
};

/// The near one of two panes (faces) that a translation carries to each other; all that is said of it holds for the far one, a translation back.
struct CellPane {
    LatticeStep translation;           // from the far pane to this one
    std::array<LatticeStep, 2> both{}; // none, and to the far one: where points inside are
    Point centre{0.0};
    Vector normal{0.0}, right{0.0}, up{0.0}; // outward; and the axes of pane coordinates, which begin at the centre
    std::vector<OrbitMember> corners;  // counter-clockwise seen from outside, the first one from the first axis on
    std::vector<Point2> outline;       // the corners in pane coordinates
    std::vector<CellSide> sides;       // side k runs from corner k to the next
};

/// A parallelohedron about the origin, with what its translates have in common: panes in pairs, and orbits of edges and corners under the lattice.
///
/// Panes are sorted by their translations, whose first coordinate that is not 0 is positive: largest x first, then y, then z. Orbits are numbered as the
/// panes, side by side, first meet them; the first edge or corner of each stands for it, and an edge orbit runs as that one is met.
struct Parallelohedron {
    struct Corner {
        Point place;
        std::vector<LatticeStep> members; // of the corners of the solid, from the first one
    };
    struct Edge {
        OrbitMember from, to;
        std::vector<LatticeStep> members;
    };

    CellKind kind = CellKind::cube;
    std::array<Vector, 3> lattice{};
    std::vector<CellPane> panes;
    std::vector<Edge> edges;
    std::vector<Corner> corners;

    Vector at(const LatticeStep& s) const { return double(s.i) * lattice[0] + double(s.j) * lattice[1] + double(s.k) * lattice[2]; }
    Point corner(const OrbitMember& c) const { return corners[static_cast<std::size_t>(c.orbit)].place + at(c.shift); }
    double volume() const; // that of a place of the lattice
};

/// `size` is how wide the cell is along x, `height` is of a hexagonal prism only. Cost: some microseconds.
/// Sources: Coxeter 1973, for the five; Howison & Séquin 2009, section 3, for the first two.
Parallelohedron make_parallelohedron(CellKind kind, double size, double height);

/// The step that a vector is, if it is one. `lattice`: three vectors that span space.
std::optional<LatticeStep> step_of(const std::array<Vector, 3>& lattice, const Vector& v);

} // namespace druse
