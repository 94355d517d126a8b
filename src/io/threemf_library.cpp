#include "io/threemf_library.h"

namespace druse {

void require_3mf(ThreeMfObject object, HRESULT result)
{
    if (result == 0) return;
    DWORD code = 0;
    LPCSTR text = nullptr;
    std::string what;
    if (object && NMR::lib3mf_getlasterror(object, &code, &text) == 0 && text)
        for (const char* c = text; *c && what.size() < 100; ++c) what += *c >= ' ' && *c < '\x7f' ? *c : '?';
    throw ThreeMfError{what.empty() ? "unknown failure" : what};
}

} // namespace druse
