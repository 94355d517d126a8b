#pragma once

#include "ops/extrude_frame.h"
#include "ops/operator.h"
#include "ops/tiling.h"

#include <array>
#include <span>
#include <vector>

namespace druse {

/// What groups the new faces of an extrusion get: an id each, one a row, the old one, or none.
enum class NewGroups { each, rows, keep, none };
inline Words new_group_words() { return words({"each", "rows", "keep", "none"}); }

/// Which faces an extrusion acts on, and what groups it leaves behind; what every extrusion shares.
struct ExtrusionScope {
    FaceSelector faces;
    bool grouped = true;
    NewGroups groups = NewGroups::each;
};

/// The faces selected and, with `grouped`, all others of their groups; ascending. Cost: O(F) if a group is involved.
/// @throws CommandError `no faces`
std::vector<Face> collect_faces(const Scene& scene, const ExtrusionScope& scope);

/// One tiling put on many faces at once: first all positions, then one pass of connectivity, then the groups.
///
/// Nothing in the mesh changes before all positions are known, so a face that cannot be extruded leaves it as it was.
class TieredExtrusion {
public:
    /// Measures nothing yet. `faces` ascending, without repeats.
    TieredExtrusion(Mesh& mesh, std::vector<Face> faces, const Tiling& tiling);

    /// Where face number `at` and its corners are, and the memory for the positions of its new vertices.
    std::size_t size() const { return faces_.size(); }
    Face face(std::size_t at) const { return faces_[at]; }
    std::span<const Corner> ring(std::size_t at) const { return std::span(corners_).subspan(begin_[at], begin_[at + 1] - begin_[at]); }
    std::span<Point> room(std::size_t at);

    /// Puts the tiling on all faces and hands out groups. Returns the tops, or if no face got one all new faces; ascending.
    std::vector<Face> connect(NewGroups groups);

private:
    void number_groups(NewGroups groups, const std::vector<int>& old_groups, int largest, std::uint32_t first_face);

    Mesh& mesh_;
    const Tiling& tiling_;
    std::vector<Face> faces_;
    std::vector<Corner> corners_;        // face after face, from the start corner
    std::vector<std::size_t> begin_;     // of each face in corners_, and one past the last
    std::vector<std::size_t> new_begin_; // of each face's new vertices
    std::span<Point> room_;
    bool all_have_top_ = true;
};

/// Slides the top tier along `slide` onto the plane square to the base through its mean elevation.
/// @throws CommandError `face ID: cannot flatten: tier N runs level`
void flatten_top(Face face, const BaseFrame& frame, int tier, Cycle<Point> top, std::span<const Vector> slide);

/// Runs a kernel over faces, `iterations` times, each time on the tops it left.
///
/// Kernel: `Tiling tiling() const`, `double angle`, `bool mitred` (its walls meet over the corners),
/// `void place(const BaseFrame&, Point* tiers, Vector* slide) const`: writes the new vertices in the order of the tiling, and, unless
/// null, the directions in which the top's vertices slide when the top is made flat.
template <class Kernel>
std::vector<Face> extrude_faces(Mesh& mesh, std::vector<Face> faces, const Kernel& kernel, NewGroups groups, int iterations, bool flat,
                                Progress& progress)
{
    const Tiling tiling = kernel.tiling();
    FrameMaker maker(kernel.angle);
    std::vector<Vector> slide;
    for (int k = 0; k < iterations; ++k) {
        TieredExtrusion extrusion(mesh, std::move(faces), tiling);
        for (std::size_t at = 0; at < extrusion.size(); ++at) {
            if (at % 4096 == 0) progress.step((k + double(at) / double(extrusion.size())) / iterations);
            const BaseFrame& frame = maker.measure(mesh, extrusion.face(at), extrusion.ring(at), kernel.mitred);
            const std::span<Point> tiers = extrusion.room(at);
            if (flat && slide.size() < std::size_t(frame.n)) slide.resize(std::size_t(frame.n));
            kernel.place(frame, tiers.data(), flat ? slide.data() : nullptr);
            if (flat)
                flatten_top(extrusion.face(at), frame, tiling.tiers(), Cycle<Point>(tiers.data() + tiers.size() - std::size_t(frame.n), frame.n), slide);
        }
        faces = extrusion.connect(groups);
    }
    return faces;
}

/// The parameters of a tiered extrusion with a top: its kernel's own, and what all of them share.
template <class Kernel>
struct ExtrusionParameters : ExtrusionScope, Kernel {
    int iterations = 1;
    bool flat = false;
};

/// Begins the registration of an extrusion: the faces and groups that all of them share.
template <class Kernel>
Definition<ExtrusionParameters<Kernel>> define_untilted_extrusion(std::string name, std::string help)
{
    using P = ExtrusionParameters<Kernel>;
    auto definition = define<P>(std::move(name), std::move(help));
    definition.param(&P::faces, "faces", "faces to extrude")
        .param(&P::grouped, "grouped", "extrude all faces of the groups of these faces with them")
        .param(&P::groups, "groups", new_group_words(), "group ids of the new faces: one each, one a row, the old one, or none")
        .keeps_euler()
        .run([](Scene& scene, const P& p, Context& context) {
            std::vector<Face> faces = collect_faces(scene, p);
            scene.selection.edit().faces =
                extrude_faces<Kernel>(scene.mesh, std::move(faces), p, p.groups, p.iterations, p.flat, context.progress);
        });
    return definition;
}

/// Begins the registration of a tiered extrusion: also angle, heights and, for kernels with a top, iterations and flat.
template <class Kernel>
Definition<ExtrusionParameters<Kernel>> define_extrusion(std::string name, std::string help)
{
    using P = ExtrusionParameters<Kernel>;
    auto definition = define_untilted_extrusion<Kernel>(std::move(name), std::move(help));
    definition
        .param(&P::angle, "angle", Unit::degrees, {1, 179}, "interior dihedral angle between the base and the walls on its edges; 90 is upright")
        .param(&P::heights, "heights", Unit::ratio, nonzero(-100, 100), "how far each tier is moved, in mean lengths of the base edges");
    if constexpr (Kernel::has_top)
        definition.param(&P::iterations, "iterations", Unit::count, {1, 50}, "how often: each time on the tops of the time before")
            .param(&P::flat, "flat", "slide the vertices of the top into one plane");
    return definition;
}

} // namespace druse
