#pragma once

#include "ui/session.h"

#include <optional>
#include <string>

namespace druse::ui {

/// One step of the history that is made again and again while something is dragged: the first command that is not refused makes it, each later
/// one takes its place. While one runs only the newest is kept; where one is refused, the last one that was not stands.
class LiveStep {
public:
    explicit LiveStep(Session& session) : session_(session) {}

    void send(std::string command)
    {
        wanted_ = std::move(command);
        go_on();
    }
    /// The session changed: what was waiting may go.
    void go_on()
    {
        if (!wanted_ || session_.busy()) return; // with an earlier one of its own, or with what another began
        if (!start_) start_ = session_.display().done;
        const std::string command = std::move(*wanted_);
        wanted_.reset();
        is_made() ? session_.run_again(command) : session_.run(command);
    }
    /// Takes it back.
    void cancel()
    {
        wanted_.reset();
        session_.wait();
        if (is_made()) session_.undo();
    }
    bool is_made() const { return start_ && session_.display().done > *start_; }
    bool is_waiting() const { return wanted_.has_value(); }

private:
    Session& session_;
    std::optional<std::size_t> start_; // steps that were done before it; nothing before the first command
    std::optional<std::string> wanted_;
};

} // namespace druse::ui
