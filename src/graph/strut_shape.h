#pragma once

namespace druse {

enum class StrutScale { length, absolute };
enum class StrutFrame { automatic, normal, axis };
enum class StrutCap { flat, round, point };
enum class StrutFit { shrink, error };
enum class Crossings { error, split, ignore };
enum class Clearance { warn, thin, shrink, error, off };

/// How thick the edges of a graph become, and how they meet. Angles are in degrees.
struct StrutShape {
    double radius = 0.1;                      // of the polygons around the edges,
    StrutScale scale = StrutScale::length;    // in mean lengths of the edges at a vertex or in model units
    int sides = 6;
    double phase = 0;                         // turns every polygon about its edge,
    double twist = 0;                         // and the one at the second end further
    StrutFrame frame = StrutFrame::automatic; // what corner 0 looks to
    double ball = 1;                          // how far polygons are from their vertex, in what they need
    double gap = 0.9;                         // how much of half the angle to the nearest edge a polygon fills
    double spread = 45;                       // largest half angle of a polygon, seen from its vertex
    StrutCap cap = StrutCap::flat;            // at vertices with one edge
    StrutFit fit = StrutFit::shrink;
    Crossings crossings = Crossings::error;
    Clearance clearance = Clearance::warn;
    bool merge = true;                        // coplanar triangles of a ball become polygons
    bool triangulate = false;
};

} // namespace druse
