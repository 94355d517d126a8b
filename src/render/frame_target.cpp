#include "render/frame_target.h"

#include "dlfl/errors.h"

#include <algorithm>

namespace druse {

bool FrameTarget::resize(int width, int height, int samples)
{
    if (base_ != 0 && width == width_ && height == height_ && samples == asked_samples_) return false;
    release();
    width_ = width;
    height_ = height;
    asked_samples_ = samples;
    GLint most = 0;
    gl_.GetIntegerv(GL_MAX_SAMPLES, &most);
    samples_ = std::min(samples, static_cast<int>(most));

    gl_.GenRenderbuffers(4, renderbuffers_);
    store(colour_of_base, GL_RGBA8, samples_);
    store(depth, GL_DEPTH_COMPONENT24, samples_);
    base_ = make_framebuffer(colour_of_base);
    if (samples_ > 0) {
        store(colour_of_resolve, GL_RGBA8, 0);
        gl_.GenFramebuffers(1, &resolve_);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, resolve_);
        gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffers_[colour_of_resolve]);
    }
    drawn_ = base_;
    return true;
}

void FrameTarget::store(Part part, GLenum format, int samples)
{
    gl_.BindRenderbuffer(GL_RENDERBUFFER, renderbuffers_[part]);
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width_, height_);
}

GLuint FrameTarget::make_framebuffer(Part colour)
{
    GLuint framebuffer = 0;
    gl_.GenFramebuffers(1, &framebuffer);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffers_[colour]);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, renderbuffers_[depth]);
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw SystemError("the graphics driver cannot make a picture of " + std::to_string(width_) + "x" +
                          std::to_string(height_) + " with " + std::to_string(samples_) + " samples");
    return framebuffer;
}

void FrameTarget::release()
{
    if (renderbuffers_[0] == 0) return;
    for (GLuint* framebuffer : {&base_, &top_, &resolve_}) {
        gl_.DeleteFramebuffers(1, framebuffer);
        *framebuffer = 0;
    }
    gl_.DeleteRenderbuffers(4, renderbuffers_);
    renderbuffers_[0] = 0;
}

void FrameTarget::draw_into_base()
{
    gl_.BindFramebuffer(GL_FRAMEBUFFER, base_);
    gl_.Viewport(0, 0, width_, height_);
    drawn_ = base_;
}

void FrameTarget::draw_into_top()
{
    if (top_ == 0) {
        store(colour_of_top, GL_RGBA8, samples_);
        top_ = make_framebuffer(colour_of_top);
    }
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, base_);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, top_);
    gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, top_);
    gl_.Viewport(0, 0, width_, height_);
    drawn_ = top_;
}

/// The framebuffer to take the picture from, with one sample per pixel.
GLuint FrameTarget::resolved()
{
    if (samples_ == 0) return drawn_;
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolve_);
    gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    return resolve_;
}

void FrameTarget::present(GLuint framebuffer)
{
    const GLuint from = resolved();
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, from);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

Image FrameTarget::read(bool transparent)
{
    const GLuint from = resolved();
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, from);
    gl_.ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
    Image image(width_, height_);
    gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());

    // OpenGL counts rows from below.
    const std::size_t row = static_cast<std::size_t>(width_);
    for (std::size_t y = 0; y < static_cast<std::size_t>(height_) / 2; ++y)
        std::swap_ranges(image.pixels.begin() + static_cast<std::ptrdiff_t>(y * row),
                         image.pixels.begin() + static_cast<std::ptrdiff_t>((y + 1) * row),
                         image.pixels.begin() + static_cast<std::ptrdiff_t>((static_cast<std::size_t>(height_) - 1 - y) * row));
    for (Pixel& p : image.pixels) {
        if (!transparent) p.alpha = 255;
        if (p.alpha == 0) p = {0, 0, 0, 0};
        if (p.alpha == 255 || p.alpha == 0) continue;
        const auto divide = [&](std::uint8_t c) {
            return static_cast<std::uint8_t>(std::min(255, (c * 255 + p.alpha / 2) / p.alpha));
        };
        p = {divide(p.red), divide(p.green), divide(p.blue), p.alpha};
    }
    return image;
}

} // namespace druse
