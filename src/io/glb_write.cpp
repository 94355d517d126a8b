#include "io/glb.h"

#include "dlfl/errors.h"
#include "dlfl/triangulate.h"
#include "io/coincident_edges.h"
#include "io/glb_colour.h"
#include "io/glb_library.h"
#include "io/group_materials.h"
#include "io/materials.h"
#include "io/require_faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <ostream>
#include <streambuf>
#include <vector>

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
    GltfWriter(const ModelView& model, OutputFiles& out)
        : mesh_(model.mesh), table_(model.groups), out_(out), groups_(groups_in_use(mesh_, table_)), coincident_(mesh_)
    {
    }
    void write(bool binary);

private:
    using Triangle = std::array<std::uint32_t, 3>;

    void count_triangles();
    std::uint64_t divide(Face f);
    std::uint32_t number(Face f, const Point& p);
    void put_positions();
    void put_triangles();
    void add_primitives();
    int add_material(int group);
    std::size_t place_of(int group) const
    {
        return static_cast<std::size_t>(std::lower_bound(groups_.begin(), groups_.end(), group) - groups_.begin());
    }

    const Mesh& mesh_;
    const GroupTable& table_;
    OutputFiles& out_;
    std::vector<int> groups_;         // one primitive each; empty: one in all
    CoincidentEdges coincident_;
    Triangulator triangulator_;
    std::vector<Triangle> divided_;   // of faces that these concern, one after the other,
    std::vector<std::size_t> divided_ends_; // and where those of each end
    std::vector<Point> added_;        // to the vertices, for those
    std::map<std::array<float, 3>, std::uint32_t> number_; // of an added point
    std::vector<std::uint64_t> ends_; // where the triangles of each end, in triangles
    std::size_t index_bytes_ = 0;     // where the indices begin
    tinygltf::Model gltf_;
};

/// Which vertex of the file a corner of a divided face is.
std::uint32_t GltfWriter::number(Face f, const Point& p)
{
    for (const Corner c : mesh_.corners(f))
        if (mesh_.position(c) == p) return mesh_.vertex(c).index;
    const std::array place{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}; // of which no vertex is
    const auto [at, is_new] = number_.try_emplace(place, static_cast<std::uint32_t>(mesh_.vertex_count() + added_.size()));
    if (is_new) added_.push_back(p);
    return at->second;
}

/// @return how many triangles it has
std::uint64_t GltfWriter::divide(Face f)
{
    const auto& triangles = coincident_.triangles(triangulator_.triangles(mesh_, f));
    for (const auto& t : triangles) divided_.push_back({number(f, t[0]), number(f, t[1]), number(f, t[2])});
    divided_ends_.push_back(divided_.size());
    return triangles.size();
}

/// Each face gives two triangles less than it has corners, or more where edges upon each other are divided.
void GltfWriter::count_triangles()
{
    coincident_.note(out_);
    ends_.assign(std::max<std::size_t>(groups_.size(), 1), 0);
    std::uint32_t thin = 0;
    for (const Face f : mesh_.faces()) {
        const int n = mesh_.valence(f);
        thin += n < 3;
        if (n > 2) ends_[groups_.empty() ? 0 : place_of(mesh_.group(f))] += coincident_.concern(f) ? divide(f) : static_cast<std::uint64_t>(n - 2);
    }
    for (std::size_t i = 1; i < ends_.size(); ++i) ends_[i] += ends_[i - 1];
    if (ends_.back() == 0) throw InputError(out_.name(), "the document holds no face with more than 2 corners");
    if (thin > 0)
        out_.note(fmt::format("{} face{} fewer than 3 corners: not saved in glTF", thin, thin == 1 ? " has" : "s have"));
    constexpr std::uint64_t most_bytes = 0xf0000000; // sizes have 32 bits, and there must be room for the description
    if (12 * (mesh_.vertex_count() + added_.size() + ends_.back()) > most_bytes)
        throw InputError(out_.name(), fmt::format("{} triangles are too many for glTF", ends_.back()));
}

