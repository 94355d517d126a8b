#pragma once

#include "render/camera.h"
#include "render/draw_lists.h"
#include "render/gl_proc.h"
#include "render/image.h"
#include "render/thick_line.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace druse {

/// How a mesh is drawn.
struct Style {
    enum class Shading { flat, smooth };
    enum class EdgeMethod {
        automatic, // in the face shader on software renderers, as lines elsewhere
        lines,     // GL_LINES over faces that are pushed back a little
        surface,   // by the face shader, from the distance of a pixel to the sides of its triangle
    };

    Shading shading = Shading::flat;
    bool edges = true;        // the sides of polygons, never the diagonals of their triangles; open boundaries in amber
    bool wireframe = false;   // edges only, all of them
    bool see_through = false; // faces let through what is behind them
    bool back_faces = false;  // of a closed surface; an open one always shows them
    bool fade_edges = true;   // edges that are shorter than 3 pixels on average fade out, and are gone below 1.5
    EdgeMethod edge_method = EdgeMethod::automatic;

    Colour background_top{0x2e, 0x31, 0x36}, background_bottom{0x1e, 0x20, 0x23};
    bool transparent_background = false;
    Colour edge{0x14, 0x15, 0x1a}, boundary{0xe8, 0xa3, 0x3d}, selected{0x2b, 0x73, 0xff};
    double line_scale = 1; // of all widths in pixels: 2 in a picture twice as large

    friend bool operator==(const Style&, const Style&) = default;
};

/// What is drawn over the picture of the mesh; changing it does not draw the mesh again.
struct Overlay {
    std::vector<Face> hovered; // thin outline in the highlight colour
    std::vector<Face> pressed; // outline of 3 pixels over everything, and a tint
    std::vector<Face> failed;  // outline in the error colour
    std::vector<Face> painted; // drawn as if their group had the colour `paint`
    std::vector<Edge> edges;   // selected edges and vertices
    std::vector<Vertex> vertices;
    std::vector<ThickLine> lines;        // in model space, over everything
    std::vector<ThickLine> screen_lines; // in pixels from the top left corner (z is not used), over everything

    Colour highlight{0x2b, 0x73, 0xff}, error{0xe5, 0x48, 0x4d}, paint{0xcc, 0xcc, 0xcc};

    friend bool operator==(const Overlay&, const Overlay&) = default;
};

/// Draws draw lists in an OpenGL 3.3 core context, whoever made it: a window, or OffscreenContext.
///
/// It draws into framebuffers of its own; the picture is then shown (present) or read (read_image). Its context must be current
/// in every call, the constructor and the destructor included.
class Renderer {
public:
    /// @throws SystemError if the context is older than 3.3 or lacks a function
    explicit Renderer(const GlProcLoader& get);
    ~Renderer();

    /// The name the driver gives itself.
    const std::string& driver() const;
    /// True for drivers that draw with the processor (llvmpipe, softpipe): there a window had better do with 0 samples.
    bool is_software() const;

    /// Draws the mesh as the camera sees it, camera.width() by camera.height() pixels, with `samples` (0, 2 or 4) per pixel.
    /// Where only the overlay is not as it was in the last call, the mesh is not drawn again.
    void draw(const DrawLists& lists, const Camera& camera, const Style& style, const Overlay& overlay, int samples);

    /// Copies the picture into a framebuffer of the same size, 0 for the window's own, and leaves that one bound.
    void present(unsigned framebuffer = 0);
    Image read_image();
    /// Waits until all drawing is done.
    void finish();
    /// The first error OpenGL has noted since the last call, 0 if none: for tests.
    unsigned error();

    /// Says that the context went away with everything in it, so that the destructor leaves it alone.
    void forget_context();

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace druse
