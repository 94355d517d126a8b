#include "render/gl_api.h"

#include "dlfl/errors.h"

#include <string>

namespace druse {

GlApi GlApi::load(const GlProcLoader& get)
{
    GlApi api;
    std::string missing;
    const auto find = [&](auto& function, const char* name) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(get(name));
        if (!function) missing += (missing.empty() ? "" : ", ") + std::string(name);
    };
#define DRUSE_GL_FIND(type, name) find(api.name, "gl" #name);
    DRUSE_GL_FUNCTIONS(DRUSE_GL_FIND)
#undef DRUSE_GL_FIND
    if (!missing.empty()) throw SystemError("OpenGL 3.3 is needed, but this driver lacks " + missing);
    return api;
}

} // namespace druse
