#include "io/threemf.h"

#include "dlfl/errors.h"
#include "dlfl/mesh_builder.h"
#include "io/build_mesh.h"
#include "io/face_colours.h"
#include "io/limits.h"
#include "io/materials.h"
#include "io/point_welder.h"
#include "io/threemf_library.h"

#include <fmt/format.h>

#include <glm/mat4x4.hpp>
#include <zip.h>

#include <cmath>
#include <exception>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace druse {

namespace {

constexpr std::uint64_t largest_package = std::uint64_t(1) << 31;
constexpr std::uint64_t largest_unpacked = std::uint64_t(1) << 30; // of all that is packed in it
constexpr std::uint64_t most_placed_corners = std::uint64_t(1) << 28, most_placements = 1u << 20;

class ThreeMfReader {
public:
    explicit ThreeMfReader(ByteSource& source) : source_(source) {}
    Model read();

private:
    struct Placement {
        ThreeMfHandle object;
        glm::dmat4 place;
    };

    void check_unpacked(std::vector<char>& bytes) const;
    void open(std::vector<char>& bytes);
    std::vector<Placement> build_items();
    void place(std::vector<Placement> open);
    void place_mesh(ThreeMfObject mesh, const glm::dmat4& place);
    std::vector<std::int32_t> paints(ThreeMfObject mesh, std::size_t triangles);
    std::int32_t base_material(DWORD group, DWORD index);
    std::int32_t colour(const NMR::MODELMESHCOLOR_SRGB& c);
    double unit() const;
    [[noreturn]] void fail(const std::string& what) const { throw InputError(source_.name(), what); }

    ByteSource& source_;
    ThreeMfHandle model_;
    MeshBuilder builder_; // with the paint as the group of a face: 0 for none, or 1 + its place in materials_
    PointWelder weld_{builder_};
    std::vector<NamedColour> materials_;
    std::map<std::tuple<DWORD, DWORD>, std::int32_t> paint_of_material_;
    std::map<std::uint32_t, std::int32_t> paint_of_colour_;
    std::uint64_t passed_over_ = 0;
};

/// A small file may unpack to more than there is memory.
void ThreeMfReader::check_unpacked(std::vector<char>& bytes) const
{
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* buffer = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    zip_t* package = buffer ? zip_open_from_source(buffer, ZIP_RDONLY, &error) : nullptr;
    if (!package) {
        if (buffer) zip_source_free(buffer);
        zip_error_fini(&error);
        fail("is no 3MF file: it is no ZIP package");
    }
    const std::unique_ptr<zip_t, decltype(&zip_discard)> owned(package, &zip_discard);
    zip_error_fini(&error);
    if (zip_get_num_entries(package, 0) <= 0) fail("is no 3MF file: its ZIP package is empty");
    std::uint64_t sum = 0;
    for (zip_int64_t i = 0; i < zip_get_num_entries(package, 0); ++i) {
        zip_stat_t entry;
        if (zip_stat_index(package, static_cast<zip_uint64_t>(i), 0, &entry) != 0 || !(entry.valid & ZIP_STAT_SIZE)) fail("is no 3MF file: its ZIP package is damaged");
        sum += std::min<std::uint64_t>(entry.size, largest_unpacked + 1);
        if (sum > largest_unpacked) fail(fmt::format("unpacks to more than {} bytes", largest_unpacked));
    }
}

void ThreeMfReader::open(std::vector<char>& bytes)
{
    require_3mf(nullptr, NMR::lib3mf_createmodel(model_.out()));
    ThreeMfHandle reader;
    require_3mf(model_, NMR::lib3mf_model_queryreader(model_, "3mf", reader.out()));
    struct Watch {
        ByteSource& source;
        std::exception_ptr stop;
    } watch{source_, nullptr};
    const NMR::Lib3MFProgressCallback go_on = [](int, NMR::ProgressIdentifier, void* data) {
        auto& w = *static_cast<Watch*>(data);
        try {
            w.source.read(nullptr, 0); // all is read, but a person may have enough
        } catch (...) {
            w.stop = std::current_exception();
        }
        return !w.stop;
    };
    require_3mf(reader, NMR::lib3mf_reader_setprogresscallback(reader, go_on, &watch));
    const HRESULT result = NMR::lib3mf_reader_readfrombuffer(reader, reinterpret_cast<BYTE*>(bytes.data()), bytes.size());
    if (watch.stop) std::rethrow_exception(watch.stop);
    require_3mf(reader, result);
}

/// Millimetres in a unit of the file.
double ThreeMfReader::unit() const
{
    DWORD unit = NMR::MODELUNIT_MILLIMETER;
    require_3mf(model_, NMR::lib3mf_model_getunit(model_, &unit));
    constexpr double millimetres[] = {0.001, 1, 10, 25.4, 304.8, 1000};
    return unit < std::size(millimetres) ? millimetres[unit] : 1;
}

/// Places in a file are rows, and so are what transforms make of the axes.
glm::dmat4 matrix(const NMR::MODELTRANSFORM& t)
{
    glm::dmat4 m(1.0);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) m[column][row] = double(t.m_fFields[row][column]);
    return m;
}

