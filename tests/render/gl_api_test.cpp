#include "render/gl_api.h"

#include "dlfl/errors.h"
#include "render/offscreen_context.h"
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <cstring>

namespace druse {
namespace {

TEST(GlApi, NamesTheFunctionsThatAreMissing)
{
    const OffscreenContext context;
    const GlProcLoader whole = context.loader();
    const GlProcLoader lacking = [&](const char* name) -> GlProc {
        return std::strcmp(name, "glDrawElements") == 0 || std::strcmp(name, "glViewport") == 0 ? nullptr : whole(name);
    };
    try {
        GlApi::load(lacking);
        FAIL() << "two functions are missing";
    } catch (const SystemError& e) {
        EXPECT_STREQ(e.what(), "OpenGL 3.3 is needed, but this driver lacks glDrawElements, glViewport");
    }
    EXPECT_THROW(Renderer{lacking}, SystemError);
}

TEST(OffscreenContext, IsTheOnlyOneOfItsThread)
{
    {
        const OffscreenContext first;
        EXPECT_THROW(OffscreenContext(), InternalError);
    }
    EXPECT_NO_THROW(OffscreenContext());
}

TEST(GlApi, FindsEverythingInAnOffscreenContext)
{
    const OffscreenContext context;
    const GlApi gl = GlApi::load(context.loader());
    GLint major = 0, minor = 0;
    gl.GetIntegerv(GL_MAJOR_VERSION, &major);
    gl.GetIntegerv(GL_MINOR_VERSION, &minor);
    EXPECT_GE(major * 10 + minor, 33);
}

} // namespace
} // namespace druse
