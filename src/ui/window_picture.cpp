#include "ui/window_picture.h"

#include <FL/Fl.H>
#include <FL/Fl_Window.H>
#include <FL/fl_draw.H>

#include <memory>

namespace druse::ui {

Image picture_of(Fl_Window& window)
{
    Fl::flush();
    window.make_current();
    const std::unique_ptr<uchar[]> bytes(fl_read_image(nullptr, 0, 0, window.w(), window.h()));
    Image image(window.w(), window.h());
    if (!bytes) return image;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = {bytes[3 * i], bytes[3 * i + 1], bytes[3 * i + 2], 255};
    return image;
}

} // namespace druse::ui
