#include "io/threemf.h"

#include "dlfl/errors.h"
#include "dlfl/mesh_builder.h"
#include "io/build_mesh.h"
#include "io/limits.h"
#include "io/point_welder.h"
#include "io/threemf_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace druse {

namespace {

// A few objects can name one mesh again and again.
constexpr std::uint64_t most_placed_corners = std::uint64_t(1) << 28, most_placements = 1u << 20;

class ThreeMfReader {
public:
    explicit ThreeMfReader(ByteSource& source) : source_(source), file_(read_3mf_model(source)) {}
    Model read();

private:
    void place_all();
    void place_mesh(const ThreeMfModel::Object& object, const glm::dmat4& place);
    [[noreturn]] void fail(const std::string& what) const { throw InputError(source_.name(), what); }

    ByteSource& source_;
    ThreeMfModel file_;
    MeshBuilder builder_; // with the paint as the group of a face
    PointWelder weld_{builder_};
};

void ThreeMfReader::place_all()
{
    std::vector<ThreeMfModel::Placed> open(file_.items.rbegin(), file_.items.rend());
    for (ThreeMfModel::Placed& item : open) item.place = glm::dmat4(glm::dmat3(file_.unit)) * item.place;
    std::uint64_t placed = 0;
    while (!open.empty()) {
        const ThreeMfModel::Placed next = std::move(open.back());
        open.pop_back();
        const auto found = file_.objects.find(next.object);
        if (found == file_.objects.end()) fail(fmt::format("object {}, which is to be placed, is not there", next.object.second));
        const auto& components = found->second.components;
        if (++placed + open.size() + components.size() > most_placements) fail(fmt::format("places more than {} objects", most_placements));
        place_mesh(found->second, next.place);
        for (auto part = components.rbegin(); part != components.rend(); ++part) open.push_back({part->object, next.place * part->place});
    }
}

void ThreeMfReader::place_mesh(const ThreeMfModel::Object& object, const glm::dmat4& place)
{
    if (builder_.corner_count() + 3 * std::uint64_t(object.triangles.size()) > most_placed_corners)
        fail(fmt::format("more than {} corners, with each object wherever it is placed", most_placed_corners));
    const bool mirrored = glm::determinant(glm::dmat3(place)) < 0;
    const auto add_corner = [&](std::uint32_t v) {
        const glm::dvec4 p = place * glm::dvec4(object.points[v], 1.0);
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(p[axis]) <= largest_coordinate)) fail(fmt::format("coordinate {}: expected at most {} in size", p[axis], largest_coordinate));
        builder_.add_corner(weld_.vertex({p.x + 0.0, p.y + 0.0, p.z + 0.0})); // no −0
    };
    for (const ThreeMfModel::Triangle& t : object.triangles) {
        add_corner(t.points[0]);
        add_corner(t.points[mirrored ? 2 : 1]);
        add_corner(t.points[mirrored ? 1 : 2]);
        builder_.end_face(t.paint);
        if (builder_.face_count() % (1u << 20) == 0) source_.read(nullptr, 0); // all is read, but a person may have enough
    }
}

Model ThreeMfReader::read()
{
    place_all();
    if (builder_.face_count() == 0) fail("holds no triangles");
    Model model;
    groups_from_materials(builder_.groups(), file_.materials.size(), [&](std::size_t m) { return file_.materials[m]; }, model.groups);
    build_mesh(builder_, source_, model, most_elements); // loose vertices are corners of triangles left out, not something the file lists
    return model;
}

} // namespace

Model read_3mf(ByteSource& source) { return ThreeMfReader(source).read(); }

} // namespace druse
