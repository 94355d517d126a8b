#pragma once

#include "ui/session.h"
#include "ui/worker.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace druse {
class SmoothSurface;
}

namespace druse::ui {

/// Shows the mesh of a session smooth, without changing it: its SmoothSurface, made on a worker from a copy.
///
/// It follows every edit. What takes longer than `patience` is shown when it is there; until then the surface of an earlier state
/// stays. Where only colours, groups or the selection change, the surface takes them over at once.
class SmoothPreview {
public:
    static constexpr std::chrono::milliseconds patience{30};

    explicit SmoothPreview(Session& session) : session_(session) {}

    std::function<void()> wake;      // on the worker's thread; see finish()
    std::function<void()> on_change; // what is shown, or is being done, is not as it was
    std::function<void(const std::string&)> on_event;

    bool is_on() const { return on_; }
    void set_on(bool on);

    /// What is drawn in place of the mesh; null: the mesh itself.
    const DrawLists* lists() const { return lists_ ? &*lists_ : nullptr; }
    /// The faces of lists() that are parts of these faces of the mesh. Empty while lists() is of an earlier state.
    std::vector<Face> parts(std::span<const Face> faces) const;
    /// Why there is nothing to show though it is on, in one line; empty if there is something.
    const std::string& reason() const { return reason_; }

    bool is_computing() const { return computing_ != 0; }
    double fraction() const { return worker_.fraction(); }

    /// The session changed.
    void follow();
    /// Takes over what the worker has made. Nothing happens if it is not done yet.
    void finish();
    /// Waits until nothing is being computed.
    void wait();

private:
    struct Result {
        std::optional<DrawLists> lists;
        std::vector<std::uint32_t> first_part; // by face of the mesh, and one more
        std::string failure;
    };

    void compute();
    static Result smooth(SmoothSurface& surface, const Mesh& mesh, const GroupTable& groups, Progress& progress);
    void take_over();
    void take_look();
    void drop(std::string reason);
    void changed();
    void event(const std::string& line) const;
    bool is_current() const { return shown_ == session_.display().lists.shape_version(); }

    Session& session_;
    bool on_ = false;
    std::optional<DrawLists> lists_;
    std::vector<std::uint32_t> first_part_;
    std::string reason_;
    std::string beginning_; // of the document that lists_ are of

    // Shapes are told apart by the version of the session's lists in which they came.
    std::uint64_t shown_ = 0;     // the one that lists_, or reason_, are of
    std::uint64_t computing_ = 0; // 0: none
    std::uint64_t looks_ = 0;     // the version of the session's lists whose colours and selection lists_ have
    std::string computed_beginning_;

    Result result_;
    std::shared_ptr<SmoothSurface> surface_; // the worker's while it is busy
    Worker worker_; // last: it is done before anything it works on goes
};

} // namespace druse::ui