std::vector<ThreeMfReader::Placement> ThreeMfReader::build_items()
{
    std::vector<Placement> items;
    ThreeMfHandle iterator;
    require_3mf(model_, NMR::lib3mf_model_getbuilditems(model_, iterator.out()));
    BOOL more = false;
    while (require_3mf(iterator, NMR::lib3mf_builditemiterator_movenext(iterator, &more)), more) {
        ThreeMfHandle item, object;
        require_3mf(iterator, NMR::lib3mf_builditemiterator_getcurrent(iterator, item.out()));
        require_3mf(item, NMR::lib3mf_builditem_getobjectresource(item, object.out()));
        NMR::MODELTRANSFORM transform;
        require_3mf(item, NMR::lib3mf_builditem_getobjecttransform(item, &transform));
        items.push_back({std::move(object), glm::dmat4(glm::dmat3(unit())) * matrix(transform)});
        if (items.size() > most_placements) fail(fmt::format("places more than {} objects", most_placements));
    }
    return items;
}

/// Objects may be made of others, each named again and again.
void ThreeMfReader::place(std::vector<Placement> open)
{
    std::ranges::reverse(open);
    std::uint64_t placed = 0;
    while (!open.empty()) {
        const Placement next = std::move(open.back());
        open.pop_back();
        if (++placed > most_placements) fail(fmt::format("places more than {} objects", most_placements));
        BOOL is_mesh = false, is_composed = false;
        require_3mf(next.object, NMR::lib3mf_object_ismeshobject(next.object, &is_mesh));
        require_3mf(next.object, NMR::lib3mf_object_iscomponentsobject(next.object, &is_composed));
        if (is_mesh) place_mesh(next.object, next.place);
        if (!is_composed) continue;
        DWORD count = 0;
        require_3mf(next.object, NMR::lib3mf_componentsobject_getcomponentcount(next.object, &count));
        if (open.size() + count > most_placements) fail(fmt::format("places more than {} objects", most_placements));
        for (DWORD i = count; i-- > 0;) {
            ThreeMfHandle component, object;
            require_3mf(next.object, NMR::lib3mf_componentsobject_getcomponent(next.object, i, component.out()));
            require_3mf(component, NMR::lib3mf_component_getobjectresource(component, object.out()));
            NMR::MODELTRANSFORM transform;
            require_3mf(component, NMR::lib3mf_component_gettransform(component, &transform));
            open.push_back({std::move(object), next.place * matrix(transform)});
        }
    }
}

std::int32_t ThreeMfReader::base_material(DWORD group, DWORD index)
{
    const auto [known, is_new] = paint_of_material_.try_emplace({group, index}, 0);
    if (!is_new) return known->second;
    ThreeMfHandle materials;
    require_3mf(model_, NMR::lib3mf_model_getbasematerialbyid(model_, group, materials.out()));
    BYTE red = 0, green = 0, blue = 0, alpha = 0;
    require_3mf(materials, NMR::lib3mf_basematerial_getdisplaycolor(materials, index, &red, &green, &blue, &alpha));
    std::string name(256, '\0');
    ULONG needed = 0;
    if (NMR::lib3mf_basematerial_getnameutf8(materials, index, name.data(), static_cast<ULONG>(name.size()), &needed) != 0) name.clear();
    name = name.c_str();
    const std::size_t blank = std::min(name.find(' '), name.size());
    materials_.push_back({group_of_material(std::string_view(name).substr(0, blank)), {red, green, blue}, name.substr(std::min(blank + 1, name.size()))});
    return known->second = static_cast<std::int32_t>(materials_.size());
}

