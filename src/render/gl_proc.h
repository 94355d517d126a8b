#pragma once

#include <functional>

namespace druse {

/// Finds a GL function of the context that is current, by name; null if there is none. `glXGetProcAddressARB` and
/// `OSMesaGetProcAddress` are of this kind.
using GlProc = void (*)();
using GlProcLoader = std::function<GlProc(const char* name)>;

} // namespace druse
