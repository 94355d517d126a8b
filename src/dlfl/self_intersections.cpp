#include "dlfl/self_intersections.h"

#include "dlfl/triangulate.h"
#include "geom/box_tree.h"
#include "geom/triangle_contact.h"

#include <array>

namespace druse {

namespace {

constexpr double gathered = 0.2, built = 0.4; // of the work, about

/// The triangles of a mesh that have an area: an array for each thing to know about them.
class Triangles {
public:
    Triangles(const Mesh& mesh, Progress& progress) : mesh_(mesh)
    {
        Triangulator triangulator;
        corners_.reserve(2 * std::size_t(mesh.vertex_count()));
        for (const Face f : mesh.faces()) {
            if (f.index % 4096 == 0) progress.step(gathered * f.index / mesh.face_limit());
            for (const auto& t : triangulator.triangles(mesh, f)) add({mesh.vertex(t[0]), mesh.vertex(t[1]), mesh.vertex(t[2])}, f);
        }
    }

    std::size_t size() const { return corners_.size(); }
    Face face(std::uint32_t i) const { return faces_[i]; }
    Shadow shadow(std::uint32_t i) const { return shadows_[i]; }
    Triangle operator[](std::uint32_t i) const
    {
        const auto& [a, b, c] = corners_[i];
        return {mesh_.position(a), mesh_.position(b), mesh_.position(c)};
    }

    std::vector<Box> boxes() const
    {
        std::vector<Box> list(size());
        for (std::uint32_t i = 0; i < size(); ++i)
            for (const Vertex v : corners_[i]) list[i].add(mesh_.position(v));
        return list;
    }

private:
    void add(const std::array<Vertex, 3>& t, Face f)
    {
        const Shadow shadow = shadow_of({mesh_.position(t[0]), mesh_.position(t[1]), mesh_.position(t[2])});
        if (shadow.turn == 0) return;
        corners_.push_back(t);
        faces_.push_back(f);
        shadows_.push_back(shadow);
    }

    const Mesh& mesh_;
    std::vector<std::array<Vertex, 3>> corners_;
    std::vector<Face> faces_;
    std::vector<Shadow> shadows_;
};

} // namespace

SelfIntersections self_intersections(const Mesh& mesh, Progress& progress, std::uint64_t most)
{
    SelfIntersections result;
    const Triangles triangles(mesh, progress);
    const BoxTree tree = [&] {
        const std::vector<Box> boxes = triangles.boxes();
        return BoxTree(boxes, progress, built);
    }();
    FaceData<bool> meets(mesh, false);
    tree.for_each_pair(progress, built, [&](std::uint32_t i, std::uint32_t j) {
        if (meet_beyond_common(triangles[i], triangles.shadow(i), triangles[j])) {
            ++result.pairs;
            meets[triangles.face(i)] = meets[triangles.face(j)] = true;
        }
        return result.pairs < most;
    });
    for (const Face f : mesh.faces())
        if (meets[f]) result.faces.push_back(f);
    return result;
}

} // namespace druse
