#pragma once

#include "dlfl/errors.h"
#include "ops/registry.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace druse::test {

/// The families of this room.
inline const Registry& ops_registry()
{
    static const Registry registry = [] {
        Registry r;
        register_make(r);
        register_face(r);
        register_select(r);
        register_group(r);
        register_extrude(r);
        register_remesh(r);
        register_topology(r);
        register_rind(r);
        register_graph(r);
        register_pane(r);
        register_mesh(r);
        register_check(r);
        return r;
    }();
    return registry;
}

struct Said {
    std::string output;
    bool failed = false;
    std::vector<std::string> notes;
};

/// Runs an operator with the given parameters, and closes the holes it leaves, as a document does.
inline Said run(Scene& scene, std::string_view name, const std::vector<std::pair<std::string, std::string>>& arguments = {})
{
    const Operator& op = ops_registry().get(name);
    const auto parameters = op.make();
    for (const auto& [key, value] : arguments) {
        const Parameter* p = op.find(key);
        if (!p) throw CommandError("unknown parameter '" + key + "'");
        p->set(parameters.get(), value);
    }
    Progress progress;
    Context context{.progress = progress};
    op.run(scene, parameters.get(), context);
    settle(scene);
    return {context.output, context.failed, context.notes};
}

inline std::vector<std::string> notes(Scene& scene, std::string_view name, const std::vector<std::pair<std::string, std::string>>& arguments)
{
    return run(scene, name, arguments).notes;
}

inline Scene scene_of(Mesh mesh)
{
    Scene scene;
    scene.mesh = std::move(mesh);
    return scene;
}

/// The complaint of a run that must fail.
inline std::string complaint(Scene scene, std::string_view name, const std::vector<std::pair<std::string, std::string>>& arguments = {})
{
    try {
        run(scene, name, arguments);
    } catch (const CommandError& e) {
        return e.what();
    }
    return "(none)";
}

inline std::vector<std::uint32_t> ids(const std::vector<Face>& list)
{
    std::vector<std::uint32_t> result;
    for (const Face f : list) result.push_back(f.index);
    return result;
}
template <class Tag>
std::vector<std::uint32_t> ids(const std::vector<Handle<Tag>>& list)
{
    std::vector<std::uint32_t> result;
    for (const auto h : list) result.push_back(h.index);
    return result;
}

inline std::vector<int> groups(const Mesh& mesh)
{
    std::vector<int> list;
    for (const Face f : mesh.faces()) list.push_back(mesh.group(f));
    return list;
}

/// True if edges are numbered as the faces, taken by id and each from its start corner, first use them.
inline bool edges_are_numbered_by_first_use(const Mesh& mesh)
{
    std::uint32_t next = 0;
    for (const Face f : mesh.faces())
        for (const Corner c : mesh.corners(f)) {
            const Edge e = mesh.edge(c);
            if (!e.valid() || e.index < next) continue;
            if (e.index != next++ || mesh.corner(e, 0) != c) return false;
        }
    return next == mesh.edge_count();
}

} // namespace druse::test
