#include "io/group_materials.h"

#include "dlfl/errors.h"
#include "geom/sort_unique.h"
#include "io/materials.h"

#include <algorithm>

namespace druse {

std::vector<int> groups_in_use(const Mesh& mesh, const GroupTable& groups)
{
    std::vector<int> used;
    for (const int id : mesh.groups())
        if (used.empty() || used.back() != id) used.push_back(id);
    sort_unique(used);
    if (used.size() == 1 && used[0] == 0 && !groups.has_own_colour(0) && groups.name(0).empty()) used.clear();
    return used;
}

std::string group_name_in(std::string_view text)
{
    const auto ends = [](char c) { return static_cast<unsigned char>(c) <= ' ' || c == '\x7f'; };
    return {text.begin(), std::find_if(text.begin(), text.end(), ends)};
}

std::string write_group_materials(const GroupTable& groups, const std::vector<int>& used, OutputFiles& out)
{
    if (used.empty()) return {};
    if (out.stem().find('\n') != std::string::npos)
        throw InputError(out.name(), "a name with a line break, which the file cannot hold");
    ByteSink* const sink = out.side_file("mtl");
    if (!sink) {
        out.note("group colours and names are not saved: there is no place for a .mtl file");
        return {};
    }
    for (const int id : used) {
        sink->put("newmtl " + material_of_group(id) + '\n');
        if (!groups.name(id).empty()) sink->put("# name " + groups.name(id) + '\n');
        const Colour c = groups.colour(id);
        sink->put("Kd");
        for (const std::uint8_t channel : {c.red, c.green, c.blue}) {
            sink->put(' ');
            sink->put(static_cast<float>(channel) / 255.0f);
        }
        sink->put('\n');
    }
    return out.stem() + ".mtl";
}

} // namespace druse
