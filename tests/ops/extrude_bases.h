#pragma once

#include "dlfl/errors.h"
#include "dlfl/mesh_builder.h"
#include "ops/extrude.h"
#include "ops/registry.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace druse::test {

/// A polygon with two sides; face 0 is counter-clockwise in the order given.
inline Mesh two_sided(const std::vector<Point>& corners)
{
    MeshBuilder builder;
    std::vector<std::uint32_t> up, down;
    for (const Point& p : corners) up.push_back(builder.add_vertex(p));
    down.push_back(up[0]);
    down.insert(down.end(), up.rbegin(), up.rend() - 1);
    builder.add_face(up);
    builder.add_face(down);
    return builder.build();
}

inline Mesh l_shape() { return two_sided({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}); }
inline Mesh irregular() { return two_sided({{0, 0, 0}, {3, 0, 0}, {3.5, 1, 0}, {2, 2, 0}, {0, 1, 0}}); }
inline Mesh star(int points = 5)
{
    std::vector<Point> corners;
    for (int i = 0; i < 2 * points; ++i) {
        const double r = i % 2 == 0 ? 2.2 : 1.0, a = std::numbers::pi * i / points;
        corners.emplace_back(r * std::cos(a), r * std::sin(a), 0);
    }
    return two_sided(corners);
}

using Arguments = std::vector<std::pair<std::string, std::string>>;
using ReadMesh = std::function<Mesh(const std::filesystem::path&)>;

/// Runs a registered extrusion; files are what `read_mesh` says.
inline void run_extrusion(Scene& scene, const std::string& name, const Arguments& arguments, const ReadMesh& read_mesh = {})
{
    static const Registry registry = [] {
        Registry r;
        register_extrude(r);
        return r;
    }();
    const Operator& op = registry.get(name);
    const auto parameters = op.make();
    for (const auto& [key, value] : arguments) op.find(key)->set(parameters.get(), value);
    Progress progress;
    Context context{progress, {}, {}, {}, {}, false, read_mesh};
    op.run(scene, parameters.get(), context);
}

/// A solid raised on face 0.
inline Mesh raised(Mesh base, const std::string& solid, Arguments more = {})
{
    Scene scene;
    scene.mesh = std::move(base);
    more.insert(more.end(), {{"solid", solid}, {"faces", "0"}});
    run_extrusion(scene, "extrude.solid", more);
    return std::move(scene.mesh);
}

} // namespace druse::test
