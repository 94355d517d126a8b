#include "ui/cell_faults.h"

#include "cell/cell_check.h"

#include <fmt/format.h>

#include <exception>
#include <utility>

namespace druse::ui {

namespace {

CellFaults::Found find_faults(const CellTile& cell, Progress& progress)
{
    const CellCheck check = druse::check(cell, {.clearance = 0, .joint = CellJoint::inset, .directions = false}, progress);
    CellFaults::Found found{check.volume, check.self_intersections, {}, {}};
    if (!check.pierced.empty()) {
        const CellCheck::Pierced& first = check.pierced.front();
        const Vector by = cell.world(cell.cell().at(first.neighbour));
        const std::string place = fmt::format("{:.4g},{:.4g},{:.4g}", by.x, by.y, by.z);
        found.trouble = fmt::format("meets pane {} of the neighbour at {}", first.side.pane, place);
        found.where = fmt::format("pane {} at {}", first.side.pane, place);
    } else if (!check.sound()) {
        found.trouble = check.faults.front();
    }
    return found;
}

} // namespace

void CellFaults::follow(const CellTile* cell)
{
    asked_ = cell ? std::optional(*cell) : std::nullopt;
    const bool knew = std::exchange(found_, std::nullopt).has_value() | !std::exchange(failure_, {}).empty();
    if (is_computing_) {
        is_wanted_ = false;
        worker_.cancel(); // finish() goes on from here
    } else if (asked_) {
        start();
    }
    if (knew && !found_ && on_change) on_change();
}

void CellFaults::start()
{
    is_computing_ = is_wanted_ = true;
    result_ = {};
    worker_.start([this, cell = *std::exchange(asked_, std::nullopt)](Progress& progress) {
        try {
            result_.found = find_faults(cell, progress);
        } catch (const std::exception& e) { // cancelled, and then nobody asks any more; or it cannot be told
            result_.failure = e.what();
        }
    });
    if (worker_.wait(patience)) take_over();
    else if (wake) worker_.when_done(wake);
}

void CellFaults::take_over()
{
    is_computing_ = false;
    if (is_wanted_) {
        found_ = std::move(result_.found);
        failure_ = std::move(result_.failure);
    }
    if (asked_) start();
    else if (on_change) on_change();
}

void CellFaults::finish()
{
    if (is_computing_ && !worker_.busy()) take_over();
}

void CellFaults::wait()
{
    while (is_computing_) {
        worker_.wait();
        take_over();
    }
}

} // namespace druse::ui
