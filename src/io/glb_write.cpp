#include "io/glb.h"

#include "dlfl/errors.h"
#include "io/glb_colour.h"
#include "io/glb_library.h"
#include "io/indexed_triangles.h"
#include "io/materials.h"
#include "io/require_faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <ostream>
#include <streambuf>

namespace druse {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

/// What tinygltf writes to, on the way into a sink.
class SinkBuffer : public std::streambuf {
public:
    explicit SinkBuffer(ByteSink& sink) : sink_(sink) {}

protected:
    std::streamsize xsputn(const char* text, std::streamsize count) override
    {
        sink_.put(std::string_view(text, static_cast<std::size_t>(count)));
        return count;
    }
    int_type overflow(int_type c) override
    {
        if (!traits_type::eq_int_type(c, traits_type::eof())) sink_.put(traits_type::to_char_type(c));
        return traits_type::not_eof(c);
    }

private:
    ByteSink& sink_;
};

class GltfWriter {
public:
    GltfWriter(const ModelView& model, OutputFiles& out) : table_(model.groups), out_(out), triangles_(model, out, "glTF") {}
    void write(bool binary);

private:
    void put_positions();
    void add_primitives();
    int add_material(int group);

    const GroupTable& table_;
    OutputFiles& out_;
    IndexedTriangles triangles_;
    tinygltf::Model gltf_;
};

void GltfWriter::put_positions()
{
    tinygltf::Accessor accessor;
    accessor.bufferView = 0;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.type = TINYGLTF_TYPE_VEC3;
    accessor.count = triangles_.point_count();
    accessor.minValues.assign(3, std::numeric_limits<double>::infinity());
    accessor.maxValues.assign(3, -std::numeric_limits<double>::infinity());
    unsigned char* to = gltf_.buffers[0].data.data();
    for (std::uint32_t v = 0; v < accessor.count; ++v) {
        const auto [x, y, z] = triangles_.place(v);
        const float at[3] = {x, z, 0.0f - y}; // no −0
        for (std::size_t i = 0; i < 3; ++i) {
            accessor.minValues[i] = std::min(accessor.minValues[i], double(at[i]));
            accessor.maxValues[i] = std::max(accessor.maxValues[i], double(at[i]));
        }
        std::memcpy(to, at, sizeof at);
        to += sizeof at;
    }
    gltf_.accessors.push_back(std::move(accessor));
}

int GltfWriter::add_material(int group)
{
    tinygltf::Material material;
    material.name = material_of_group(group);
    const Colour c = table_.colour(group);
    material.pbrMetallicRoughness.baseColorFactor = {linear_from_srgb(c.red / 255.0), linear_from_srgb(c.green / 255.0),
                                                     linear_from_srgb(c.blue / 255.0), 1.0};
    material.pbrMetallicRoughness.metallicFactor = 0;
    if (!table_.name(group).empty())
        material.extras = tinygltf::Value(tinygltf::Value::Object{{"name", tinygltf::Value(table_.name(group))}});
    gltf_.materials.push_back(std::move(material));
    return static_cast<int>(gltf_.materials.size()) - 1;
}

void GltfWriter::add_primitives()
{
    tinygltf::Mesh mesh;
    for (std::size_t i = 0; i < triangles_.part_count(); ++i) {
        const std::uint64_t begin = triangles_.begin(i), end = triangles_.end(i);
        if (begin == end) continue; // only faces without triangles
        tinygltf::Accessor accessor;
        accessor.bufferView = 1;
        accessor.byteOffset = 12 * begin;
        accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        accessor.type = TINYGLTF_TYPE_SCALAR;
        accessor.count = 3 * (end - begin);
        gltf_.accessors.push_back(std::move(accessor));
        tinygltf::Primitive primitive;
        primitive.mode = TINYGLTF_MODE_TRIANGLES;
        primitive.attributes["POSITION"] = 0;
        primitive.indices = static_cast<int>(gltf_.accessors.size()) - 1;
        if (!triangles_.groups().empty()) primitive.material = add_material(triangles_.groups()[i]);
        mesh.primitives.push_back(std::move(primitive));
    }
    gltf_.meshes.push_back(std::move(mesh));
    tinygltf::Node node;
    node.mesh = 0;
    gltf_.nodes.push_back(std::move(node));
    tinygltf::Scene scene;
    scene.nodes.push_back(0);
    gltf_.scenes.push_back(std::move(scene));
    gltf_.defaultScene = 0;
}

void GltfWriter::write(bool binary)
{
    constexpr std::uint64_t most_bytes = 0xf0000000; // sizes have 32 bits, and there must be room for the description
    const std::uint64_t index_begin = 12 * std::uint64_t(triangles_.point_count()), index_bytes = 12 * triangles_.count();
    if (index_begin + index_bytes > most_bytes) throw InputError(out_.name(), fmt::format("{} triangles are too many for glTF", triangles_.count()));
    gltf_.asset.version = "2.0";
    gltf_.asset.generator = "Druse";
    gltf_.buffers.emplace_back().data.resize(index_begin + index_bytes);
    const auto add_view = [&](std::size_t offset, std::size_t length, int target) {
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = offset;
        view.byteLength = length;
        view.target = target;
        gltf_.bufferViews.push_back(std::move(view));
    };
    add_view(0, index_begin, TINYGLTF_TARGET_ARRAY_BUFFER);
    add_view(index_begin, index_bytes, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    put_positions();
    triangles_.put(gltf_.buffers[0].data.data() + index_begin);
    add_primitives();

    SinkBuffer buffer(out_.main());
    std::ostream stream(&buffer);
    stream.exceptions(std::ios::badbit | std::ios::failbit); // the sink's own errors come through
    ASSERT(tinygltf::TinyGLTF().WriteGltfSceneToStream(&gltf_, stream, true, binary), "a scene that can be written");
}

void write_either(const ModelView& model, OutputFiles& out, bool binary)
{
    ASSERT(!model.mesh.has_holes(), "a mesh without holes");
    require_faces(model, out, "glTF");
    GltfWriter(model, out).write(binary);
}

} // namespace

void write_glb(const ModelView& model, OutputFiles& out)
{
    write_either(model, out, true);
}

void write_gltf(const ModelView& model, OutputFiles& out)
{
    write_either(model, out, false);
}

} // namespace druse
