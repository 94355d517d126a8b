#pragma once

#include "render/gl_proc.h"

#include <memory>

namespace druse {

/// An OpenGL 3.3 core context without a window or display, made by OSMesa.
///
/// It is current on the thread that made it, for as long as it lives, and must be destroyed there. **Never two contexts on one
/// thread**: OSMesa and the libGL of a window share one slot for the current context, and drawing would go astray without an
/// error; a second context of this kind on the same thread fails an ASSERT. So a program with a window draws its pictures in the
/// window's own context, and others give this one a thread of its own.
class OffscreenContext {
public:
    /// @throws SystemError if libOSMesa is not installed, or gives no such context
    OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;
    ~OffscreenContext();

    /// For Renderer. Valid as long as the context.
    GlProcLoader loader() const;

private:
    struct Library;
    static const Library& library();

    void* context_ = nullptr;
    std::unique_ptr<unsigned char[]> pixels_; // OSMesa wants a picture of its own, however small
};

} // namespace druse
