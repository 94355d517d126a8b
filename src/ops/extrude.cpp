#include "ops/extrude.h"

#include "dlfl/errors.h"
#include "geom/sort_unique.h"
#include "ops/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace druse {

std::vector<Face> collect_faces(const Scene& scene, const ExtrusionScope& scope)
{
    std::vector<Face> faces = scope.faces.resolve(scene);
    if (faces.empty()) throw CommandError("no faces");
    if (!scope.grouped) return faces;

    std::vector<int> groups;
    for (const Face f : faces)
        if (const int g = scene.mesh.group(f); g != 0 && (groups.empty() || groups.back() != g)) groups.push_back(g);
    if (groups.empty()) return faces;
    sort_unique(groups);
    std::vector<Face> all;
    std::size_t at = 0;
    for (const Face f : scene.mesh.faces()) {
        const bool given = at < faces.size() && faces[at] == f;
        if (given) ++at;
        if (given || std::ranges::binary_search(groups, scene.mesh.group(f))) all.push_back(f);
    }
    return all;
}

TieredExtrusion::TieredExtrusion(Mesh& mesh, std::vector<Face> faces, const Tiling& tiling)
    : mesh_(mesh), tiling_(tiling), faces_(std::move(faces))
{
    begin_.reserve(faces_.size() + 1);
    new_begin_.reserve(faces_.size() + 1);
    begin_.push_back(0);
    new_begin_.push_back(0);
    corners_.reserve(4 * faces_.size());
    for (const Face f : faces_) {
        for (const Corner c : mesh_.corners(f)) corners_.push_back(c);
        const std::size_t n = corners_.size() - begin_.back();
        begin_.push_back(corners_.size());
        new_begin_.push_back(new_begin_.back() + static_cast<std::size_t>(tiling_.new_vertices(static_cast<int>(n))));
        all_have_top_ = all_have_top_ && tiling_.has_top(static_cast<int>(n));
    }
    room_ = mesh_.vertex_room(new_begin_.back());
}

std::span<Point> TieredExtrusion::room(std::size_t at) { return room_.subspan(new_begin_[at], new_begin_[at + 1] - new_begin_[at]); }

std::vector<Face> TieredExtrusion::connect(NewGroups groups)
{
    if (faces_.empty()) return {};
    std::vector<const Patch*> patches(faces_.size());
    std::size_t last_n = 0;
    for (std::size_t at = 0; at < faces_.size(); ++at) {
        const std::size_t n = begin_[at + 1] - begin_[at];
        patches[at] = n == last_n ? patches[at - 1] : &tiling_.on(static_cast<int>(n));
        last_n = n;
    }
    std::vector<int> old_groups;
    old_groups.reserve(faces_.size());
    for (const Face f : faces_) old_groups.push_back(mesh_.group(f));

    const std::uint32_t first_face = mesh_.face_limit();
    const int largest = groups == NewGroups::each || groups == NewGroups::rows ? mesh_.largest_group() : 0;
    mesh_.replace_faces(faces_, patches);
    if (groups != NewGroups::keep) number_groups(groups, old_groups, largest, first_face);
    if (all_have_top_) return std::move(faces_);
    std::vector<Face> tops;
    for (std::size_t at = 0; at < faces_.size(); ++at)
        if (tiling_.has_top(static_cast<int>(begin_[at + 1] - begin_[at]))) tops.push_back(faces_[at]);
    if (!tops.empty()) return tops;
    for (std::uint32_t f = first_face; f < mesh_.face_limit(); ++f) faces_.push_back(Face(f));
    return std::move(faces_);
}

