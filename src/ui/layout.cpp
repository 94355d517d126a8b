#include "ui/layout.h"

namespace druse::ui {

namespace {
Layout current;
}

const Layout& layout() { return current; }
void set_layout(const Layout& l) { current = l; }

} // namespace druse::ui
