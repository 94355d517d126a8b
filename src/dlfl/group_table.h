#pragma once

#include "geom/colour.h"

#include <map>
#include <string>
#include <vector>

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

    /// Cost: O(1) for an id above all others, as readers give them.
    void set_colour(int id, Colour c);
    void set_default_colour(int id);
    void set_name(int id, std::string name);
    /// Drops what is remembered of a group.
    void forget(int id);

    friend bool operator==(const GroupTable&, const GroupTable&) = default;

private:
    struct Own {
        int id;
        Colour colour;
        friend bool operator==(const Own&, const Own&) = default;
    };
    std::vector<Own>::const_iterator find(int id) const; // the first that is not below

    std::vector<Own> colours_; // ascending ids; a photograph may bring a million of them
    std::map<int, std::string> names_;
};

} // namespace druse
