#include "ui/implied.h"

#include "dlfl/errors.h"
#include "geom/angle.h"
#include "io/read.h"
#include "ops/solid.h"
#include "ops/solid_pattern.h"
#include "ops/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

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

} // namespace

Implied implied_values(const Arguments& arguments, const std::filesystem::path& folder)
{
    const Operator& op = arguments.op();
    const Parameter* solid = op.find("solid");
    if (op.name != "extrude.solid" || !solid) return {};
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
