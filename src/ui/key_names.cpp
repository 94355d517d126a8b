#include "ui/key_names.h"

#include <FL/Enumerations.H>

#include <charconv>
#include <utility>

namespace druse::ui {

namespace {

constexpr std::pair<int, const char*> modifiers[] = {{FL_CTRL, "Ctrl"}, {FL_ALT, "Alt"}, {FL_SHIFT, "Shift"}};
constexpr std::pair<int, const char*> names[] = {
    {FL_BackSpace, "BackSpace"}, {FL_Tab, "Tab"},   {FL_Enter, "Enter"},     {FL_Escape, "Escape"}, {FL_Home, "Home"},
    {FL_Left, "Left"},           {FL_Up, "Up"},     {FL_Right, "Right"},     {FL_Down, "Down"},     {FL_Page_Up, "PageUp"},
    {FL_Page_Down, "PageDown"},  {FL_End, "End"},   {FL_Insert, "Insert"},   {FL_Delete, "Delete"}, {' ', "Space"},
    {'+', "Plus"},               {FL_KP_Enter, "KpEnter"},
};

char capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
char small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

} // namespace

std::string key_text(Key key)
{
    std::string text;
    for (const auto& [bit, name] : modifiers)
        if (key.state & bit) text.append(name).append("+");
    for (const auto& [code, name] : names)
        if (code == key.key) return text.append(name);
    if (key.key > FL_F && key.key <= FL_F_Last) return text.append("F").append(std::to_string(key.key - FL_F));
    if (key.key > FL_KP && key.key <= FL_KP_Last) return text.append("Kp").append(1, static_cast<char>(key.key - FL_KP));
    if (key.key <= ' ' || key.key >= 127) return {};
    const char c = static_cast<char>(key.key);
    return text.append(1, text.empty() ? c : capital(c));
}

std::optional<Key> key_from_text(std::string_view text)
{
    Key key;
    bool found = true;
    while (found) {
        found = false;
        for (const auto& [bit, name] : modifiers) {
            const std::string prefix = std::string(name).append("+");
            if (!text.starts_with(prefix)) continue;
            key.state |= bit;
            text.remove_prefix(prefix.size());
            found = true;
        }
    }
    for (const auto& [code, name] : names)
        if (text == name) key.key = code;
    if (key.key != 0) return key;
    if (text.size() == 1 && text[0] > ' ' && text[0] < 127) key.key = small(text[0]);
    else if (text.size() == 3 && text.starts_with("Kp")) key.key = FL_KP + text[2];
    else if (text.size() > 1 && text[0] == 'F') {
        int number = 0;
        const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), number);
        if (error != std::errc() || end != text.data() + text.size() || number < 1 || number > 35) return {};
        key.key = FL_F + number;
    } else {
        return {};
    }
    return key;
}

} // namespace druse::ui
