#pragma once

#include "geom/colour.h"
#include "io/byte_source.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace druse {

struct Material {
    std::optional<Colour> colour; // of `Kd`, the colour in white light
    std::string group_name;       // of `# name WORD`
};

/// Hashes names without making strings of them.
struct NameHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view name) const { return std::hash<std::string_view>()(name); }
};

/// The materials of the .mtl files that a model names.
class Materials {
public:
    /// Reads the files named after `mtllib`: one name with blanks in it, if there is such a file, or else several names.
    void read_library(const ByteSource& model, std::string_view names);
    /// Reads one file.
    void read(ByteSource& file);

    const Material* find(std::string_view name) const;

    /// Says which of the files named were not there, and where a colour was none; its material is then known by its name only.
    std::vector<std::string> notes() const;

private:
    std::unordered_map<std::string, Material, NameHash, std::equal_to<>> by_name_;
    std::vector<std::string> missing_;
    std::string first_malformed_; // where, and what was found
    std::uint64_t malformed_ = 0;
};

/// `group_<id>`, the material of a group as our own writers call it.
std::string material_of_group(int id);
/// The id in such a name, or nothing.
std::optional<int> group_of_material(std::string_view name);

} // namespace druse
