#pragma once

#include "render/still.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace druse {

/// `druse apply`: commands, scripts and outputs in the order given.
struct ApplyRequest {
    struct Step {
        enum class Kind { command, script, output };
        Kind kind;
        std::string text;
    };
    std::optional<std::string> input; // nothing: an empty document
    std::string format;               // of what goes through `-`
    bool ascii = false;
    std::vector<Step> steps;
};

struct InfoRequest {
    std::string input, format;
    bool json = false, check = false;
};

struct RenderRequest {
    std::string input, format, output;
    bool smooth = false;
    bool flat = false; // the tiling of a tile, in the plane
    StillOptions options;
};

struct OpsRequest {
    enum class Form { text, json, markdown };
    std::string name; // empty: all operators
    Form form = Form::text;
};

struct WindowRequest {
    std::string file, geometry, event_log, record, replay;
    bool test = false;
    double ui_scale = 0; // 0: as in the preferences
};

/// Something to print: help, or the version.
struct PrintRequest {
    std::string text;
};

using Request = std::variant<ApplyRequest, InfoRequest, RenderRequest, OpsRequest, WindowRequest, PrintRequest>;

/// What the arguments of the program ask for. @throws CommandError, in one line, for everything that is not as `--help` says
Request parse_arguments(int argc, const char* const* argv);

} // namespace druse
