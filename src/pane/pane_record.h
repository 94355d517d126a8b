#pragma once

#include "pane/pane.h"

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace druse {

/// All that a pane is, as files keep it. Lists of numbers count positions in `points`, which are in ascending id. Equal panes have equal records:
/// loops start at their smallest point, triangles too, and all lists are sorted.
struct PaneRecord {
    using Number = std::uint32_t;

    std::vector<Point2> points;
    std::vector<Number> ids;                                   // of points
    std::vector<std::vector<Number>> boundary;                 // the outer loop, then the holes
    std::vector<std::array<Number, 2>> constraints;            // each piece of each segment once, the smaller number first
    std::vector<std::array<Number, 3>> triangles;              // counter-clockwise
    std::vector<std::pair<Number, std::vector<Number>>> segments; // id, and the points of the chain
    std::vector<Number> locked;
    std::vector<Number> crossings, refined; // points that two segments made, and those of the last refinement
    double snap = 0, weld = 0;
    Number next_point = 0, next_segment = 0;

    friend bool operator==(const PaneRecord&, const PaneRecord&) = default;
};

PaneRecord record(const Pane& pane);

/// A record that is none of a pane, and which of its values is at fault, as a file names it: `boundary[1]`, `points[5]`.
class PaneRecordRefusal : public PaneRefusal {
public:
    PaneRecordRefusal(const PaneRefusal& refusal, std::string path) : PaneRefusal(refusal), path_(std::move(path)) {}
    const std::string& path() const { return path_; }

private:
    std::string path_;
};

/// The pane that a record tells of; `constraints` and `triangles` follow from the rest and are not read. Throws PaneRecordRefusal where the record is
/// none of a pane: a number out of range, loops that are no boundary, a segment that meets more than its points.
Pane restore(const PaneRecord& record);

} // namespace druse
