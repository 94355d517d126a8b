#include "io/glb.h"

#include "dlfl/errors.h"
#include "dlfl/mesh_builder.h"
#include "io/face_colours.h"
#include "io/glb_colour.h"
#include "io/glb_file.h"
#include "io/glb_library.h"
#include "io/materials.h"
#include "io/point_welder.h"
#include "io/scan.h"

#include <fmt/format.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <type_traits>

namespace druse {

namespace {

/// A few nodes can name one mesh again and again: more than what a file of the largest size holds once is not meant to be read.
constexpr std::uint64_t most_corners = std::uint64_t(1) << 28;

/// Extensions that leave triangles where they are, or that we know.
bool known_extension(std::string_view name)
{
    return name == "KHR_mesh_quantization" || name == "KHR_lights_punctual" || name == "KHR_texture_transform" ||
           name.starts_with("KHR_materials_");
}

/// Numbers in the bytes of a buffer; all lie inside.
struct Values {
    const char* data = nullptr;
    std::size_t stride = 0, count = 0;
    int type = 0;
    bool normalized = false;
};

template <class T> double number(const char* at, bool normalized)
{
    T value;
    std::memcpy(&value, at, sizeof value);
    if constexpr (std::is_integral_v<T>)
        if (normalized) return std::max(double(value) / std::numeric_limits<T>::max(), -1.0);
    return value;
}

double number(const Values& values, const char* at)
{
    switch (values.type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return number<std::int8_t>(at, values.normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return number<std::uint8_t>(at, values.normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return number<std::int16_t>(at, values.normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return number<std::uint16_t>(at, values.normalized);
    default:
        return number<float>(at, false);
    }
}

std::uint32_t index(const Values& values, std::size_t i)
{
    const char* const at = values.data + i * values.stride;
    std::uint32_t value = 0;
    std::memcpy(&value, at,
                values.type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? 1
                : values.type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 2
                                                                        : 4);
    return value;
}

class GltfReader {
public:
    explicit GltfReader(ByteSource& source) : source_(source), file_(source) {}
    Model read();

private:
    struct Instance {
        int mesh;
        glm::dmat4 place;
    };

    void parse();
    std::vector<int> roots() const;
    void place_meshes();
    glm::dmat4 matrix(const tinygltf::Node& node, int number) const;
    void check_size() const;
    Values values(int accessor, int type) const;
    Values positions(const tinygltf::Primitive& primitive) const;
    Values indices(const tinygltf::Primitive& primitive) const;
    bool has_triangles(const tinygltf::Primitive& primitive) const;
    void read_primitive(const tinygltf::Primitive& primitive, const glm::dmat4& place);
    void make_groups(Model& model);
    [[noreturn]] void fail(const std::string& what) const { throw InputError(source_.name(), what); }
    void check(int index, std::size_t count, const char* what) const
    {
        if (index < 0 || static_cast<std::size_t>(index) >= count)
            fail(fmt::format("there is no {} {}, the file has {}", what, index, count));
    }

    ByteSource& source_;
    GlbFile file_;
    tinygltf::Model gltf_;
    std::vector<Instance> instances_;
    MeshBuilder builder_; // with 1 + its material as the group of a face, until make_groups()
    PointWelder weld_{builder_};
    std::uint64_t passed_over_ = 0;
};

void GltfReader::parse()
{
    std::string error, warning;
    bool good = false;
    try {
        const std::string& text = file_.description();
        good = tinygltf::TinyGLTF().LoadASCIIFromString(&gltf_, &error, &warning, text.data(), static_cast<unsigned>(text.size()),
                                                        "");
    } catch (const std::exception& thrown) { // of the JSON library, for numbers in the place of names and the like
        error = thrown.what();
    }
    if (!good) {
        std::string line;
        for (const char c : error.substr(0, std::min<std::size_t>(error.find('\n'), 100)))
            line += c >= ' ' && c < '\x7f' ? c : '?';
        fail("is no glTF file: " + (line.empty() ? "its description is none" : line));
    }
    for (const std::string& name : gltf_.extensionsRequired)
        if (!known_extension(name)) {
            const std::string word = name + '\n';
            fail(fmt::format("needs the extension {}, which is not read", scan::quoted_word(word.data())));
        }
}

/// The nodes that the scene begins with. A file without scenes shows all that no other node holds.
std::vector<int> GltfReader::roots() const
{
    if (!gltf_.scenes.empty()) {
        const int scene = gltf_.defaultScene < 0 ? 0 : gltf_.defaultScene;
        check(scene, gltf_.scenes.size(), "scene");
        return gltf_.scenes[static_cast<std::size_t>(scene)].nodes;
    }
    std::vector<bool> held(gltf_.nodes.size(), false);
    for (const tinygltf::Node& node : gltf_.nodes)
        for (const int child : node.children)
            if (child >= 0 && static_cast<std::size_t>(child) < held.size()) held[static_cast<std::size_t>(child)] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < held.size(); ++i)
        if (!held[i]) roots.push_back(static_cast<int>(i));
    return roots;
}

glm::dmat4 GltfReader::matrix(const tinygltf::Node& node, int number) const
{
    const auto check_length = [&](const std::vector<double>& values, std::size_t length, const char* what) {
        if (values.empty()) return false;
        if (values.size() != length)
            fail(fmt::format("node {}: {} has {} numbers; expected {}", number, what, values.size(), length));
        return true;
    };
    glm::dmat4 matrix(1.0);
    if (check_length(node.matrix, 16, "matrix")) {
        for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
        return matrix;
    }
    const auto &t = node.translation, &r = node.rotation, &s = node.scale;
    if (check_length(r, 4, "rotation")) matrix = glm::mat4_cast(glm::dquat(r[3], r[0], r[1], r[2]));
    if (check_length(s, 3, "scale"))
        for (int i = 0; i < 3; ++i) matrix[i] *= s[static_cast<std::size_t>(i)];
    if (check_length(t, 3, "translation")) matrix[3] = glm::dvec4(t[0], t[1], t[2], 1.0);
    return matrix;
}

/// Walks the tree of nodes; a node that is met twice would have no end.
void GltfReader::place_meshes()
{
    if (gltf_.nodes.empty()) {
        for (std::size_t i = 0; i < gltf_.meshes.size(); ++i) instances_.push_back({static_cast<int>(i), glm::dmat4(1.0)});
        return;
    }
    struct Visit {
        int node;
        glm::dmat4 above;
    };
    std::vector<Visit> open;
    const auto push = [&](const std::vector<int>& nodes, const glm::dmat4& above) {
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
            check(*node, gltf_.nodes.size(), "node");
            open.push_back({*node, above});
        }
    };
    std::vector<bool> met(gltf_.nodes.size(), false);
    push(roots(), glm::dmat4(1.0));
    while (!open.empty()) {
        const Visit visit = open.back();
        open.pop_back();
        const auto number = static_cast<std::size_t>(visit.node);
        if (met[number]) fail(fmt::format("node {} is in the scene twice", visit.node));
        met[number] = true;
        const tinygltf::Node& node = gltf_.nodes[number];
        const glm::dmat4 place = visit.above * matrix(node, visit.node);
        if (node.mesh >= 0) {
            check(node.mesh, gltf_.meshes.size(), "mesh");
            instances_.push_back({node.mesh, place});
        }
        push(node.children, place);
    }
}

/// The numbers behind an accessor, three at a time for positions, one for indices. Checks that they lie inside of their buffer.
Values GltfReader::values(int number, int type) const
{
    check(number, gltf_.accessors.size(), "accessor");
    const tinygltf::Accessor& accessor = gltf_.accessors[static_cast<std::size_t>(number)];
    const bool small = accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                       accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    const bool right = type == TINYGLTF_TYPE_SCALAR ? small || accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT
                                                    : small || accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT ||
                                                          accessor.componentType == TINYGLTF_COMPONENT_TYPE_BYTE ||
                                                          accessor.componentType == TINYGLTF_COMPONENT_TYPE_SHORT;
    if (accessor.type != type || !right)
        fail(fmt::format("accessor {} does not hold {}", number, type == TINYGLTF_TYPE_SCALAR ? "indices" : "positions"));
    if (accessor.sparse.isSparse) fail(fmt::format("accessor {} is sparse, which is not read", number));
    check(accessor.bufferView, gltf_.bufferViews.size(), "bufferView");
    const tinygltf::BufferView& view = gltf_.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    check(view.buffer, file_.buffers().size(), "buffer");
    std::string_view bytes = file_.buffers()[static_cast<std::size_t>(view.buffer)];
    if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset)
        fail(fmt::format("bufferView {} reaches beyond the {} bytes of its buffer", accessor.bufferView, bytes.size()));
    bytes = bytes.substr(view.byteOffset, view.byteLength);

    const auto element =
        static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType))) *
        (type == TINYGLTF_TYPE_SCALAR ? 1 : 3);
    const std::size_t stride = view.byteStride == 0 ? element : view.byteStride;
    const bool inside = accessor.byteOffset <= bytes.size() &&
                        (accessor.count == 0 || (element <= bytes.size() - accessor.byteOffset &&
                                                 accessor.count - 1 <= (bytes.size() - accessor.byteOffset - element) / stride));
    if (stride < element || !inside)
        fail(fmt::format("accessor {} reaches beyond the {} bytes of its bufferView", number, bytes.size()));
    return {bytes.data() + accessor.byteOffset, stride, accessor.count, accessor.componentType, accessor.normalized};
}

