#include "ui/action.h"

namespace druse::ui {

std::string label_of(const Action& action) { return action.path.substr(action.path.rfind('/') + 1); }

} // namespace druse::ui
