#pragma once

#include "ui/session.h"
#include "ui/timer.h"

#include <chrono>
#include <filesystem>
#include <vector>

namespace druse::ui {

/// Keeps a copy of unsaved work where the next start finds it, should this one end badly.
///
/// The copy is a model, or of the editors of tiles and cells a tile, and, where there is one, the history as a script, both named after the process; a lock file
/// beside them says whose they are. They go when the window is closed in order.
class Autosave {
public:
    static constexpr double after_change = 20, at_least_every = 120; // seconds

    enum class Kind { model, tile, cell };
    /// `folder` is made if it is not there; if it cannot be, nothing is kept, and the session says so.
    Autosave(Session& session, std::filesystem::path folder, Kind kind = Kind::model);
    ~Autosave();
    Autosave(const Autosave&) = delete;
    Autosave& operator=(const Autosave&) = delete;

    /// The session changed. Once its work is saved elsewhere, the copy goes.
    void follow();
    /// Writes what there is now, and waits for it.
    void save_now();
    /// Keeps the copy when this goes away.
    void keep() { keep_ = true; }
    const std::filesystem::path& own_model() const { return model_; }

    /// Models and tiles that processes which are gone have left.
    std::vector<std::filesystem::path> leftovers() const;
    static void discard(const std::filesystem::path& model);
    /// Moves one, with what lies beside it, to the folder `recovered`, where histories that begin with it go on finding it.
    /// @return where the model is now; where it was, if it cannot be moved
    static std::filesystem::path set_aside(const std::filesystem::path& model);

    /// `$XDG_STATE_HOME/druse`, or `~/.local/state/druse`.
    static std::filesystem::path default_folder();

private:
    void save();
    void take_away();
    bool has_something() const;

    Session& session_;
    Kind kind_;
    std::filesystem::path folder_, model_;
    std::uint64_t saved_version_ = 0;
    std::chrono::steady_clock::time_point saved_at_;
    bool written_ = false; // there may be a copy
    bool keep_ = false;
    Timer timer_;
};

} // namespace druse::ui
