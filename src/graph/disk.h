#pragma once

namespace druse {

/// Of a graph that lies in the unit disk: what of a tessellation is at the origin, for maps that turn about it.
struct Disk {
    enum class Center { face, vertex, edge, elsewhere };

    Center center = Center::elsewhere; // elsewhere: it was moved away
    bool klein = false;                // it lies in Klein's model, where edges are straight and radii larger
    int sides = 0;                     // of the face at the centre
    int folds = 1;                     // by 1/folds of a full turn the tessellation comes upon itself; with a face at the centre
    bool mirrored = false;             // the ray from the centre through the first vertex of the face is a line of symmetry
    double turn = 0;                   // degrees from +x to that ray

    friend bool operator==(const Disk&, const Disk&) = default;
};

} // namespace druse
