#pragma once

#include <numbers>

namespace druse {

constexpr double pi = std::numbers::pi;
constexpr double radians(double degrees) { return degrees * (pi / 180.0); }
constexpr double degrees(double radians) { return radians * (180.0 / pi); }

} // namespace druse