void GltfWriter::put_positions()
{
    tinygltf::Accessor accessor;
    accessor.bufferView = 0;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.type = TINYGLTF_TYPE_VEC3;
    accessor.count = mesh_.vertex_count() + added_.size();
    accessor.minValues.assign(3, std::numeric_limits<double>::infinity());
    accessor.maxValues.assign(3, -std::numeric_limits<double>::infinity());
    unsigned char* to = gltf_.buffers[0].data.data();
    for (std::uint32_t v = 0; v < accessor.count; ++v) {
        const Point& p = v < mesh_.vertex_count() ? mesh_.position(Vertex(v)) : added_[v - mesh_.vertex_count()];
        const float at[3] = {static_cast<float>(p.x), static_cast<float>(p.z), static_cast<float>(0.0 - p.y)}; // no −0;
        for (std::size_t i = 0; i < 3; ++i) {
            if (!std::isfinite(at[i]))
                throw InputError(out_.name(), fmt::format("vertex {} lies at {},{},{}: too far for the single precision of glTF",
                                                          v, p.x, p.y, p.z));
            accessor.minValues[i] = std::min(accessor.minValues[i], double(at[i]));
            accessor.maxValues[i] = std::max(accessor.maxValues[i], double(at[i]));
        }
        std::memcpy(to, at, sizeof at);
        to += sizeof at;
    }
    gltf_.accessors.push_back(std::move(accessor));
}

void GltfWriter::put_triangles()
{
    std::vector<unsigned char*> to(ends_.size());
    for (std::size_t i = 0; i < to.size(); ++i)
        to[i] = gltf_.buffers[0].data.data() + index_bytes_ + 12 * (i == 0 ? 0 : ends_[i - 1]);
    const auto put = [](unsigned char*& at, const Triangle& t) {
        std::memcpy(at, t.data(), sizeof t);
        at += sizeof t;
    };
    auto divided = divided_.begin();
    auto end = divided_ends_.begin();
    for (const Face f : mesh_.faces()) {
        unsigned char*& at = to[groups_.empty() ? 0 : place_of(mesh_.group(f))];
        if (coincident_.concern(f) && mesh_.valence(f) > 2) {
            for (const auto last = divided_.begin() + std::ptrdiff_t(*end++); divided != last; ++divided) put(at, *divided);
            continue;
        }
        for (const auto& t : triangulator_.triangles(mesh_, f)) put(at, {mesh_.vertex(t[0]).index, mesh_.vertex(t[1]).index, mesh_.vertex(t[2]).index});
    }
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
    for (std::size_t i = 0; i < ends_.size(); ++i) {
        const std::uint64_t begin = i == 0 ? 0 : ends_[i - 1];
        if (ends_[i] == begin) continue; // only faces without triangles
        tinygltf::Accessor accessor;
        accessor.bufferView = 1;
        accessor.byteOffset = 12 * begin;
        accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        accessor.type = TINYGLTF_TYPE_SCALAR;
        accessor.count = 3 * (ends_[i] - begin);
        gltf_.accessors.push_back(std::move(accessor));
        tinygltf::Primitive primitive;
        primitive.mode = TINYGLTF_MODE_TRIANGLES;
        primitive.attributes["POSITION"] = 0;
        primitive.indices = static_cast<int>(gltf_.accessors.size()) - 1;
        if (!groups_.empty()) primitive.material = add_material(groups_[i]);
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
    count_triangles();
    index_bytes_ = 12 * (std::size_t(mesh_.vertex_count()) + added_.size());
    gltf_.asset.version = "2.0";
    gltf_.asset.generator = "Druse";
    gltf_.buffers.emplace_back().data.resize(index_bytes_ + 12 * ends_.back());
    const auto add_view = [&](std::size_t offset, std::size_t length, int target) {
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = offset;
        view.byteLength = length;
        view.target = target;
        gltf_.bufferViews.push_back(std::move(view));
    };
    add_view(0, index_bytes_, TINYGLTF_TARGET_ARRAY_BUFFER);
    add_view(index_bytes_, 12 * ends_.back(), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    put_positions();
    put_triangles();
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
