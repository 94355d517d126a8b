#pragma once

#include "ui/timer.h"

#include "dlfl/mesh.h"
#include "ops/operator.h"
#include "render/image.h"

#include <FL/Fl_Image.H>

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace druse::ui {

/// Small pictures of solids, each drawn once.
///
/// A widget asks for them while it draws itself; those that are not there yet are drawn a little later, a few at a time, and then
/// on_ready says so.
class Pictures {
public:
    /// Draws a solid into a square; nothing if that is not possible yet. @throws SystemError if it never will be
    using Painter = std::function<std::optional<Image>(const Mesh&, int size)>;

    explicit Pictures(Painter painter) : painter_(std::move(painter)), timer_([this] { draw_some(); }) {}

    /// What an operator makes, `size` pixels wide; null if it has no picture, or none yet. `solid`: the one its parameter names.
    Fl_RGB_Image* find(const Operator& op, const std::string& solid, int size);
    /// One of the built-in solids.
    Fl_RGB_Image* find(const std::string& solid, int size);

    /// More pictures are there than before.
    std::function<void()> on_ready;

private:
    using Key = std::pair<std::string, int>;
    struct Picture {
        Image pixels; // what FLTK shows is read from here
        std::unique_ptr<Fl_RGB_Image> image;
    };
    struct Wanted {
        Key key;
        std::function<std::optional<Mesh>()> solid;
    };

    Fl_RGB_Image* find(Key key, std::function<std::optional<Mesh>()> solid);
    void draw_some();

    Painter painter_;
    std::map<Key, Picture> pictures_;
    std::deque<Wanted> wanted_;
    bool hopeless_ = false;
    Timer timer_;
};

/// The picture at a `factor`-th of its size, each pixel the mean of those it stands for.
Image shrunk(const Image& image, int factor);

} // namespace druse::ui
