#include "io/off.h"

#include "dlfl/errors.h"
#include "io/edge_splits.h"
#include "io/require_faces.h"

#include <vector>

namespace druse {

void write_off(const ModelView& model, OutputFiles& out)
{
    const Mesh& mesh = model.mesh;
    ASSERT(!mesh.has_holes(), "a mesh without holes");
    require_faces(model, out, "OFF");
    const EdgeSplits splits(mesh);
    splits.note(out);

    ByteSink& sink = out.main();
    const auto put_counted = [&](std::uint64_t number) {
        sink.put(' ');
        sink.put(number);
    };
    sink.put("OFF\n");
    sink.put(std::uint64_t(mesh.vertex_count()) + splits.added().size());
    put_counted(mesh.face_count());
    put_counted(std::uint64_t(mesh.edge_count()) + splits.added().size());
    sink.put('\n');
    const auto put_vertex = [&](const Point& p) {
        sink.put(p.x);
        sink.put(' ');
        sink.put(p.y);
        sink.put(' ');
        sink.put(p.z);
        sink.put('\n');
    };
    for (const Point& p : mesh.positions()) put_vertex(p);
    for (const Point& p : splits.added()) put_vertex(p);

    std::vector<std::uint32_t> ring;
    for (const Face f : mesh.faces()) {
        ring.clear();
        for (const Corner c : mesh.corners(f)) {
            ring.push_back(mesh.vertex(c).index);
            splits.along(mesh, c, [&](std::uint32_t v) { ring.push_back(v); });
        }
        sink.put(std::uint64_t(ring.size()));
        for (const std::uint32_t v : ring) put_counted(v);
        if (const int group = mesh.group(f); group > 0 || model.groups.has_own_colour(0)) {
            const Colour colour = model.groups.colour(group);
            for (const std::uint8_t channel : {colour.red, colour.green, colour.blue}) put_counted(channel);
        }
        sink.put('\n');
    }
}

} // namespace druse
