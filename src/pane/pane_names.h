#pragma once

#include "pane/pane.h"

#include <functional>
#include <optional>
#include <span>
#include <string>

namespace druse {

// For whoever has points of his own in a pane, by other names than numbers.

/// What a refusal or note says behind the word for its reason, with other names for points: `name` is asked for each `point 4`, and says nothing of those that it
/// does not know.
std::string with_names(const std::string& text, const std::function<std::string(std::uint32_t)>& name);

/// The first segment that runs between the ends of a path, either way, and by all points between.
std::optional<SegmentId> segment_along(const Pane& pane, std::span<const PointId> path);

} // namespace druse
