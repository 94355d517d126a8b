#pragma once

#include "dlfl/errors.h"
#include "io/output.h"
#include "io/read.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace druse::test {

inline std::string contents(const std::filesystem::path& path)
{
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

inline void put_contents(const std::filesystem::path& path, std::string_view text)
{
    std::ofstream(path, std::ios::binary) << text;
}

/// A folder that goes when the test ends.
class TemporaryFolder {
public:
    TemporaryFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "druse-test-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        path_ = name;
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder()
    {
        std::error_code error;
        std::filesystem::permissions(path_, std::filesystem::perms::owner_all, error);
        std::filesystem::remove_all(path_, error);
    }
    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    /// The names of the files in it, sorted.
    std::vector<std::string> names() const
    {
        std::vector<std::string> all;
        for (const auto& entry : std::filesystem::directory_iterator(path_)) all.push_back(entry.path().filename().string());
        std::sort(all.begin(), all.end());
        return all;
    }

private:
    std::filesystem::path path_;
};

/// Reads a text as if it were a file; side files are found in `folder`.
inline Model read_text(std::string_view text, const std::string& format, const std::filesystem::path& folder = {})
{
    ByteSource source = ByteSource::memory(text, folder / ("test." + format));
    return read_model(source, format);
}

/// What an InputError says, or "no error".
template <class F> std::string error_of(F&& f)
{
    try {
        f();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

inline ModelView view(const Model& model)
{
    return {model.mesh, model.groups, model.graph ? &*model.graph : nullptr, &model.rind};
}

struct Written {
    std::string text, materials;
    std::vector<std::string> notes;
};

/// What a model becomes as a file, and as the .mtl file beside it.
inline Written written(const ModelView& model, const std::string& format, bool ascii = false)
{
    const TemporaryFolder folder;
    OutputSet out;
    out.write(model, folder / ("test." + format), {.ascii = ascii});
    out.commit();
    return {contents(folder / ("test." + format)), contents(folder / "test.mtl"), out.notes()};
}

inline Written written(const Mesh& mesh, const std::string& format, bool ascii = false)
{
    return written(ModelView{mesh, GroupTable()}, format, ascii);
}

/// Writes a model and reads it back.
inline Model there_and_back(const ModelView& model, const std::string& format)
{
    const TemporaryFolder folder;
    OutputSet out;
    out.write(model, folder / ("test." + format));
    out.commit();
    return read_model(folder / ("test." + format));
}

inline Model there_and_back(const Mesh& mesh, const std::string& format)
{
    return there_and_back(ModelView{mesh, GroupTable()}, format);
}

inline std::vector<int> groups(const Mesh& mesh)
{
    std::vector<int> all;
    for (const Face f : mesh.faces()) all.push_back(mesh.group(f));
    return all;
}

/// How the faces of a mesh hang together: for each corner of each face, in order, its vertex, and the face and the place in it at
/// the other side of its edge.
inline std::vector<std::vector<std::tuple<std::uint32_t, std::uint32_t, int>>> connections(const Mesh& mesh)
{
    std::vector<int> place(mesh.corner_limit(), -1);
    for (const Face f : mesh.faces()) {
        int k = 0;
        for (const Corner c : mesh.corners(f)) place[c.index] = k++;
    }
    std::vector<std::vector<std::tuple<std::uint32_t, std::uint32_t, int>>> all;
    for (const Face f : mesh.faces()) {
        all.emplace_back();
        for (const Corner c : mesh.corners(f)) {
            const bool alone = !mesh.edge(c).valid();
            const Face other = alone ? Face() : mesh.face(mesh.opposite(c));
            if (alone || other.is_boundary())
                all.back().emplace_back(mesh.vertex(c).index, alone ? Face::none : Face::boundary_bit, -1);
            else
                all.back().emplace_back(mesh.vertex(c).index, other.index, place[mesh.opposite(c).index]);
        }
    }
    return all;
}

/// True if edges are numbered as the faces, each from its start corner, first use them.
inline bool edges_are_in_order_of_use(const Mesh& mesh)
{
    std::uint32_t next = 0;
    for (const Face f : mesh.faces())
        for (const Corner c : mesh.corners(f)) {
            const Edge e = mesh.edge(c);
            if (!e.valid() || e.index < next) continue;
            if (e.index > next || mesh.corner(e, 0) != c) return false;
            ++next;
        }
    return next == mesh.edge_count();
}

inline std::vector<Point> points(const Mesh& mesh)
{
    return {mesh.positions().begin(), mesh.positions().end()};
}

inline const std::string cube_obj = R"(v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
)";

/// A tetrahedron's vertices, for files of a few lines.
inline const std::string four_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
inline const std::string tetrahedron_faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

} // namespace druse::test