bool GltfReader::has_triangles(const tinygltf::Primitive& primitive) const
{
    return primitive.mode >= TINYGLTF_MODE_TRIANGLES && primitive.mode <= TINYGLTF_MODE_TRIANGLE_FAN &&
           primitive.attributes.contains("POSITION");
}

Values GltfReader::positions(const tinygltf::Primitive& primitive) const
{
    return values(primitive.attributes.at("POSITION"), TINYGLTF_TYPE_VEC3);
}

/// The indices of a primitive; without any, its corners are its positions, and only the count is set.
Values GltfReader::indices(const tinygltf::Primitive& primitive) const
{
    if (primitive.indices >= 0) return values(primitive.indices, TINYGLTF_TYPE_SCALAR);
    return {nullptr, 0, positions(primitive).count, 0, false};
}

void GltfReader::check_size() const
{
    std::vector<std::uint64_t> corners(gltf_.meshes.size(), 0);
    std::uint64_t total = 0;
    for (const Instance& instance : instances_) {
        std::uint64_t& its = corners[static_cast<std::size_t>(instance.mesh)];
        if (its == 0) {
            its = 1;
            for (const tinygltf::Primitive& primitive : gltf_.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
                const std::uint64_t count = has_triangles(primitive) ? indices(primitive).count : 0;
                its += 1 + (primitive.mode == TINYGLTF_MODE_TRIANGLES ? count : 3 * count);
            }
        }
        total += its;
        if (total > most_corners) fail(fmt::format("more than {} corners, with each mesh at all of its nodes", most_corners));
    }
}