std::int32_t ThreeMfReader::colour(const NMR::MODELMESHCOLOR_SRGB& c)
{
    if (c.m_Alpha == 0) return 0; // none
    const std::uint32_t code = std::uint32_t(c.m_Red) << 16 | std::uint32_t(c.m_Green) << 8 | c.m_Blue;
    const auto [known, is_new] = paint_of_colour_.try_emplace(code, static_cast<std::int32_t>(materials_.size()) + 1);
    if (is_new) materials_.push_back({{}, {c.m_Red, c.m_Green, c.m_Blue}, {}});
    return known->second;
}

std::vector<std::int32_t> ThreeMfReader::paints(ThreeMfObject mesh, std::size_t triangles)
{
    ThreeMfHandle properties;
    require_3mf(mesh, NMR::lib3mf_meshobject_createpropertyhandler(mesh, properties.out()));
    std::vector<DWORD> groups(triangles), indices(triangles);
    std::vector<NMR::MODELMESH_TRIANGLECOLOR_SRGB> colours(triangles);
    require_3mf(properties, NMR::lib3mf_propertyhandler_getbasematerialarray(properties, groups.data(), indices.data()));
    require_3mf(properties, NMR::lib3mf_propertyhandler_getcolorarray(properties, colours.data()));
    std::vector<std::int32_t> paints(triangles);
    for (std::size_t t = 0; t < triangles; ++t) paints[t] = groups[t] != 0 ? base_material(groups[t], indices[t]) : colour(colours[t].m_Colors[0]);
    return paints;
}

void ThreeMfReader::place_mesh(ThreeMfObject mesh, const glm::dmat4& place)
{
    DWORD vertices = 0, triangles = 0;
    require_3mf(mesh, NMR::lib3mf_meshobject_getvertexcount(mesh, &vertices));
    require_3mf(mesh, NMR::lib3mf_meshobject_gettrianglecount(mesh, &triangles));
    if (builder_.corner_count() + 3 * std::uint64_t(triangles) > most_placed_corners) fail(fmt::format("more than {} corners, with each object wherever it is placed", most_placed_corners));
    if (vertices == 0 || triangles == 0) {
        ++passed_over_;
        return;
    }
    std::vector<NMR::MODELMESHVERTEX> at(vertices);
    std::vector<NMR::MODELMESHTRIANGLE> corners(triangles);
    require_3mf(mesh, NMR::lib3mf_meshobject_getvertices(mesh, at.data(), vertices, nullptr));
    require_3mf(mesh, NMR::lib3mf_meshobject_gettriangleindices(mesh, corners.data(), triangles, nullptr));
    const std::vector<std::int32_t> paint = paints(mesh, triangles);
    const bool mirrored = glm::determinant(glm::dmat3(place)) < 0;
    const auto add_corner = [&](DWORD v) {
        if (v >= vertices) fail(fmt::format("a triangle names vertex {}, its mesh has {}", v, vertices));
        const glm::dvec4 p = place * glm::dvec4(at[v].m_fPosition[0], at[v].m_fPosition[1], at[v].m_fPosition[2], 1.0);
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(p[axis]) <= largest_coordinate)) fail(fmt::format("coordinate {}: expected at most {} in size", p[axis], largest_coordinate));
        builder_.add_corner(weld_.vertex({p.x + 0.0, p.y + 0.0, p.z + 0.0})); // no −0
    };
    for (std::size_t t = 0; t < triangles; ++t) {
        const auto& v = corners[t].m_nIndices;
        add_corner(v[0]);
        add_corner(v[mirrored ? 2 : 1]);
        add_corner(v[mirrored ? 1 : 2]);
        builder_.end_face(paint[t]);
        if (builder_.face_count() % (1u << 20) == 0) source_.read(nullptr, 0);
    }
}

Model ThreeMfReader::read()
{
    std::vector<char> bytes = source_.read_all(largest_package);
    check_unpacked(bytes);
    const KeptLocale kept;
    try {
        open(bytes);
        place(build_items());
    } catch (const ThreeMfError& error) {
        fail("is no 3MF file that can be read: " + error.what);
    }
    if (builder_.face_count() == 0) fail("holds no triangles");
    Model model;
    if (passed_over_ > 0) model.notes.push_back(fmt::format("{} object{} without triangles: passed over", passed_over_, passed_over_ == 1 ? "" : "s"));
    groups_from_materials(builder_.groups(), materials_.size(), [&](std::size_t m) { return materials_[m]; }, model.groups);
    build_mesh(builder_, source_, model, most_elements); // loose vertices are corners of triangles left out, not something the file lists
    return model;
}

} // namespace

Model read_3mf(ByteSource& source)
{
    return ThreeMfReader(source).read();
}

} // namespace druse
