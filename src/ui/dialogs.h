#pragma once

#include "geom/colour.h"

#include <filesystem>
#include <optional>
#include <string>

namespace druse::ui {

// Questions that stop everything else until they are answered.

/// A file to read; nothing if the person changed their mind.
std::optional<std::filesystem::path> ask_for_model(const char* title);
/// A file to write; `proposed` is filled in.
std::optional<std::filesystem::path> ask_where_to_save(const char* title, const std::filesystem::path& proposed);

std::optional<Colour> ask_for_colour(Colour before);
/// A line of text.
std::optional<std::string> ask_for_text(const std::string& question, const std::string& before);

enum class Unsaved { save, discard, cancel };
Unsaved ask_about_changes(const std::string& name);
/// About a model that an earlier run left behind.
enum class Leftover { recover, discard, keep };
Leftover ask_about_leftover(const std::filesystem::path& model);
bool ask_to_replace(const std::filesystem::path& file);
void show_failure(const std::string& text);

} // namespace druse::ui
