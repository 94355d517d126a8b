#pragma once

#include "ops/operator.h"

#include <string>

namespace druse::ui {

/// The reference page of an operator, as a small window shows it.
std::string operator_page(const Operator& op);
void show_operator_help(const Operator& op);

/// A window with some text, until it is closed.
void show_text(const std::string& title, const std::string& text);

} // namespace druse::ui
