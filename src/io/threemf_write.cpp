#include "io/threemf.h"

#include "dlfl/errors.h"
#include "io/indexed_triangles.h"
#include "io/materials.h"
#include "io/require_faces.h"
#include "io/threemf_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace druse {

namespace {

constexpr double threemf_step = 1e-6; // the last digit that lib3mf writes

class ThreeMfWriter {
public:
    ThreeMfWriter(const ModelView& model, OutputFiles& out) : table_(model.groups), out_(out), triangles_(model, out, "3MF") {}
    void write();

private:
    void make_model();
    std::vector<NMR::MODELMESHVERTEX> places() const;
    void take_triangles(const std::vector<NMR::MODELMESHVERTEX>& places);
    void paint(ThreeMfObject object);

    const GroupTable& table_;
    OutputFiles& out_;
    IndexedTriangles triangles_;
    std::vector<NMR::MODELMESHTRIANGLE> corners_; // those that are saved
    std::vector<DWORD> parts_;                    // which part of the triangles each is of
    ThreeMfHandle model_;
};

/// As the file will have them.
std::vector<NMR::MODELMESHVERTEX> ThreeMfWriter::places() const
{
    constexpr float farthest = 1e9f; // that lib3mf takes
    std::vector<NMR::MODELMESHVERTEX> places(triangles_.point_count());
    for (std::uint32_t p = 0; p < places.size(); ++p) {
        const auto at = triangles_.place(p);
        for (std::size_t i = 0; i < 3; ++i) {
            if (!(std::abs(at[i]) <= farthest))
                throw InputError(out_.name(), fmt::format("vertex {} lies at {},{},{}: 3MF goes to {} mm", p, at[0], at[1], at[2], farthest));
            places[p].m_fPosition[i] = static_cast<float>(std::round(at[i] / threemf_step) * threemf_step) + 0.0f; // no −0
        }
    }
    return places;
}

/// Triangles that have one point twice are left out: what lies along their sides is then joined without them. Others keep their neighbours by number, but
/// a model may be too small for the step.
void ThreeMfWriter::take_triangles(const std::vector<NMR::MODELMESHVERTEX>& places)
{
    corners_.resize(triangles_.count());
    static_assert(sizeof(NMR::MODELMESHTRIANGLE) == sizeof(IndexedTriangles::Triangle));
    triangles_.put(reinterpret_cast<unsigned char*>(corners_.data()));
    for (std::size_t part = 0; part < triangles_.part_count(); ++part) parts_.resize(triangles_.end(part), static_cast<DWORD>(part));
    std::size_t kept = 0;
    std::uint64_t flat = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const auto& [a, b, c] = corners_[i].m_nIndices;
        if (a == b || b == c || c == a) continue;
        const auto same = [&](DWORD p, DWORD q) { return std::ranges::equal(places[p].m_fPosition, places[q].m_fPosition); };
        flat += same(a, b) || same(b, c) || same(c, a);
        corners_[kept] = corners_[i];
        parts_[kept++] = parts_[i];
    }
    const std::uint64_t left_out = corners_.size() - kept;
    corners_.resize(kept);
    parts_.resize(kept);
    if (flat == kept) throw InputError(out_.name(), fmt::format("no triangle has an area in steps of {} mm, those of 3MF", threemf_step));
    const auto counted = [](std::uint64_t n) { return n == 1 ? std::string("1 triangle has") : fmt::format("{} triangles have", n); };
    if (left_out > 0) out_.note(fmt::format("{} a vertex twice: not saved in 3MF", counted(left_out)));
    if (flat > 0) out_.note(fmt::format("{} corners at one place in steps of {} mm, those of 3MF", counted(flat), threemf_step));
}

