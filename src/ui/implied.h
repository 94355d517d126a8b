#pragma once

#include "ui/arguments.h"

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace druse::ui {

/// Texts of parameters by name.
using Implied = std::map<std::string, std::string, std::less<>>;

/// What some parameters work out to where a command leaves them unset, or gives one number for many: of `extrude.solid` the solid's
/// own angle, and a height for each of its tiers. So they can have sliders, though only the other arguments say how many, and where
/// they begin. Empty for other operators, while the arguments name no solid, and for files that would take long to read.
/// `folder`: what names of files are relative to.
Implied implied_values(const Arguments& arguments, const std::filesystem::path& folder = {});

} // namespace druse::ui
