#pragma once

#include "dlfl/mesh.h"
#include "ops/tiling.h"

#include <optional>
#include <vector>

namespace druse {

/// A solid read as an extrusion: the quotient of the solid without its base face by a turn about that face's axis.
///
/// The turn by 360°/k cuts the solid into k equal wedges, each with m = sides / k edges of the base. Re-tiling as many wedges as a
/// polygon has m edges gives the solid's shape over that polygon. Vertices that the turn carries into each other are an orbit; so
/// are faces, and each orbit of faces is a row. With m = 1 this is a tile pattern of Landreneau's thesis (2005, III); larger m
/// covers the truncated solids, which the thesis leaves open (VI).
struct SolidPattern {
    /// How a new vertex hangs over the base: beside one edge, in the mitre of a corner, or over the middle. Lengths are in base edges.
    struct Place {
        enum class Kind { edge, corner, apex };
        Kind kind = Kind::edge;
        int at = 0;          // edge or corner of the base, counted from those of the vertex's wedge; may be negative
        double along = 0;    // edge: from its start to its end as 0 … 1; corner: square to the mitre
        double out = 0;      // away from the base, in its plane
        double up = 0;
        friend bool operator==(const Place&, const Place&) = default;
    };
    /// A vertex of each wedge, in the order in which a Tiling numbers them: tier by tier from below, then by azimuth.
    struct Orbit {
        int tier = 1; // from 1
        Place place;
        std::vector<Place> apex_places;  // of the apex: its place beside each of the wedge's edges
        std::vector<Tiling::Spot> below; // its neighbours in lower tiers, or else the nearest vertex there
    };

    int sides = 0;  // p, of the base face
    int turns = 1;  // k
    int edges = 1;  // m, base edges of a wedge
    int tiers = 0;
    bool has_apex = false;
    bool mitred = false;              // some vertex hangs over a corner
    std::vector<double> wall_angles;  // interior dihedral over each base edge of a wedge, radians
    std::vector<Orbit> orbits;        // the apex last
    std::vector<std::vector<Tiling::Spot>> rows;
    static constexpr int top_row = -1;
    std::vector<int> wall_rows;       // the row over each base edge of a wedge, or top_row where that wall is the top
    std::vector<int> top;             // orbits around the top face or edge, by azimuth within a wedge

    Tiling tiling() const;
};

/// What can be chosen about a solid when it is read.
struct PatternChoice {
    std::optional<Face> base;  // else the best face with `sides`, or of all: largest turn, then most sides, then lowest id
    std::optional<int> sides;
    std::optional<int> turns;  // else the largest
    int phase = 0;             // which base edge of the wedge lies after the start corner
    bool mirror = false;
    bool exact = true;         // built-in coordinates: symmetry holds to 1e-6 of the base's edge, else to 1e-4, and is averaged
};

/// Reads a solid. Precondition: closed, one component, genus 0 (read_pattern checks and says so).
/// @throws CommandError `the solid reaches below its base face`, `the solid wraps round its axis`, `the solid is open`, and for
/// choices the solid does not offer
SolidPattern read_pattern(const Mesh& solid, const PatternChoice& choice);

} // namespace druse
