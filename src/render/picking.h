#pragma once

#include "render/camera.h"
#include "render/draw_lists.h"

#include <cstdint>
#include <optional>

namespace druse {

/// Where a half line meets a face.
struct FaceHit {
    Face face;
    Point point;
    double distance = 0; // from the origin of the ray, in model units
    bool from_behind = false;
    std::uint32_t copy = 0; // which of the copies of the lists it is on, from 1; 0: none, the face itself
};

/// The face that the ray meets first, from whichever side, copies included; of faces met at the same distance the one with the lowest id. In
/// double precision, the same in every context, without a display. Sides belong to the faces beside them: no ray slips through.
/// Cost: one look at each box of 64 triangles, and at the triangles in the boxes that the ray meets.
/// Source: Möller & Trumbore, *Fast, minimum storage ray/triangle intersection* (1997).
std::optional<FaceHit> pick_face(const DrawLists& lists, const Ray& ray);

constexpr double pick_radius = 8; // pixels

/// The edge seen nearest to (x, y), at most `pick_radius` away in the picture: over a face one of its own sides (of several edges
/// between the same vertices the lowest id), over a copy none, beside the mesh any edge.
std::optional<Edge> pick_edge(const DrawLists& lists, const Camera& camera, double x, double y);

/// The vertex seen nearest to (x, y), likewise.
std::optional<Vertex> pick_vertex(const DrawLists& lists, const Camera& camera, double x, double y);

} // namespace druse
