#pragma once

#include "ops/registry.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace druse {

/// The presets that a person has made, beside those that operators are registered with.
///
/// The file has a line for each, a command that names it and the values it stands for: `extrude.cubical preset=spike angle=60`.
/// Lines that cannot be understood are passed over, and stay as they are.
class PresetFile {
public:
    /// Without a file: presets last as long as this.
    PresetFile() = default;
    /// Reads the file; one that is not there, or cannot be read, holds none.
    explicit PresetFile(std::filesystem::path file);

    /// `$XDG_CONFIG_HOME/druse/presets`, or `~/.config/druse/presets`.
    static std::filesystem::path default_path();

    /// Those of an operator, in the order in which they were made.
    std::vector<Preset> of(const Operator& op) const;
    /// Keeps one, in place of the operator's own of the same name, and writes the file.
    /// @throws CommandError for an empty name or that of a registered preset; InputError if the file cannot be written
    void store(const Operator& op, Preset preset);
    /// Takes it out, if there is one, and writes the file. @throws InputError
    void forget(const Operator& op, std::string_view name);

    /// A command in which `preset=NAME` gives way to the values of a preset in the file; other keys that it gives go before them.
    /// A command without such a preset is not changed.
    std::string expand(const Registry& registry, const std::string& command) const;

private:
    struct Line {
        std::string text;
        std::string operator_name; // empty: not understood
        Preset preset;
    };
    static Line parse(std::string_view text);
    std::vector<Line>::iterator find(const Operator& op, std::string_view name);
    void write() const;

    std::filesystem::path file_;
    std::vector<Line> lines_;
};

} // namespace druse
