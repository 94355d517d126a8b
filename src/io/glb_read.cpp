#include "io/glb.h"

#include "dlfl/errors.h"
#include "dlfl/mesh_builder.h"
#include "io/build_mesh.h"
#include "io/face_colours.h"
#include "io/glb_accessor.h"
#include "io/glb_colour.h"
#include "io/glb_file.h"
#include "io/glb_library.h"
#include "io/limits.h"
#include "io/materials.h"
#include "io/point_welder.h"
#include "io/scan.h"

#include <fmt/format.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include <cmath>

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
    GlbValues positions(const tinygltf::Primitive& primitive) const;
    GlbValues indices(const tinygltf::Primitive& primitive) const;
    bool has_triangles(const tinygltf::Primitive& primitive) const;
    void read_primitive(const tinygltf::Primitive& primitive, const glm::dmat4& place);
    void make_groups(Model& model);
    [[noreturn]] void fail(const std::string& what) const { throw InputError(source_.name(), what); }
    void check(int index, std::size_t count, const char* what) const { check_glb_index(index, count, what, source_.name()); }

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
        if (node.mesh != -1) {
            check(node.mesh, gltf_.meshes.size(), "mesh");
            instances_.push_back({node.mesh, place});
        }
        push(node.children, place);
    }
}

bool GltfReader::has_triangles(const tinygltf::Primitive& primitive) const
{
    return primitive.mode >= TINYGLTF_MODE_TRIANGLES && primitive.mode <= TINYGLTF_MODE_TRIANGLE_FAN &&
           primitive.attributes.contains("POSITION");
}

GlbValues GltfReader::positions(const tinygltf::Primitive& primitive) const
{
    return glb_positions(gltf_, file_, primitive.attributes.at("POSITION"), source_.name());
}

/// The corners of a primitive; without indices they are its positions.
GlbValues GltfReader::indices(const tinygltf::Primitive& primitive) const
{
    if (primitive.indices != -1) return glb_indices(gltf_, file_, primitive.indices, source_.name());
    return GlbValues::counted(positions(primitive).count());
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
                const std::uint64_t count = has_triangles(primitive) ? indices(primitive).count() : 0;
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
    if (primitive.material != -1) check(primitive.material, gltf_.materials.size(), "material");
    const GlbValues at = positions(primitive), order = indices(primitive);
    const auto corner = [&](std::size_t k) {
        const std::size_t i = order.index(k);
        if (i >= at.count()) fail(fmt::format("a triangle names position {}, its mesh has {}", i, at.count()));
        const glm::dvec4 p = place * glm::dvec4(at.position(i), 1.0);
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
        if (builder_.face_count() % (1u << 20) == 0) source_.read(nullptr, 0); // all is read, but a person may have enough
    };
    const std::size_t count = order.count();
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
    groups_from_materials(builder_.groups(), gltf_.materials.size(), [&](std::size_t m) {
        const tinygltf::Material& material = gltf_.materials[m];
        const std::vector<double>& c = material.pbrMetallicRoughness.baseColorFactor;
        if (c.size() != 4) fail(fmt::format("material {}: a base colour of {} numbers; expected 4", m, c.size()));
        NamedColour made{group_of_material(material.name), colour_from_unit(srgb_from_linear(c[0]), srgb_from_linear(c[1]), srgb_from_linear(c[2])), {}};
        if (const tinygltf::Value& extras = material.extras; extras.IsObject() && extras.Has("name") && extras.Get("name").IsString())
            made.name = extras.Get("name").Get<std::string>();
        return made;
    }, model.groups);
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
    build_mesh(builder_, source_, model, most_elements); // loose vertices are corners of triangles left out, not something the file lists
    return model;
}

} // namespace

Model read_gltf(ByteSource& source)
{
    return GltfReader(source).read();
}

} // namespace druse
