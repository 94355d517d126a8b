#pragma once

#include "dlfl/mesh.h"
#include "geom/triangle_contact.h"

#include <vector>

namespace druse {

/// The triangles of a part of struts, to look where it meets another part.
class PartTriangles {
public:
    struct Part {
        Triangle corners;
        Shadow shadow;
        Box box;
        Face face;
    };

    void clear()
    {
        parts_.clear();
        box_ = Box();
    }
    /// Triangles without an area are passed over.
    void add(const Triangle& corners, Face face = Face())
    {
        const Shadow shadow = shadow_of(corners);
        if (shadow.turn == 0) return;
        Part part{corners, shadow, {}, face};
        for (const Point& p : corners) {
            part.box.add(p);
            box_.add(p);
        }
        parts_.push_back(part);
    }

    /// Calls f(Part, Part) for triangles of this and of another part that meet, until it returns false.
    template <class F>
    void for_each_contact(const PartTriangles& other, F&& f) const
    {
        if (!overlap(box_, other.box_)) return;
        for (const Part& a : parts_) {
            if (!overlap(a.box, other.box_)) continue;
            for (const Part& b : other.parts_)
                if (overlap(a.box, b.box) && meet_beyond_common(a.corners, a.shadow, b.corners) && !f(a, b)) return;
        }
    }

private:
    static bool overlap(const Box& a, const Box& b)
    {
        for (int k = 0; k < 3; ++k)
            if (a.min[k] > b.max[k] || b.min[k] > a.max[k]) return false;
        return true;
    }

    std::vector<Part> parts_;
    Box box_;
};

} // namespace druse
