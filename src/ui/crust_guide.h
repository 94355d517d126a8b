#pragma once

#include "ui/control.h"
#include "ui/session.h"
#include "ui/worker.h"

#include "dlfl/mesh.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace druse::ui {

/// Up to which thickness a crust is safe, for marks on the slider, and which faces meet where it is thicker.
///
/// Works while `rind.crust` is the chosen operator, on a worker of its own and from copies, so that nobody waits. The marks are those of the
/// surface that the next crust is made of, or that the one was made of which is bound to the panel.
class CrustGuide {
public:
    static constexpr std::chrono::milliseconds patience{20};

    explicit CrustGuide(Session& session) : session_(session) {}

    std::function<void()> wake;      // on the worker's thread; see finish()
    std::function<void()> on_change; // there are other marks, or faces
    std::function<void(const std::string&)> on_event;

    struct Safe {
        double inward = 0, outward = 0; // infinite where nothing ever meets
        friend bool operator==(const Safe&, const Safe&) = default;
    };
    /// Nothing while it is not known.
    const std::optional<Safe>& safe() const { return safe_; }
    /// Faces that meet others, of the mesh that is shown.
    const std::vector<Face>& meeting() const { return meeting_; }

    /// Gives the control of the thickness a slider for the size of the surface, and its marks. Leaves others alone.
    void fit(Control& control) const;

    bool is_computing() const { return computing_ != Task::none; }
    /// The session changed.
    void follow();
    /// Takes over what the worker has found. Nothing happens if it is not done yet.
    void finish();
    /// Waits until nothing is being computed.
    void wait();

private:
    enum class Task { none, safe, meeting };
    /// What the safe thickness depends on.
    struct Question {
        std::uint64_t shape = 0; // a version of the session's lists
        bool uniform = false;
        double limit = 0;
        friend bool operator==(const Question&, const Question&) = default;
    };
    struct Result {
        bool cancelled = false;
        std::optional<Safe> safe;
        std::optional<std::vector<Face>> meeting;
    };

    bool is_chosen() const;
    bool is_too_thick() const;
    Question question() const;
    void drop();
    void follow_base(const Mesh& mesh);
    void start(Task task, Worker::Job job);
    void find_safe(const Question& question);
    void find_meeting(const Mesh& mesh);
    void take_over();
    void set_reach();
    void changed();

    Session& session_;
    std::shared_ptr<const Mesh> base_;
    std::uint64_t base_shape_ = 0;
    std::size_t base_step_ = 0; // of the history
    double reach_ = 0;          // of the slider
    std::optional<Safe> safe_;
    Question answered_;
    std::vector<Face> meeting_;
    std::uint64_t looked_ = 0; // the shape that meeting_ are of

    Task computing_ = Task::none;
    Question asked_;
    std::uint64_t looking_ = 0;
    Result result_;
    Worker worker_; // last: it is done before anything it works on goes
};

} // namespace druse::ui
