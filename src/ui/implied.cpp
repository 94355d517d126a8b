#include "ui/implied.h"

#include "dlfl/errors.h"
#include "geom/angle.h"
#include "ops/solid.h"
#include "ops/solid_pattern.h"
#include "ops/text.h"

#include <array>
#include <cmath>

namespace druse::ui {

namespace {

/// What of a solid does not change while its sliders move.
struct Profile {
    std::array<std::string, 5> of; // the arguments that choose it
    double angle = 0;              // degrees
    int tiers = 0;
};

Profile read_profile(const std::array<std::string, 5>& of)
{
    const auto& [solid, base, turns, phase, mirror] = of;
    PatternChoice choice;
    if (base.starts_with("face:")) choice.base = Face(parse_id(base.substr(5)));
    else if (!base.empty()) choice.sides = static_cast<int>(parse_id(base));
    if (!turns.empty()) choice.turns = static_cast<int>(parse_id(turns));
    choice.phase = static_cast<int>(parse_id(phase));
    choice.mirror = mirror == "true";
    const SolidPattern pattern = read_pattern(make_solid(solid, 1.0), choice);
    return {of, degrees(pattern.wall_angles.at(0)), pattern.tiers};
}

} // namespace

Implied implied_values(const Arguments& arguments)
{
    const Operator& op = arguments.op();
    const Parameter* solid = op.find("solid");
    if (op.name != "extrude.solid" || !solid) return {};
    const std::string name = arguments.text("solid");
    if (name.empty() || solid->names_file(name)) return {};

    static Profile last;
    const std::array<std::string, 5> of{name, arguments.text("base"), arguments.text("turns"), arguments.text("phase"), arguments.text("mirror")};
    try {
        if (last.of != of) last = read_profile(of);
    } catch (const CommandError&) {
        return {}; // the command will say what is wrong
    }

    Implied implied;
    const std::string angle = arguments.text("angle"), heights = arguments.text("heights");
    implied["angle"] = angle.empty() ? number_text(std::round(last.angle * 1e6) / 1e6) : angle;
    const auto given = split(heights, ',');
    const bool one_each = int(given.size()) == last.tiers;
    std::string& all = implied["heights"];
    for (int i = 0; i < last.tiers; ++i) {
        if (i > 0) all += ',';
        all += given[one_each ? std::size_t(i) : 0];
    }
    return implied;
}

} // namespace druse::ui
