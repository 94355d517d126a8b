#include "io/format.h"

#include "dlfl/errors.h"
#include "io/dlfl_file.h"
#include "io/glb.h"
#include "io/obj.h"
#include "io/off.h"
#include "io/pane_file.h"
#include "io/ply.h"
#include "io/stl.h"
#include "io/threemf.h"
#include "io/tile_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace druse {

namespace {

constexpr Format all_formats[] = {
    {"obj", "Wavefront OBJ", read_obj, write_obj},
    {"stl", "Stereolithography", read_stl, write_stl},
    {"dlfl", "TopMod", read_dlfl, write_dlfl},
    {"ply", "Polygon File Format", read_ply, write_ply},
    {"off", "Object File Format", read_off, write_off},
    {"glb", "Binary glTF", read_gltf, write_glb},
    {"gltf", "glTF", read_gltf, write_gltf},
    {"3mf", "3D Manufacturing Format", read_3mf, write_3mf},
    {"pane.json", "Pane", read_pane, write_pane},
    {"tile", "Escher tile", read_tile, write_tile},
    {"svg", "Drawing of a tiling", read_svg, write_svg},
    {"dxf", "Tiling for a cutter", read_dxf, write_dxf},
};

std::string extensions()
{
    std::string text;
    for (std::size_t i = 0; i < std::size(all_formats); ++i)
        text += fmt::format("{}{}", i == 0 ? "" : i + 1 == std::size(all_formats) ? " or " : ", ", all_formats[i].extension);
    return text;
}

char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
}

/// The format whose name a text is, or ends in behind a dot: `pane.json` comes before `json` would.
const Format* find(std::string_view text, bool as_ending)
{
    for (const Format& format : all_formats) {
        const std::string_view name = format.extension;
        if (as_ending ? text.size() <= name.size() || text[text.size() - name.size() - 1] != '.' : text.size() != name.size()) continue;
        const std::string_view end = text.substr(text.size() - name.size());
        if (std::equal(end.begin(), end.end(), name.begin(), [](char a, char b) { return lower(a) == b; })) return &format;
    }
    return nullptr;
}

} // namespace

std::span<const Format> formats()
{
    return all_formats;
}

const Format& format_named(std::string_view name, const std::string& where)
{
    if (const Format* format = find(name, false)) return *format;
    throw InputError(where, fmt::format("unknown format '{}'; expected {}", name, extensions()));
}

const Format& format_of(const std::filesystem::path& path)
{
    if (const Format* format = find(path.filename().string(), true)) return *format;
    const std::string extension = path.extension().string();
    if (extension.size() < 2)
        throw InputError(path.string(), fmt::format("a name without a format; expected one that ends in {}", extensions()));
    return format_named(std::string_view(extension).substr(1), path.string());
}

} // namespace druse