void GltfReader::read_primitive(const tinygltf::Primitive& primitive, const glm::dmat4& place)
{
    if (!has_triangles(primitive)) {
        ++passed_over_;
        return;
    }
    if (primitive.material >= 0) check(primitive.material, gltf_.materials.size(), "material");
    const Values at = positions(primitive), order = indices(primitive);
    const std::size_t part =
        at.type == TINYGLTF_COMPONENT_TYPE_FLOAT
            ? 4
            : static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(at.type)));
    const auto corner = [&](std::size_t k) {
        const std::size_t i = order.data ? index(order, k) : k;
        if (i >= at.count) fail(fmt::format("a triangle names position {}, its mesh has {}", i, at.count));
        const char* const bytes = at.data + i * at.stride;
        const glm::dvec4 p = place * glm::dvec4(number(at, bytes), number(at, bytes + part), number(at, bytes + 2 * part), 1.0);
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(p[axis]) <= largest_coordinate))
                fail(fmt::format("coordinate {}: expected at most {} in size", p[axis], largest_coordinate));
        builder_.add_corner(weld_.vertex({p.x, 0.0 - p.z, p.y})); // up is y there; and no −0
    };
    const bool mirrored = glm::determinant(glm::dmat3(place)) < 0;
    const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
        corner(a);
        corner(mirrored ? c : b);
        corner(mirrored ? b : c);
        builder_.end_face(primitive.material + 1);
    };
    const std::size_t count = order.count;
    if (primitive.mode == TINYGLTF_MODE_TRIANGLES) {
        if (count % 3 != 0) fail(fmt::format("{} corners are no whole number of triangles", count));
        for (std::size_t i = 0; i < count; i += 3) triangle(i, i + 1, i + 2);
    } else if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
        for (std::size_t i = 0; i + 2 < count; ++i) triangle(i, i + 1 + i % 2, i + 2 - i % 2);
    } else {
        for (std::size_t i = 1; i + 1 < count; ++i) triangle(0, i, i + 1);
    }
}

