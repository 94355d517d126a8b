#include "ui/implied.h"

#include "dlfl/errors.h"
#include "geom/angle.h"
#include "graph/map.h"
#include "io/read.h"
#include "ops/solid.h"
#include "ops/solid_pattern.h"
#include "ops/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace druse::ui {

namespace {

/// A solid of so many bytes is read at once; it has some thousand faces.
constexpr std::uintmax_t quickly_read = 200'000;

/// What chooses a profile: solid, base, turns, phase and mirror as the arguments have them, and when the file was written.
struct Choice {
    std::array<std::string, 5> texts;
    std::filesystem::path file; // empty: a built-in solid
    std::filesystem::file_time_type written;
    friend bool operator==(const Choice&, const Choice&) = default;
};

/// What of a solid does not change while its sliders move.
struct Profile {
    Choice of;
    double angle = 0; // degrees
    int tiers = 0;
};

Profile read_profile(const Choice& of)
{
    const auto& [solid, base, turns, phase, mirror] = of.texts;
    PatternChoice choice;
    choice.exact = of.file.empty();
    if (base.starts_with("face:")) choice.base = Face(parse_id(base.substr(5)));
    else if (!base.empty()) choice.sides = static_cast<int>(parse_id(base));
    if (!turns.empty()) choice.turns = static_cast<int>(parse_id(turns));
    choice.phase = static_cast<int>(parse_id(phase));
    choice.mirror = mirror == "true";
    const SolidPattern pattern = read_pattern(of.file.empty() ? make_solid(solid, 1.0) : read_model(of.file).mesh, choice);
    return {of, degrees(pattern.wall_angles.at(0)), pattern.tiers};
}

/// A number that stands for `auto`.
void add_auto(Implied& implied, const Arguments& arguments, const std::string& name, double usual)
{
    const std::string text = arguments.text(name);
    implied[name] = {text == "auto" ? number_text(usual) : text, usual};
}

Implied implied_by_sweep(const Arguments& arguments)
{
    const std::string to = arguments.text("to");
    if (to != "torus" && to != "knot") return {};
    const SweepSize usual = usual_sweep(to == "torus" ? MapTo::torus : MapTo::knot);
    Implied implied;
    add_auto(implied, arguments, "cycles", usual.cycles);
    add_auto(implied, arguments, "major", usual.major);
    add_auto(implied, arguments, "rho", usual.rho);
    return implied;
}

Implied implied_by_cells(const Arguments& arguments)
{
    if (arguments.text("trim") != "ball") return {};
    const std::string cells = arguments.text("cells");
    std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
    for (const std::string_view n : split(cells, ',')) least = std::min(least, parse_id(n));
    Implied implied;
    add_auto(implied, arguments, "size", 0.5 * least);
    return implied;
}

Implied implied_by_solid(const Arguments& arguments, const std::filesystem::path& folder)
{
    const Parameter* solid = arguments.op().find("solid");
    Choice of;
    std::ranges::transform(std::array{"solid", "base", "turns", "phase", "mirror"}, of.texts.begin(), [&](const char* name) { return arguments.text(name); });
    if (of.texts[0].empty()) return {};
    if (solid->names_file(of.texts[0])) {
        of.file = folder / of.texts[0];
        std::error_code error, other;
        of.written = std::filesystem::last_write_time(of.file, error);
        if (std::filesystem::file_size(of.file, other) > quickly_read || error || other) return {};
    }

    static Profile last;
    try {
        if (!(last.of == of)) last = read_profile(of);
    } catch (const CommandError&) {
        return {}; // the command will say what is wrong
    } catch (const InputError&) {
        return {};
    }

    Implied implied;
    const std::string angle = arguments.text("angle"), heights = arguments.text("heights");
    implied["angle"] = {angle.empty() ? number_text(std::round(last.angle * 1e6) / 1e6) : angle, last.angle};
    const auto given = split(heights, ',');
    const bool one_each = int(given.size()) == last.tiers;
    std::string& all = implied["heights"].text;
    for (int i = 0; i < last.tiers; ++i) {
        if (i > 0) all += ',';
        all += given[one_each ? std::size_t(i) : 0];
    }
    return implied;
}

} // namespace

Implied implied_values(const Arguments& arguments, const std::filesystem::path& folder)
{
    const std::string& name = arguments.op().name;
    if (name == "graph.map") return implied_by_sweep(arguments);
    if (name == "graph.lattice") return implied_by_cells(arguments);
    return name == "extrude.solid" ? implied_by_solid(arguments, folder) : Implied();
}

} // namespace druse::ui
