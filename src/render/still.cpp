#include "render/still.h"

#include "render/offscreen_context.h"

#include <exception>
#include <thread>

namespace druse {

namespace {

constexpr double most_samples = 134217728; // in a picture: 2^27, at 8 bytes each

Image draw(const DrawLists& lists, const StillOptions& options)
{
    Camera camera;
    camera.resize(options.width, options.height);
    camera.set_angles(options.view);
    camera.set_parallel(options.parallel);
    camera.fit(lists.positions());

    Style style;
    style.shading = options.shading;
    style.edges = options.edges;
    style.transparent_background = options.transparent;
    if (options.background) style.background_top = style.background_bottom = *options.background;

    Image image;
    std::exception_ptr failure;
    std::thread([&] {
        try {
            const OffscreenContext context;
            Renderer renderer(context.loader());
            // A large picture does with one sample per pixel, or it would take gigabytes.
            const double pixels = double(options.width) * options.height;
            const int samples = pixels * options.samples <= most_samples ? options.samples : 0;
            renderer.draw(lists, camera, style, {}, samples);
            image = renderer.read_image();
        } catch (...) {
            failure = std::current_exception();
        }
    }).join();
    if (failure) std::rethrow_exception(failure);
    return image;
}

GroupColours chosen(const GroupColours& colours, const StillOptions& options)
{
    if (options.groups) return colours;
    return [plain = colours(0)](int) { return plain; };
}

} // namespace

Image draw_still(const Mesh& mesh, const GroupColours& colours, const StillOptions& options)
{
    return draw(DrawLists(mesh, chosen(colours, options)), options);
}

Image draw_still(const Mesh& mesh, const Division& division, const GroupColours& colours, const StillOptions& options)
{
    DrawLists lists;
    lists.build(mesh, chosen(colours, options), division);
    return draw(lists, options);
}

Image draw_still(const Graph& graph, const StillOptions& options)
{
    return draw(DrawLists(graph), options);
}

} // namespace druse
