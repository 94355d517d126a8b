#include "render/offscreen_context.h"

#include "dlfl/errors.h"

#include <dlfcn.h>

namespace druse {

namespace {

// From GL/osmesa.h, which includes GL/gl.h and so cannot stand beside glcorearb.h.
constexpr int osmesa_rgba = 0x1908, osmesa_format = 0x22, osmesa_depth_bits = 0x30, osmesa_profile = 0x33,
              osmesa_core_profile = 0x34, osmesa_major = 0x36, osmesa_minor = 0x37;
constexpr unsigned gl_unsigned_byte = 0x1401;
constexpr int size = 16;

thread_local bool has_context = false;

} // namespace

/// The functions of OSMesa. It is opened when first asked for, with its symbols kept apart from those of libGL, and stays open:
/// Mesa's threads do not survive its unloading.
struct OffscreenContext::Library {
    void* (*create)(const int* attributes, void* share) = nullptr;
    unsigned char (*make_current)(void* context, void* buffer, unsigned type, int width, int height) = nullptr;
    void (*destroy)(void* context) = nullptr;
    GlProc (*get)(const char* name) = nullptr;

    Library()
    {
        void* handle = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
        if (!handle) throw SystemError("drawing without a display needs libOSMesa.so.8: install the package libosmesa6");
        const auto find = [&](auto& function, const char* name) {
            function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(handle, name));
            if (!function)
                throw SystemError(std::string("libOSMesa.so.8 lacks ") + name + ": install a newer package libosmesa6");
        };
        find(create, "OSMesaCreateContextAttribs");
        find(make_current, "OSMesaMakeCurrent");
        find(destroy, "OSMesaDestroyContext");
        find(get, "OSMesaGetProcAddress");
    }
};

const OffscreenContext::Library& OffscreenContext::library()
{
    static const Library library;
    return library;
}

OffscreenContext::OffscreenContext() : pixels_(std::make_unique<unsigned char[]>(4 * size * size))
{
    ASSERT(!has_context, "a thread has one off-screen context at most");
    const int attributes[] = {osmesa_format,
                              osmesa_rgba,
                              osmesa_depth_bits,
                              24,
                              osmesa_profile,
                              osmesa_core_profile,
                              osmesa_major,
                              3,
                              osmesa_minor,
                              3,
                              0};
    context_ = library().create(attributes, nullptr);
    if (!context_) throw SystemError("OSMesa gives no OpenGL 3.3 core context: install a newer package libosmesa6");
    if (!library().make_current(context_, pixels_.get(), gl_unsigned_byte, size, size)) {
        library().destroy(context_);
        throw SystemError("OSMesa does not make its context current");
    }
    has_context = true;
}

OffscreenContext::~OffscreenContext()
{
    library().make_current(nullptr, nullptr, gl_unsigned_byte, 0, 0);
    library().destroy(context_);
    has_context = false;
}

GlProcLoader OffscreenContext::loader() const
{
    return library().get;
}

} // namespace druse
