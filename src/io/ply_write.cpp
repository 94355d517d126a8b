#include "io/ply.h"

#include "dlfl/errors.h"
#include "io/edge_splits.h"
#include "io/group_materials.h"
#include "io/require_faces.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>

namespace druse {

namespace {

static_assert(std::endian::native == std::endian::little, "binary PLY is written as it lies in memory");

/// Puts values as text, one element a line.
class Text {
public:
    explicit Text(ByteSink& sink) : sink_(sink) {}
    template <class T> void put(T value)
    {
        if (!first_) sink_.put(' ');
        first_ = false;
        if constexpr (std::is_integral_v<T>)
            sink_.put(static_cast<std::uint64_t>(value)); // none is negative
        else
            sink_.put(value);
    }
    void end()
    {
        sink_.put('\n');
        first_ = true;
    }

private:
    ByteSink& sink_;
    bool first_ = true;
};

/// Puts values as they lie in memory.
class Bytes {
public:
    explicit Bytes(ByteSink& sink) : sink_(sink) {}
    template <class T> void put(T value)
    {
        std::memcpy(sink_.room(sizeof value), &value, sizeof value);
        sink_.use(sizeof value);
    }
    void end() {}

private:
    ByteSink& sink_;
};

class PlyWriter {
public:
    PlyWriter(const ModelView& model, OutputFiles& out)
        : mesh_(model.mesh), table_(model.groups), out_(out), splits_(mesh_), groups_(groups_in_use(mesh_, table_))
    {
    }
    void write();

private:
    void gather(Face f);
    void put_header();
    template <class Out> void put_elements(Out out);

    const Mesh& mesh_;
    const GroupTable& table_;
    OutputFiles& out_;
    EdgeSplits splits_;
    std::vector<int> groups_;
    std::vector<std::uint32_t> ring_; // the vertices of one face, in the file
    bool long_lists_ = false;
};

void PlyWriter::gather(Face f)
{
    ring_.clear();
    for (const Corner c : mesh_.corners(f)) {
        ring_.push_back(mesh_.vertex(c).index);
        splits_.along(mesh_, c, [&](std::uint32_t v) { ring_.push_back(v); });
    }
}

void PlyWriter::put_header()
{
    ByteSink& sink = out_.main();
    sink.put(out_.ascii() ? "ply\nformat ascii 1.0\n" : "ply\nformat binary_little_endian 1.0\n");
    for (const int id : groups_) {
        if (table_.name(id).empty()) continue;
        sink.put("comment group ");
        sink.put(static_cast<std::uint64_t>(id));
        sink.put(' ' + table_.name(id) + '\n');
    }
    sink.put("element vertex ");
    sink.put(std::uint64_t(mesh_.vertex_count()) + splits_.added().size());
    sink.put("\nproperty double x\nproperty double y\nproperty double z\nelement face ");
    sink.put(std::uint64_t(mesh_.face_count()));
    sink.put(long_lists_ ? "\nproperty list uint int vertex_indices\n" : "\nproperty list uchar int vertex_indices\n");
    if (!groups_.empty()) sink.put("property int group\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n");
    sink.put("end_header\n");
}

template <class Out> void PlyWriter::put_elements(Out out)
{
    const auto put_vertex = [&](const Point& p) {
        for (int i = 0; i < 3; ++i) out.put(p[i]);
        out.end();
    };
    for (const Point& p : mesh_.positions()) put_vertex(p);
    for (const Point& p : splits_.added()) put_vertex(p);

    int group = -1;
    Colour colour;
    for (const Face f : mesh_.faces()) {
        gather(f);
        if (long_lists_)
            out.put(static_cast<std::uint32_t>(ring_.size()));
        else
            out.put(static_cast<std::uint8_t>(ring_.size()));
        for (const std::uint32_t v : ring_) out.put(static_cast<std::int32_t>(v));
        if (!groups_.empty()) {
            if (mesh_.group(f) != group) {
                group = mesh_.group(f);
                colour = table_.colour(group);
            }
            out.put(static_cast<std::int32_t>(group));
            for (const std::uint8_t channel : {colour.red, colour.green, colour.blue}) out.put(channel);
        }
        out.end();
    }
}

void PlyWriter::write()
{
    splits_.note(out_);
    for (const Face f : mesh_.faces()) {
        gather(f);
        if (ring_.size() <= 255) continue;
        long_lists_ = true;
        break;
    }
    put_header();
    if (out_.ascii())
        put_elements(Text(out_.main()));
    else
        put_elements(Bytes(out_.main()));
}

} // namespace

void write_ply(const ModelView& model, OutputFiles& out)
{
    ASSERT(!model.mesh.has_holes(), "a mesh without holes");
    require_faces(model, out, "PLY");
    PlyWriter(model, out).write();
}

} // namespace druse
