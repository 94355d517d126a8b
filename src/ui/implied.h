#pragma once

#include "ui/arguments.h"

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace druse::ui {

/// What a parameter works out to.
struct ImpliedValue {
    std::string text;
    double usual = 0; // of a number, what it is where nothing is given: around it a slider lies
};
using Implied = std::map<std::string, ImpliedValue, std::less<>>; // by name

/// What some parameters work out to where a command leaves them unset or `auto`, or gives one number for many: of `extrude.solid` the solid's
/// own angle, and a height for each of its tiers; of `graph.map` and `graph.lattice` sizes. So they can have sliders, though only the other arguments say
/// how many, and where they begin. Empty for other operators, while the arguments name no solid, and for files that would take long to read.
/// `folder`: what names of files are relative to.
Implied implied_values(const Arguments& arguments, const std::filesystem::path& folder = {});

} // namespace druse::ui
