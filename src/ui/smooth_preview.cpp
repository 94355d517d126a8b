#include "ui/smooth_preview.h"

#include "ops/smooth_surface.h"

#include <fmt/format.h>

#include <new>
#include <utility>

namespace druse::ui {

namespace {

GroupColours colours_of(const GroupTable& groups)
{
    return [&groups](int group) { return groups.colour(group); };
}

} // namespace

void SmoothPreview::event(const std::string& line) const
{
    if (on_event) on_event(line);
}

void SmoothPreview::changed()
{
    if (on_change) on_change();
}

void SmoothPreview::set_on(bool on)
{
    if (on == on_) return;
    on_ = on;
    event(on ? "smooth on" : "smooth off");
    if (on) {
        follow();
    } else {
        if (is_computing()) worker_.cancel();
        surface_.reset();
        drop({});
        shown_ = 0;
    }
    changed();
}

void SmoothPreview::drop(std::string reason)
{
    lists_.reset();
    first_part_.clear();
    reason_ = std::move(reason);
}

void SmoothPreview::follow()
{
    if (!on_) return;
    const Display& display = session_.display();
    if (is_current()) {
        take_look();
        return;
    }
    // What is left of another document, or of what is no longer there, would be misleading.
    if (display.beginning != beginning_ || display.counts.faces == 0) drop({});
    if (is_computing()) {
        if (computing_ != display.lists.shape_version()) worker_.cancel(); // finish() begins anew
        return;
    }
    if (display.counts.faces == 0) {
        shown_ = display.lists.shape_version();
        return;
    }
    compute();
}

void SmoothPreview::compute()
{
    const Mesh* mesh = session_.mesh();
    if (!mesh) return; // a command is at work; when it is done, this follows
    const Display& display = session_.display();
    computing_ = display.lists.shape_version();
    computed_beginning_ = display.beginning;
    if (!surface_) surface_ = std::make_shared<SmoothSurface>();
    worker_.start([this, surface = surface_, mesh = std::make_shared<const Mesh>(*mesh), groups = display.groups](Progress& progress) {
        try {
            result_ = smooth(*surface, *mesh, *groups, progress);
        } catch (const Cancelled&) {
            result_ = {};
        } catch (const std::bad_alloc&) {
            result_ = {.lists = {}, .first_part = {}, .failure = "not enough memory"};
        } catch (const std::exception& e) {
            result_ = {.lists = {}, .first_part = {}, .failure = e.what()};
        }
    });
    if (worker_.wait(patience)) take_over();
    else if (wake) worker_.when_done(wake);
}

/// Runs on the worker.
SmoothPreview::Result SmoothPreview::smooth(SmoothSurface& surface, const Mesh& mesh, const GroupTable& groups, Progress& progress)
{
    surface.follow(mesh, progress);
    Result result;
    result.first_part.assign(std::size_t(mesh.face_limit()) + 1, 0);
    for (const std::uint32_t f : surface.old_face()) ++result.first_part[f + 1];
    for (std::size_t f = 0; f < mesh.face_limit(); ++f) result.first_part[f + 1] += result.first_part[f];
    progress.step(1.0);
    result.lists.emplace();
    result.lists->build(surface.mesh(), colours_of(groups), Division(mesh, surface.old_face(), surface.normals()));
    return result;
}

void SmoothPreview::finish()
{
    if (is_computing() && !worker_.busy()) take_over();
}

void SmoothPreview::wait()
{
    while (is_computing()) {
        worker_.wait();
        take_over();
    }
}

void SmoothPreview::take_over()
{
    Result result = std::exchange(result_, {});
    const std::uint64_t shape = std::exchange(computing_, 0);
    if (on_ && result.lists) {
        lists_ = std::move(result.lists);
        first_part_ = std::move(result.first_part);
        reason_.clear();
        beginning_ = computed_beginning_;
        shown_ = shape;
        looks_ = 0;
        event(fmt::format("smooth faces={}", lists_->face_limit()));
    } else if (on_ && !result.failure.empty() && shape == session_.display().lists.shape_version()) {
        const bool is_news = result.failure != reason_;
        drop(std::move(result.failure));
        shown_ = shape;
        if (is_news) {
            event("smooth not possible: " + reason_);
            session_.say(Message::Kind::note, "no smooth preview: " + reason_);
        }
    }
    follow();
    changed();
}

/// Brings colours and selection of the surface up to those of the mesh.
void SmoothPreview::take_look()
{
    const Display& display = session_.display();
    if (!lists_ || looks_ == display.lists.version()) return;
    looks_ = display.lists.version();
    // A part is looked up by its place among those of its face.
    std::uint32_t f = 0;
    const auto group_of = [&](Face part) {
        if (part.index < first_part_[f]) f = 0;
        while (first_part_[f + 1] <= part.index) ++f;
        return display.lists.group(Face(f));
    };
    lists_->recolour(group_of, colours_of(*display.groups));
    lists_->select(parts(display.lists.selected()));
}

std::vector<Face> SmoothPreview::parts(std::span<const Face> faces) const
{
    std::vector<Face> result;
    if (!lists_ || !is_current()) return result;
    for (const Face f : faces)
        if (f.index + 1 < first_part_.size())
            for (std::uint32_t i = first_part_[f.index]; i < first_part_[f.index + 1]; ++i) result.push_back(Face(i));
    return result;
}

} // namespace druse::ui
