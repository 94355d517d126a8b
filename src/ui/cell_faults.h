#pragma once

#include "cell/cell_tile.h"
#include "ui/worker.h"

#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace druse::ui {

/// Looks whether a cell meets itself and its neighbours, on a worker of its own and from a copy, so that nobody waits.
class CellFaults {
public:
    static constexpr std::chrono::milliseconds patience{20};

    std::function<void()> wake;      // on the worker's thread; see finish()
    std::function<void()> on_change; // something else is known

    struct Found {
        double volume = 0;
        std::uint64_t pairs = 0; // of triangles that meet
        std::string trouble;     // `meets pane 2 of the neighbour at 4,0,0`; empty where it fits
        std::string where = {};  // the same shorter: `pane 2 at 4,0,0`; empty where no neighbour is met
    };
    /// Of the cell that was asked about last; nothing while it is not known.
    const std::optional<Found>& found() const { return found_; }
    /// Why it cannot be known; empty while it may be yet.
    const std::string& failure() const { return failure_; }

    /// Asks about a cell, in place of what was asked before; null: about none.
    void follow(const CellTile* cell);
    /// Takes over what the worker has found. Nothing happens if it is not done yet.
    void finish();
    /// Waits until nothing is being computed.
    void wait();

private:
    struct Result {
        std::optional<Found> found;
        std::string failure = {};
    };
    void start();
    void take_over();

    std::optional<CellTile> asked_; // what waits for the worker
    std::optional<Found> found_;
    std::string failure_;
    bool is_computing_ = false, is_wanted_ = false;
    Result result_;
    Worker worker_; // last: it is done before anything it works on goes
};

} // namespace druse::ui
