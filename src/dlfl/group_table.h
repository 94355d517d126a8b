#pragma once

#include "geom/colour.h"

#include <map>
#include <optional>
#include <string>

namespace druse {

/// Colours and names of face groups. A group exists while a face carries its id; what is remembered here outlives that.
class GroupTable {
public:
    /// The colour every program run gives to a group nobody coloured: HSV with a golden-ratio hue, saturation 0.62, value 0.93;
    /// grey 204 for id 0.
    static Colour default_colour(int id);

    Colour colour(int id) const;
    const std::string& name(int id) const; // empty if the group has none
    bool has_own_colour(int id) const;

    void set_colour(int id, Colour c);
    void set_default_colour(int id);
    void set_name(int id, std::string name);
    /// Drops what is remembered of a group.
    void forget(int id);

    friend bool operator==(const GroupTable&, const GroupTable&) = default;

private:
    struct Entry {
        std::optional<Colour> colour;
        std::string name;
        friend bool operator==(const Entry&, const Entry&) = default;
    };
    std::map<int, Entry> entries_;
};

} // namespace druse
