#include "io/dlfl_file.h"

#include "dlfl/errors.h"
#include "dlfl/measures.h"
#include "io/group_materials.h"
#include "io/materials.h"
#include "io/require_faces.h"

#include <fmt/format.h>

#include <array>

namespace druse {

namespace {

class DlflWriter {
public:
    DlflWriter(const ModelView& model, OutputFiles& out) : mesh_(model.mesh), groups_(model.groups), rind_(model.rind), out_(out), sink_(out.main())
    {
    }
    void write();

private:
    void put_corners(Face f);
    void put_face(Face f);
    void put_extension();
    void put_rind();

    const Mesh& mesh_;
    const GroupTable& groups_;
    const Rind* rind_;
    OutputFiles& out_;
    ByteSink& sink_;
    std::vector<std::uint32_t> number_; // of each corner, in the file
    std::uint32_t corners_ = 0;
};

void DlflWriter::put_corners(Face f)
{
    const Vector normal = unit_normal(mesh_, f);
    std::array<char, 96> text;
    const char* const end =
        fmt::format_to(text.data(), " [{:.6f} {:.6f} {:.6f}] [0.000000 0.000000] \n", normal.x, normal.y, normal.z);
    for (const Corner c : mesh_.corners(f)) {
        number_[c.index] = corners_++;
        sink_.put("fv ");
        sink_.put(std::uint64_t(mesh_.vertex(c).index));
        sink_.put(std::string_view(text.data(), static_cast<std::size_t>(end - text.data())));
    }
}

void DlflWriter::put_face(Face f)
{
    sink_.put('f');
    for (const Corner c : mesh_.corners(f)) {
        sink_.put(' ');
        sink_.put(std::uint64_t(number_[c.index]));
    }
    sink_.put('\n');
}

void DlflWriter::put_extension()
{
    sink_.put("druse 1\n");
    std::uint32_t in_line = 0;
    const auto put_group = [&](int group) {
        sink_.put(in_line == 0 ? "g " : " ");
        sink_.put(static_cast<std::uint64_t>(group));
        if (++in_line == 20) {
            sink_.put('\n');
            in_line = 0;
        }
    };
    for (const Face f : mesh_.faces()) put_group(mesh_.group(f));
    for (std::uint32_t i = 0; i < mesh_.boundary_count(); ++i) put_group(0);
    if (in_line > 0) sink_.put('\n');
    if (rind_) put_rind();
    if (mesh_.boundary_count() == 0) return;
    sink_.put("open");
    for (std::uint32_t i = 0; i < mesh_.boundary_count(); ++i) {
        sink_.put(' ');
        sink_.put(std::uint64_t(mesh_.face_count() + i));
    }
    sink_.put('\n');
}

void DlflWriter::put_rind()
{
    for (const Rind::Pair& p : rind_->pairs(mesh_)) {
        sink_.put("rind");
        for (const std::uint32_t number : {p.first.index, p.second.index, p.first_corner, p.second_corner}) {
            sink_.put(' ');
            sink_.put(std::uint64_t(number));
        }
        sink_.put('\n');
    }
}

void DlflWriter::write()
{
    const std::vector<int> used = groups_in_use(mesh_, groups_);
    const std::string library = write_group_materials(groups_, used, out_);
    sink_.put("DLFL\n");
    if (!library.empty()) sink_.put("mtllib " + library + '\n');
    sink_.put("#\n");
    for (const Point& p : mesh_.positions()) {
        sink_.put("v ");
        sink_.put(p.x);
        sink_.put(' ');
        sink_.put(p.y);
        sink_.put(' ');
        sink_.put(p.z);
        sink_.put('\n');
    }
    sink_.put("#\n");
    number_.resize(mesh_.corner_limit());
    for (const Face f : mesh_.faces()) put_corners(f);
    for (const Face f : mesh_.boundary_faces()) put_corners(f);
    sink_.put("#\n");
    for (const Edge e : mesh_.edges()) {
        sink_.put("e ");
        sink_.put(std::uint64_t(number_[mesh_.corner(e, 0).index]));
        sink_.put(' ');
        sink_.put(std::uint64_t(number_[mesh_.corner(e, 1).index]));
        sink_.put('\n');
    }
    sink_.put("#\n");
    int group = -1;
    for (const Face f : mesh_.faces()) {
        if (!used.empty() && mesh_.group(f) != group) {
            group = mesh_.group(f);
            sink_.put("usemtl " + material_of_group(group) + '\n');
        }
        put_face(f);
    }
    for (const Face f : mesh_.boundary_faces()) put_face(f);
    sink_.put("#\n");
    put_extension();
}

} // namespace

void write_dlfl(const ModelView& model, OutputFiles& out)
{
    ASSERT(!model.mesh.has_holes(), "a mesh without holes");
    require_faces(model, out, "DLFL");
    DlflWriter(model, out).write();
}

} // namespace druse
