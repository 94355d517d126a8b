#include "io/obj.h"

#include "dlfl/errors.h"
#include "io/edge_splits.h"
#include "io/group_materials.h"
#include "io/materials.h"

namespace druse {

namespace {

void put_vertex(ByteSink& sink, const Point& p)
{
    sink.put("v ");
    sink.put(p.x);
    sink.put(' ');
    sink.put(p.y);
    sink.put(' ');
    sink.put(p.z);
    sink.put('\n');
}

void put_index(ByteSink& sink, std::uint32_t i)
{
    sink.put(' ');
    sink.put(std::uint64_t(i) + 1);
}

void write_lines(const Graph& graph, std::uint32_t first_vertex, ByteSink& sink)
{
    for (const auto& [a, b] : graph.edges) {
        sink.put('l');
        put_index(sink, first_vertex + a);
        put_index(sink, first_vertex + b);
        sink.put('\n');
    }
}

void write_faces(const Mesh& mesh, const EdgeSplits& splits, bool grouped, ByteSink& sink)
{
    int group = 0;
    bool first = true;
    for (const Face f : mesh.faces()) {
        if (grouped && (first || mesh.group(f) != group)) {
            group = mesh.group(f);
            sink.put("usemtl " + material_of_group(group) + '\n');
            first = false;
        }
        sink.put(mesh.edge(mesh.corner(f)).valid() ? 'f' : 'p');
        for (const Corner c : mesh.corners(f)) {
            put_index(sink, mesh.vertex(c).index);
            splits.along(mesh, c, [&](std::uint32_t v) { put_index(sink, v); });
        }
        sink.put('\n');
    }
}

} // namespace

void write_obj(const ModelView& model, OutputFiles& out)
{
    const Mesh& mesh = model.mesh;
    ASSERT(!mesh.has_holes(), "a mesh without holes");
    ByteSink& sink = out.main();
    if (mesh.face_count() == 0) {
        if (!model.graph) throw InputError(out.name(), "the document holds no faces and no graph to write");
        if (model.graph->edges.empty()) throw InputError(out.name(), "the graph of the document has no edges to write, and there are no faces");
        for (const Point& p : model.graph->vertices) put_vertex(sink, p);
        write_lines(*model.graph, 0, sink);
        return;
    }
    const EdgeSplits splits(mesh);
    splits.note(out);
    const std::vector<int> groups = groups_in_use(mesh, model.groups);
    const std::string library = write_group_materials(model.groups, groups, out);
    if (!library.empty()) sink.put("mtllib " + library + '\n');
    for (const Point& p : mesh.positions()) put_vertex(sink, p);
    for (const Point& p : splits.added()) put_vertex(sink, p);
    if (model.has_become_struts()) out.note("the graph that became struts is not saved beside them");
    const Graph* lines = model.lines();
    if (lines)
        for (const Point& p : lines->vertices) put_vertex(sink, p);
    write_faces(mesh, splits, !groups.empty(), sink);
    if (lines) write_lines(*lines, static_cast<std::uint32_t>(mesh.positions().size() + splits.added().size()), sink);
}

} // namespace druse