void ThreeMfWriter::paint(ThreeMfObject object)
{
    if (triangles_.groups().empty()) return;
    ThreeMfHandle materials;
    require_3mf(model_, NMR::lib3mf_model_addbasematerialgroup(model_, materials.out()));
    DWORD id = 0;
    require_3mf(materials, NMR::lib3mf_basematerial_getresourceid(materials, &id));
    std::vector<DWORD> materials_of_parts(triangles_.part_count());
    for (std::size_t part = 0; part < triangles_.part_count(); ++part) {
        const int group = triangles_.groups()[part];
        const Colour c = table_.colour(group);
        std::string name = material_of_group(group);
        if (!table_.name(group).empty()) name += " " + table_.name(group);
        require_3mf(materials, NMR::lib3mf_basematerial_addmaterialutf8(materials, name.c_str(), c.red, c.green, c.blue, &materials_of_parts[part]));
    }
    std::vector<DWORD> ids(corners_.size(), id), indices(corners_.size());
    std::ranges::transform(parts_, indices.begin(), [&](DWORD part) { return materials_of_parts[part]; });
    ThreeMfHandle whole, each;
    require_3mf(object, NMR::lib3mf_object_createdefaultpropertyhandler(object, whole.out()));
    require_3mf(whole, NMR::lib3mf_defaultpropertyhandler_setbasematerial(whole, id, indices.front()));
    require_3mf(object, NMR::lib3mf_meshobject_createpropertyhandler(object, each.out()));
    require_3mf(each, NMR::lib3mf_propertyhandler_setbasematerialarray(each, ids.data(), indices.data()));
}

/// Without ids of our own lib3mf would make random ones.
void ThreeMfWriter::make_model()
{
    auto at = places();
    take_triangles(at);
    require_3mf(nullptr, NMR::lib3mf_createmodel(model_.out()));
    require_3mf(model_, NMR::lib3mf_model_setunit(model_, NMR::MODELUNIT_MILLIMETER));
    ThreeMfHandle object, item;
    require_3mf(model_, NMR::lib3mf_model_addmeshobject(model_, object.out()));
    require_3mf(object, NMR::lib3mf_meshobject_setgeometry(object, at.data(), static_cast<DWORD>(at.size()), corners_.data(), static_cast<DWORD>(corners_.size())));
    paint(object);
    require_3mf(model_, NMR::lib3mf_model_addbuilditem(model_, object, nullptr, item.out()));
    require_3mf(object, NMR::lib3mf_object_setuuidutf8(object, "5a3f7b0c-0000-4000-8000-000000000001"));
    require_3mf(item, NMR::lib3mf_builditem_setuuidutf8(item, "5a3f7b0c-0000-4000-8000-000000000002"));
    require_3mf(model_, NMR::lib3mf_model_setbuilduuidutf8(model_, "5a3f7b0c-0000-4000-8000-000000000003"));
}

void ThreeMfWriter::write()
{
    constexpr std::uint64_t most_triangles = std::uint64_t(1) << 27;
    if (triangles_.count() > most_triangles) throw InputError(out_.name(), fmt::format("{} triangles are too many for 3MF", triangles_.count()));
    const KeptLocale kept;
    try {
        make_model();
        ThreeMfHandle writer;
        require_3mf(model_, NMR::lib3mf_model_querywriter(model_, "3mf", writer.out()));
        using Write = std::uint32_t (*)(unsigned char*, std::uint32_t, void*);
        using Seek = std::uint32_t (*)(std::uint64_t, void*);
        struct Buffer {
            std::string bytes;
            std::size_t at = 0;
        } buffer;
        const Write put = [](unsigned char* bytes, std::uint32_t count, void* to) -> std::uint32_t {
            auto& p = *static_cast<Buffer*>(to);
            if (p.bytes.size() < p.at + count) p.bytes.resize(p.at + count);
            std::memcpy(p.bytes.data() + p.at, bytes, count);
            p.at += count;
            return 0;
        };
        const Seek seek = [](std::uint64_t place, void* to) -> std::uint32_t {
            static_cast<Buffer*>(to)->at = static_cast<std::size_t>(place);
            return 0;
        };
        require_3mf(writer, NMR::lib3mf_writer_writetocallback(writer, reinterpret_cast<void*>(put), reinterpret_cast<void*>(seek), &buffer));
        out_.main().put(buffer.bytes);
    } catch (const ThreeMfError& error) {
        throw InputError(out_.name(), "cannot be written: " + error.what);
    }
}

} // namespace

void write_3mf(const ModelView& model, OutputFiles& out)
{
    require_faces(model, out, "3MF");
    ThreeMfWriter(model, out).write();
}

} // namespace druse
