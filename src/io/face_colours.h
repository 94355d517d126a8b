#pragma once

#include "dlfl/column.h"
#include "dlfl/group_table.h"
#include "dlfl/handle.h"
#include "geom/point.h"
#include "io/materials.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace druse {

/// Numbers colours 1, 2, … in the order in which they are first met.
///
/// The table is a cube of cubes, made where colours lie: similar colours, as neighbouring faces have them, are neighbours in
/// memory.
class ColourNumbers {
public:
    int number(Colour c)
    {
        const std::uint32_t outer = (c.red >> 3) << 10 | (c.green >> 3) << 5 | c.blue >> 3;
        const std::uint32_t inner = (c.red & 7) << 6 | (c.green & 7) << 3 | (c.blue & 7);
        if (cube_of_[outer] == 0) add_cube(outer);
        const std::uint32_t at = (cube_of_[outer] - 1) * cube_size + inner;
        if (numbers_[at] == 0) {
            colours_.push_back(c);
            numbers_.set(at, static_cast<std::int32_t>(colours_.size()));
        }
        return numbers_[at];
    }
    std::span<const Colour> colours() const { return colours_; } // that of number n is at n − 1

private:
    static constexpr std::uint32_t cube_size = 8 * 8 * 8;
    void add_cube(std::uint32_t outer);

    std::vector<std::uint32_t> cube_of_ = std::vector<std::uint32_t>(32 * 32 * 32); // 1 + the place of a cube; 0: none
    Column<std::int32_t> numbers_;
    std::vector<Colour> colours_;
};

/// What a file says about the colours of its faces, and the groups that follow from it.
///
/// While reading, each face carries the number of its *paint*: 0 for none, else a material or a colour. At the end to_groups()
/// makes group ids of them. If all materials are called `group_<id>` they are the ids; otherwise faces of one colour are one
/// group. Source: Landreneau 2005, IV.4, for finding common colours.
class FacePaints {
public:
    std::int32_t material(std::string_view name); // an empty name: no paint
    std::int32_t colour(Colour c);

    /// Puts group ids in place of paints and the groups' colours and names into `groups`; false if no face has a paint.
    bool to_groups(std::span<std::int32_t> faces, const Materials& materials, GroupTable& groups) const;
    /// Puts the colours and names of groups that are known already into `groups`: those of the first face of each.
    void colour_groups(std::span<const std::int32_t> faces, std::span<const std::int32_t> ids, const Materials& materials,
                       GroupTable& groups) const;

private:
    struct Paint {
        bool is_colour;
        std::string material;
        Colour colour;
    };
    bool named_as_groups(const std::vector<bool>& used) const;

    std::vector<Paint> paints_ = {{false, "", {}}};
    std::unordered_map<std::string, std::int32_t, NameHash, std::equal_to<>> by_name_;
    std::map<Colour, std::int32_t> by_colour_;
};

/// Groups from the colours of vertices: a face has the mean of its corners' colours, rounded to 8 bits a channel, if all of them
/// have one (the first channel is a number). Equal colours are a group, numbered as first met.
/// @param corners the vertices of the faces, face after face; `ends` one past the last corner of each
void groups_from_vertex_colours(std::span<const Vertex> corners, std::span<const std::uint32_t> ends,
                                std::span<const Vector> colours, std::span<std::int32_t> faces, GroupTable& groups);

/// What a material says of the faces that have it.
struct NamedColour {
    std::optional<int> group; // in its name, as our own writers give it
    Colour colour;
    std::string name; // of that group
};

/// Groups from materials. A face comes with 0 for none, or 1 + which of the `count` materials it has, and leaves with its group: that of its material, if
/// all that are used say one; else those of one colour are a group, numbered as first met. Asks only for materials that are used.
void groups_from_materials(std::span<std::int32_t> faces, std::size_t count, const std::function<NamedColour(std::size_t)>& material, GroupTable& groups);

} // namespace druse
