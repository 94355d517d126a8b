#include "ui/pattern.h"

#include "app/command.h"
#include "dlfl/errors.h"
#include "dlfl/measures.h"
#include "dlfl/mesh_builder.h"
#include "geom/turn.h"
#include "ops/solid.h"

#include <algorithm>
#include <limits>
#include <set>

namespace druse::ui {

namespace {

/// A regular polygon with two sides, the first of them looking up.
Mesh two_sided_polygon(int n)
{
    MeshBuilder builder;
    std::vector<std::uint32_t> ring;
    for (int i = 0; i < n; ++i) {
        const Point2 p = turn_by_degrees(360.0 * i / n);
        ring.push_back(static_cast<std::uint32_t>(i));
        builder.add_vertex({p.x, p.y, 0});
    }
    builder.add_face(ring);
    std::ranges::reverse(ring);
    builder.add_face(ring);
    return builder.build();
}

/// How unlike the edges are: 0 where all are of one length.
double spread(const Mesh& mesh)
{
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
    for (const Edge e : mesh.edges()) {
        shortest = std::min(shortest, length(mesh, e));
        longest = std::max(longest, length(mesh, e));
    }
    return longest / shortest - 1;
}

/// How many numbers of sides the faces have: 1 for a cube, 2 for the prism that is as regular.
std::size_t kinds_of_faces(const Mesh& mesh)
{
    std::set<int> kinds;
    for (const Face f : mesh.faces()) kinds.insert(mesh.valence(f));
    return kinds.size();
}

std::optional<Mesh> extruded(const Operator& op, const Parameter& faces, int n)
{
    Scene scene;
    scene.mesh = two_sided_polygon(n);
    const std::shared_ptr<void> parameters = op.make();
    Progress progress;
    Context context{progress};
    try {
        faces.set(parameters.get(), "0");
        op.run(scene, parameters.get(), context);
    } catch (const CommandError&) {
        return {};
    }
    return std::move(scene.mesh);
}

} // namespace

const Parameter* solid_parameter(const Operator& op)
{
    const auto found = std::ranges::find(op.parameters, Parameter::Type::name_or_file, &Parameter::type);
    return found == op.parameters.end() ? nullptr : &*found;
}

std::optional<Mesh> pattern_of(const Operator& op, const std::string& solid)
{
    const Parameter* faces = op.find("faces");
    if (op.family() != "extrude" || op.kind != Operator::Kind::edit || !faces) return {};

    if (const Parameter* parameter = solid_parameter(op)) {
        std::string name = solid;
        if (name.empty())
            for (const auto& [key, value] : parse_command(op.example).arguments)
                if (key == parameter->name) name = value;
        if (name.empty() || parameter->names_file(name)) return {};
        try {
            return make_solid(name, 1.0);
        } catch (const CommandError&) {
            return {};
        }
    }

    std::optional<Mesh> best;
    double least = 0;
    std::size_t fewest = 0;
    for (int n = 3; n <= 6; ++n) {
        auto mesh = extruded(op, *faces, n);
        if (!mesh) continue;
        const double s = spread(*mesh);
        const std::size_t kinds = kinds_of_faces(*mesh);
        if (!best || s < least - 1e-9 || (s < least + 1e-9 && kinds < fewest)) {
            best = std::move(mesh);
            least = s;
            fewest = kinds;
        }
    }
    return best;
}

} // namespace druse::ui