void GltfReader::make_groups(Model& model)
{
    const std::span<std::int32_t> faces = builder_.groups();
    std::vector<bool> used(gltf_.materials.size() + 1, false);
    for (const std::int32_t material : faces) used[static_cast<std::size_t>(material)] = true;
    const auto colour = [&](std::size_t material) {
        const std::vector<double>& c = gltf_.materials[material - 1].pbrMetallicRoughness.baseColorFactor;
        if (c.size() != 4) fail(fmt::format("material {}: a base colour of {} numbers; expected 4", material - 1, c.size()));
        return colour_from_unit(srgb_from_linear(c[0]), srgb_from_linear(c[1]), srgb_from_linear(c[2]));
    };
    std::vector<std::int32_t> group(used.size(), 0);
    bool named = true;
    for (std::size_t m = 1; m < used.size(); ++m) {
        if (!used[m]) continue;
        const auto id = group_of_material(gltf_.materials[m - 1].name);
        named = named && id;
        group[m] = id.value_or(0);
    }
    if (named) {
        std::map<int, std::size_t> material_of; // the first of each group
        for (std::size_t m = 1; m < used.size(); ++m)
            if (used[m]) material_of.try_emplace(group[m], m);
        for (const auto& [id, m] : material_of) {
            // Our own writer gives every group a colour; the one that it would have anyway is not its own.
            if (const Colour c = colour(m); c != GroupTable::default_colour(id)) model.groups.set_colour(id, c);
            const tinygltf::Value& extras = gltf_.materials[m - 1].extras;
            if (!extras.IsObject() || !extras.Has("name") || !extras.Get("name").IsString()) continue;
            const std::string& name = extras.Get("name").Get<std::string>();
            const auto ends = [](char c) { return static_cast<unsigned char>(c) <= ' ' || c == '\x7f'; };
            const auto end = std::find_if(name.begin(), name.end(), ends);
            if (end != name.begin()) model.groups.set_name(id, std::string(name.begin(), end));
        }
    } else {
        ColourNumbers colours;
        std::vector<bool> met(used.size(), false);
        for (const std::int32_t face : faces) {
            const auto m = static_cast<std::size_t>(face);
            if (m == 0 || met[m]) continue;
            met[m] = true;
            group[m] = colours.number(colour(m));
        }
        int id = 0;
        for (const Colour c : colours.colours()) model.groups.set_colour(++id, c);
    }
    for (std::int32_t& face : faces) face = group[static_cast<std::size_t>(face)];
}

Model GltfReader::read()
{
    parse();
    place_meshes();
    check_size();
    for (const Instance& instance : instances_)
        for (const tinygltf::Primitive& primitive : gltf_.meshes[static_cast<std::size_t>(instance.mesh)].primitives)
            read_primitive(primitive, instance.place);
    if (builder_.face_count() == 0) fail("holds no triangles");

    Model model;
    if (passed_over_ > 0)
        model.notes.push_back(
            fmt::format("{} part{} without triangles: passed over", passed_over_, passed_over_ == 1 ? "" : "s"));
    make_groups(model);
    Repairs repairs;
    try {
        model.mesh = builder_.build(repairs);
    } catch (const CommandError& error) {
        fail(error.what());
    }
    repairs.loose_vertices = 0; // corners of triangles left out, not something the file lists
    for (std::string& note : repairs.notes()) model.notes.push_back(std::move(note));
    return model;
}

} // namespace

Model read_gltf(ByteSource& source)
{
    return GltfReader(source).read();
}

} // namespace druse
