#pragma once

#include "render/camera.h"
#include "render/image.h"
#include "render/offscreen_context.h"
#include "render/renderer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <thread>

/// Taking pictures in tests, and asking what is in them.
namespace druse::test {

/// An off-screen context with a renderer in it.
struct Studio {
    OffscreenContext context;
    Renderer renderer{context.loader()};

    Image picture(const DrawLists& lists, const Camera& camera, const Style& style = {}, const Overlay& overlay = {},
                  int samples = 0)
    {
        renderer.draw(lists, camera, style, overlay, samples);
        return renderer.read_image();
    }
};

/// The same from a context of its own, hence on a thread of its own.
inline Image fresh_picture(const DrawLists& lists, const Camera& camera, const Style& style = {}, const Overlay& overlay = {},
                           int samples = 0)
{
    Image image;
    std::thread([&] { image = Studio().picture(lists, camera, style, overlay, samples); }).join();
    return image;
}

inline Camera camera_at(const DrawLists& lists, std::string_view view, int width = 320, int height = 240)
{
    Camera camera;
    camera.resize(width, height);
    camera.set_angles(*view_from_text(view));
    camera.fit(lists.bounds());
    return camera;
}

/// The pixel in which a point is seen.
inline Pixel pixel_at(const Image& image, const Camera& camera, const Point& p)
{
    const Point2 at = *camera.project(p);
    return image.at(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)));
}

/// Whether a pixel is `colour` in some light: the same hue, neither black nor brighter than the colour.
inline bool is_shade_of(Pixel p, Colour colour)
{
    const double light = (p.red + p.green + p.blue) / double(colour.red + colour.green + colour.blue);
    const auto fits = [&](int seen, int own) { return std::abs(seen - light * own) <= 2.5; };
    return light > 0.2 && light < 1.02 && fits(p.red, colour.red) && fits(p.green, colour.green) && fits(p.blue, colour.blue);
}

/// How many pixels differ by more than `steps` of 255 in some channel.
inline int pixels_apart(const Image& a, const Image& b, int steps)
{
    int n = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Pixel p = a.pixels[i], q = b.pixels[i];
        n += std::max({std::abs(p.red - q.red), std::abs(p.green - q.green), std::abs(p.blue - q.blue),
                       std::abs(p.alpha - q.alpha)}) > steps;
    }
    return n;
}

inline bool is_near(Pixel p, Colour c, int tolerance)
{
    return std::abs(p.red - c.red) <= tolerance && std::abs(p.green - c.green) <= tolerance &&
           std::abs(p.blue - c.blue) <= tolerance;
}

} // namespace druse::test
