#pragma once

#include "render/gl_api.h"
#include "render/image.h"

namespace druse {

/// The framebuffers a picture is made in.
///
/// The mesh is drawn into the *base*; highlights go over a copy of it, the *top*, which shares the base's depth. So a pointer
/// that moves over a large mesh costs a copy of the picture, not of the mesh. Samples are resolved when the picture is taken out.
class FrameTarget {
public:
    explicit FrameTarget(const GlApi& gl) : gl_(gl) {}
    FrameTarget(const FrameTarget&) = delete;
    FrameTarget& operator=(const FrameTarget&) = delete;
    ~FrameTarget() { release(); }

    /// Makes the framebuffers of this size and number of samples (0: one per pixel; no more than the driver has).
    /// @return true if they are new, hence empty
    /// @throws SystemError if the driver cannot make them
    bool resize(int width, int height, int samples);
    int width() const { return width_; }
    int height() const { return height_; }

    void draw_into_base();
    /// Copies the base to the top and draws there from now on.
    void draw_into_top();

    /// Copies what was drawn last to another framebuffer of the same size.
    void present(GLuint framebuffer);
    /// Reads what was drawn last; with `transparent`, the colours are divided by the alpha they were blended with.
    Image read(bool transparent);

private:
    enum Part { colour_of_base, colour_of_top, colour_of_resolve, depth };

    void release();
    void store(Part part, GLenum format, int samples);
    GLuint make_framebuffer(Part colour);
    GLuint resolved();

    const GlApi& gl_;
    int width_ = 0, height_ = 0, samples_ = 0, asked_samples_ = 0;
    GLuint base_ = 0, top_ = 0, resolve_ = 0, drawn_ = 0;
    GLuint renderbuffers_[4] = {}; // by Part; a top and a resolve get storage once they are needed
};

} // namespace druse
