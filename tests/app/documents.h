#pragma once

#include "app/document.h"
#include "dlfl/errors.h"
#include "io/model.h"
#include "support/folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>

namespace druse::test {

/// Everything of a document that a command may change, in a copy.
struct State {
    Mesh mesh;
    Rind rind;
    GroupTable groups;
    Selection selection;
    Source source;

    State() = default;
    explicit State(const Scene& scene) : mesh(scene.mesh), rind(scene.rind), groups(*scene.groups), selection(*scene.selection), source(*scene.source) {}
    explicit State(const Document& document) : State(document.scene()) {}

    friend bool operator==(const State&, const State&) = default;
};
inline void PrintTo(const State& s, std::ostream* out)
{
    *out << "V " << s.mesh.vertex_count() << ", E " << s.mesh.edge_count() << ", F " << s.mesh.face_count() << ", selected "
         << s.selection.faces.size() << ", " << s.selection.edges.size() << ", " << s.selection.vertices.size();
}

inline Document document_of(const Registry& registry, Mesh mesh)
{
    Document document(registry);
    Model model;
    model.mesh = std::move(mesh);
    document.open(std::move(model));
    return document;
}

/// What a command complains about; empty if it succeeds.
inline std::string complaint(Document& document, std::string_view command, const std::filesystem::path& folder = {})
{
    Progress progress;
    try {
        document.apply(command, progress, folder);
    } catch (const CommandError& e) {
        return e.what();
    } catch (const InputError& e) {
        return e.what();
    }
    return {};
}

} // namespace druse::test
