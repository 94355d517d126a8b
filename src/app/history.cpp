#include "app/history.h"

#include "dlfl/errors.h"

namespace druse {

namespace {

std::size_t bytes(const Selection& s)
{
    return s.faces.size() * sizeof(Face) + s.edges.size() * sizeof(Edge) + s.vertices.size() * sizeof(Vertex);
}

std::size_t bytes(const GroupTable&) { return 0; } // a few entries at most

/// What a step holds beside the present state.
std::size_t own_bytes(const History::Step& step, const Scene& scene)
{
    const auto unless_shared = [](const auto& mine, const auto& its) { return mine.same_as(its) ? 0 : bytes(*mine); };
    return sizeof(step) + step.command.text.size() + step.mesh.bytes() + step.rind.bytes() + step.source.bytes() +
           unless_shared(step.groups, scene.groups) + unless_shared(step.selection, scene.selection);
}

} // namespace

void History::begin(ScriptCommand command)
{
    steps_.clear();
    done_ = first_ = bytes_ = 0;
    beginning_ = std::move(command);
}

void History::add(Step&& step, const Scene& scene)
{
    step.bytes = own_bytes(step, scene);
    const std::size_t added = step.bytes;
    if (done_ == size()) {
        steps_.push_back(std::move(step));
    } else {
        for (std::size_t i = done_; i < size(); ++i) bytes_ -= steps_[i].bytes;
        steps_[done_] = std::move(step);
        while (size() > done_ + 1) steps_.pop_back();
    }
    ++done_;
    bytes_ += added;
    for (; bytes_ > budget_ && first_ + 1 < done_; ++first_) drop_state(first_);
}

void History::drop_state(std::size_t k)
{
    Step& step = steps_[k];
    bytes_ -= step.bytes;
    step.mesh = {};
    step.rind = {};
    step.source = {};
    step.groups = steps_[k + 1].groups;
    step.selection = steps_[k + 1].selection;
    step.bytes = 0;
}

void History::exchange(Scene& scene, Step& step)
{
    scene.mesh.exchange(step.mesh);
    scene.rind.exchange(step.rind);
    scene.source.exchange(step.source);
    std::swap(scene.groups, step.groups);
    std::swap(scene.selection, step.selection);
    step.bytes = own_bytes(step, scene);
}

void History::undo(Scene& scene)
{
    ASSERT(done_ > first_, "a state to go back to");
    Step& step = steps_[done_ - 1];
    bytes_ -= step.bytes;
    exchange(scene, step);
    bytes_ += step.bytes;
    --done_;
}

void History::redo(Scene& scene)
{
    ASSERT(done_ < size(), "a state to go forth to");
    Step& step = steps_[done_];
    bytes_ -= step.bytes;
    exchange(scene, step);
    bytes_ += step.bytes;
    ++done_;
}

void History::go_to(Scene& scene, std::size_t k)
{
    ASSERT(first_ <= k && k <= size(), "a state that is kept");
    while (done_ > k) undo(scene);
    while (done_ < k) redo(scene);
}

History::Step History::take_last(Scene& scene)
{
    ASSERT(done_ == size() && done_ > first_, "a last step");
    undo(scene);
    Step step = std::move(steps_.back());
    bytes_ -= step.bytes;
    steps_.pop_back();
    return step;
}

void History::put_last(Scene& scene, Step&& step)
{
    exchange(scene, step);
    add(std::move(step), scene);
}

void History::rename_last(ScriptCommand command)
{
    ASSERT(done_ == size() && done_ > 0, "a last step");
    Step& step = steps_.back();
    bytes_ -= step.bytes;
    step.bytes = step.bytes - step.command.text.size() + command.text.size();
    bytes_ += step.bytes;
    step.command = std::move(command);
}

std::vector<ScriptCommand> History::script() const
{
    std::vector<ScriptCommand> commands;
    if (!beginning_.text.empty()) commands.push_back(beginning_);
    for (std::size_t i = 0; i < done_; ++i) commands.push_back(steps_[i].command);
    return commands;
}

} // namespace druse
