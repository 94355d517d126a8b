#include "ui/gl_context.h"

#include <FL/Fl.H>
#include <FL/Fl_Gl_Window.H>
#include <FL/x.H>

#include <GL/glx.h>

#include <memory>

namespace druse::ui {

namespace {

/// A context that is refused is an X error as well as a null pointer.
int keep_quiet(::Display*, XErrorEvent*) { return 0; }

GLXContext core_context(::Display* display, int screen, VisualID visual)
{
    const auto create = reinterpret_cast<PFNGLXCREATECONTEXTATTRIBSARBPROC>(
        glXGetProcAddressARB(reinterpret_cast<const GLubyte*>("glXCreateContextAttribsARB")));
    if (!create) return nullptr;

    int count = 0;
    const auto free = [](GLXFBConfig* list) { XFree(list); };
    const std::unique_ptr<GLXFBConfig, decltype(free)> configs(glXGetFBConfigs(display, screen, &count), free);
    const auto previous = XSetErrorHandler(keep_quiet);
    GLXContext made = nullptr;
    for (int i = 0; configs && i < count && !made; ++i) {
        const GLXFBConfig config = configs.get()[i];
        int id = 0;
        glXGetFBConfigAttrib(display, config, GLX_VISUAL_ID, &id);
        if (static_cast<VisualID>(id) != visual) continue;
        const int attributes[] = {GLX_CONTEXT_MAJOR_VERSION_ARB, 3,
                                  GLX_CONTEXT_MINOR_VERSION_ARB, 3,
                                  GLX_CONTEXT_PROFILE_MASK_ARB,  GLX_CONTEXT_CORE_PROFILE_BIT_ARB,
                                  0};
        made = create(display, config, nullptr, True, attributes);
        XSync(display, False);
    }
    XSetErrorHandler(previous);
    return made;
}

} // namespace

bool make_core_context(Fl_Gl_Window& window)
{
    XWindowAttributes attributes;
    XGetWindowAttributes(fl_display, fl_xid(&window), &attributes);
    const GLXContext made = core_context(fl_display, fl_screen, XVisualIDFromVisual(attributes.visual));
    if (!made) return false;
    window.context(made, 1);
    // FLTK leaves both as they were, and would go on with what it knew of another context.
    window.valid(0);
    window.context_valid(0);
    return true;
}

GlProcLoader window_gl_loader()
{
    return [](const char* name) { return reinterpret_cast<GlProc>(glXGetProcAddressARB(reinterpret_cast<const GLubyte*>(name))); };
}

} // namespace druse::ui
