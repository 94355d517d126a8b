#include "ui/crust_guide.h"

#include "dlfl/measures.h"
#include "dlfl/self_intersections.h"
#include "ops/rind.h"
#include "ops/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace druse::ui {

namespace {

constexpr const char* crust = "rind.crust";
constexpr const char* thickness = "thickness";

double number(const std::string& text)
{
    try {
        return parse_number(text);
    } catch (const CommandError&) {
        return 0; // a word, which is never too thick
    }
}

} // namespace

bool CrustGuide::is_chosen() const { return session_.chosen() && session_.chosen()->name == crust; }

CrustGuide::Question CrustGuide::question() const
{
    const Arguments& arguments = session_.arguments();
    return {base_shape_, arguments.is_on("uniform"), number(arguments.text("limit"))};
}

bool CrustGuide::is_too_thick() const
{
    if (session_.arguments().text("by") != "thickness") return true; // where only what is built can tell
    const double wanted = number(session_.arguments().text(thickness));
    return safe_ && std::abs(wanted) > (wanted < 0 ? safe_->outward : safe_->inward);
}

void CrustGuide::changed()
{
    if (on_change) on_change();
}

void CrustGuide::drop()
{
    if (is_computing()) worker_.cancel();
    if (base_shape_ == 0) return;
    base_.reset();
    base_shape_ = looked_ = 0;
    reach_ = 0;
    answered_ = {};
    safe_.reset();
    meeting_.clear();
    changed();
}

/// Keeps what the next crust will be made of; or, while a step is bound to the panel, what that one was.
void CrustGuide::follow_base(const Mesh& mesh)
{
    const Display& display = session_.display();
    if (session_.is_bound()) {
        if (display.done != base_step_ + 1) { // made of the crust before it
            base_.reset();
            safe_.reset();
        }
        return;
    }
    if (base_ && base_shape_ == display.lists.shape_version()) return;
    base_ = std::make_shared<const Mesh>(mesh);
    base_shape_ = display.lists.shape_version();
    base_step_ = display.done;
    safe_.reset();
    reach_ = glm::length(display.lists.bounds().size()) / 2;
}

void CrustGuide::follow()
{
    if (!is_chosen()) {
        drop();
        return;
    }
    const Mesh* mesh = session_.mesh();
    if (!mesh) return; // a command is at work; when it is done, this follows
    const std::uint64_t shape = session_.display().lists.shape_version();
    if (looked_ != shape) meeting_.clear(); // they may be others now
    follow_base(*mesh);
    if (is_computing()) {
        const bool wanted = computing_ == Task::safe ? asked_ == question() : looking_ == shape && session_.is_bound();
        if (!wanted) worker_.cancel(); // finish() goes on from here
        return;
    }
    if (!base_ || mesh->face_count() == 0) return;
    if (answered_ != question()) {
        find_safe(question());
    } else if (session_.is_bound() && looked_ != shape) {
        if (is_too_thick()) find_meeting(*mesh);
        else looked_ = shape;
    }
}

void CrustGuide::start(Task task, Worker::Job job)
{
    computing_ = task;
    worker_.start([this, job = std::move(job)](Progress& progress) {
        try {
            job(progress);
        } catch (const Cancelled&) {
            result_ = {.cancelled = true, .safe = {}, .meeting = {}};
        } catch (const std::exception&) {
            result_ = {}; // too large: there are no marks then
        }
    });
    if (worker_.wait(patience)) take_over();
    else if (wake) worker_.when_done(wake);
}

void CrustGuide::find_safe(const Question& question)
{
    asked_ = question;
    start(Task::safe, [this, question, mesh = base_](Progress& progress) {
        const CrustOffsets offsets = crust_offsets(*mesh, question.uniform, question.limit);
        progress.step(0.1);
        const double inward = safe_thickness(*mesh, offsets, false, progress);
        result_.safe = Safe{inward, safe_thickness(*mesh, offsets, true, progress)};
    });
}

void CrustGuide::find_meeting(const Mesh& mesh)
{
    looking_ = session_.display().lists.shape_version();
    start(Task::meeting, [this, copy = std::make_shared<const Mesh>(mesh)](Progress& progress) {
        result_.meeting = self_intersections(*copy, progress, CrustFaults::most).faces;
    });
}

void CrustGuide::take_over()
{
    Result result = std::exchange(result_, {});
    switch (std::exchange(computing_, Task::none)) {
    case Task::safe:
        if (result.cancelled || !base_ || !is_chosen() || asked_ != question()) break;
        answered_ = asked_;
        safe_ = result.safe;
        set_reach();
        if (safe_ && on_event) on_event(fmt::format("safe thickness {:.6g} outward {:.6g}", safe_->inward, safe_->outward));
        break;
    case Task::meeting:
        if (result.cancelled || looking_ != session_.display().lists.shape_version()) break;
        looked_ = looking_;
        if (result.meeting) meeting_ = std::move(*result.meeting);
        if (on_event) on_event(fmt::format("faces that meet: {}", meeting_.size()));
        break;
    case Task::none: break;
    }
    follow();
    changed();
}

void CrustGuide::finish()
{
    if (is_computing() && !worker_.busy()) take_over();
}

void CrustGuide::wait()
{
    while (is_computing()) {
        worker_.wait();
        take_over();
    }
}

/// So that the marks lie well inside the slider; it does not reach beyond the surface.
void CrustGuide::set_reach()
{
    const double size = bounds(*base_).empty() ? 0 : glm::length(bounds(*base_).size());
    double farthest = 0;
    for (const double end : {safe_ ? safe_->inward : 0, safe_ ? safe_->outward : 0})
        if (std::isfinite(end)) farthest = std::max(farthest, end);
    reach_ = farthest > 0 ? std::clamp(1.5 * farthest, size / 200, size / 2) : size / 2;
}

void CrustGuide::fit(Control& control) const
{
    if (!is_chosen() || control.parameter != thickness || !(reach_ > 0)) return;
    slide_around_zero(control, reach_);
    if (!safe_ || !base_) return;
    const auto mark = [&control](double end, const char* text) {
        if (!std::isfinite(end) || end == 0) return;
        control.marks.push_back(end);
        control.help += fmt::format("\n{} up to {:.6g}", text, end);
    };
    mark(safe_->inward, "inward it is safe");
    mark(-safe_->outward, "outward it is safe");
}

} // namespace druse::ui