void TieredExtrusion::number_groups(NewGroups groups, const std::vector<int>& old_groups, int largest, std::uint32_t first_face)
{
    const auto sides = [&](std::size_t at) { return static_cast<int>(begin_[at + 1] - begin_[at]); };

    // Old groups in ascending order, each with as many new ids as its largest face needs.
    struct Share {
        int old_group;
        std::int64_t need, first;
    };
    std::vector<Share> shares;
    if (groups != NewGroups::none) {
        std::vector<std::pair<int, std::int64_t>> needs;
        for (std::size_t at = 0; at < faces_.size(); ++at) {
            const int n = sides(at);
            const std::int64_t need = groups == NewGroups::each ? tiling_.new_faces(n) : tiling_.rows() + (tiling_.has_top(n) ? 1 : 0);
            if (needs.empty() || needs.back().first != old_groups[at]) needs.emplace_back(old_groups[at], need);
            else needs.back().second = std::max(needs.back().second, need);
        }
        std::ranges::sort(needs);
        std::int64_t next = std::int64_t(largest) + 1;
        for (std::size_t i = 0; i < needs.size(); ++i) {
            if (i + 1 < needs.size() && needs[i + 1].first == needs[i].first) continue; // the last of a group has its largest need
            shares.push_back({needs[i].first, needs[i].second, next});
            next += needs[i].second;
        }
        if (next - 1 > std::numeric_limits<std::int32_t>::max()) throw CommandError("group ids would pass 2147483647; use groups=keep or group.renumber");
    }
    const auto first_id = [&](int old_group) {
        return std::ranges::lower_bound(shares, old_group, {}, &Share::old_group)->first;
    };

    std::int32_t* out = mesh_.write_groups(first_face, mesh_.face_limit() - first_face);
    for (std::size_t at = 0; at < faces_.size(); ++at) {
        const std::int32_t n = sides(at), top = tiling_.has_top(n) ? 1 : 0, wedges = tiling_.wedges(n);
        const std::int32_t more = tiling_.new_faces(n) - 1; // faces beside the one that keeps the id
        if (groups == NewGroups::none) {
            mesh_.set_group(faces_[at], 0);
            out = std::fill_n(out, more, 0);
            continue;
        }
        const auto first = static_cast<std::int32_t>(first_id(old_groups[at]));
        mesh_.set_group(faces_[at], first);
        if (groups == NewGroups::each)
            for (std::int32_t k = 1; k <= more; ++k) *out++ = first + k;
        else
            for (std::int32_t k = 1; k <= more; ++k) *out++ = first + (k - top) / wedges + top;
    }
}

void flatten_top(Face face, const BaseFrame& frame, int tier, Cycle<Point> top, std::span<const Vector> slide)
{
    double mean = 0.0;
    for (const Point& p : top) mean += glm::dot(p - frame.foot[0], frame.normal);
    mean /= frame.n;
    for (int i = 0; i < frame.n; ++i) {
        const Vector& along = slide[static_cast<std::size_t>(i)];
        const double rise = glm::dot(along, frame.normal);
        if (std::abs(rise) < 1e-6) throw CommandError(fmt::format("face {}: cannot flatten: tier {} runs level", face.index, tier));
        top[i] += along * ((mean - glm::dot(top[i] - frame.foot[0], frame.normal)) / rise);
    }
}

// One operator a file.
Operator extrude_tetrahedral_operator();
Operator extrude_cubical_operator();
Operator extrude_octahedral_operator();
Operator extrude_dodecahedral_operator();
Operator extrude_icosahedral_operator();
Operator extrude_cuboctahedral_operator();
Operator extrude_rhombicuboctahedral_operator();
Operator extrude_solid_operator();
Operator extrude_doo_sabin_operator();
Operator extrude_dome_operator();
Operator extrude_stellate_operator();
Operator extrude_double_stellate_operator();

void register_extrude(Registry& registry)
{
    registry.add(extrude_tetrahedral_operator());
    registry.add(extrude_cubical_operator());
    registry.add(extrude_octahedral_operator());
    registry.add(extrude_dodecahedral_operator());
    registry.add(extrude_icosahedral_operator());
    registry.add(extrude_cuboctahedral_operator());
    registry.add(extrude_rhombicuboctahedral_operator());
    registry.add(extrude_solid_operator());
    registry.add(extrude_doo_sabin_operator());
    registry.add(extrude_dome_operator());
    registry.add(extrude_stellate_operator());
    registry.add(extrude_double_stellate_operator());
}

} // namespace druse
