#include "ui/control.h"

#include "ops/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace druse::ui {

namespace {

using Type = Parameter::Type;

/// 1, 2 or 5 times a power of ten, near `x` from below.
double round_step(double x)
{
    const double power = std::pow(10.0, std::floor(std::log10(x)));
    for (const double digit : {5.0, 2.0})
        if (digit * power <= x) return digit * power;
    return power;
}

/// Where a slider makes sense: over the whole range if it is narrow, else around the default.
void set_slider(Control& c, const Range& range, double around)
{
    constexpr double widest = 360, widest_integers = 64;
    const bool bounded = !std::isinf(range.min) && !std::isinf(range.max);
    if (bounded && range.max - range.min <= (c.integer ? widest_integers : widest) && !range.without_zero) {
        c.low = range.min;
        c.high = range.max;
    } else {
        const double size = around != 0 ? std::abs(around) : 1;
        c.low = range.min < 0 ? (c.integer ? -4 : -2) * size : std::max(range.min, 0.0);
        c.high = std::min(range.max, 4 * size);
        if (c.low >= c.high) return;
    }
    c.slider = true;
    c.step = c.integer ? 1 : round_step((c.high - c.low) / 300);
    if (!c.integer && range.above_min && c.low == range.min) c.low += c.step;
    if (!c.integer && range.below_max && c.high == range.max) c.high -= c.step;
}

std::string tooltip(const Parameter& p)
{
    std::string text = p.help + "\n" + p.name + ": " + p.type_text();
    if (const std::string range = p.domain.range.is_everything() ? "" : p.domain.range.text(); !range.empty()) text += ", " + range;
    if (const char* unit = name(p.domain.unit); *unit) text += fmt::format(" {}", unit);
    if (!p.domain.words.empty()) text.append("\n").append(listing(p.domain.words));
    if (p.required) text += "\nmust be given";
    else text += "\ndefault " + (p.default_text.empty() ? std::string("unset") : p.default_text);
    return text;
}

std::string readable(std::string_view name)
{
    std::string text(name);
    std::replace(text.begin(), text.end(), '_', ' ');
    return text;
}

/// `height 2` for the second of `heights`.
std::string label_of_piece(const Parameter& p, int place)
{
    std::string text = readable(p.name);
    if (text.size() > 3 && text.back() == 's') text.pop_back();
    return fmt::format("{} {}", text, place + 1);
}

Control::Kind kind_of(const Parameter& p)
{
    const bool words = !p.domain.words.empty();
    switch (p.type) {
    case Type::number:
    case Type::integer: return words || p.optional ? (words ? Control::Kind::selector : Control::Kind::field) : Control::Kind::number;
    case Type::toggle: return Control::Kind::toggle;
    case Type::word: return Control::Kind::choice;
    case Type::faces:
    case Type::edges:
    case Type::vertices: return Control::Kind::selector;
    case Type::colour: return words ? Control::Kind::selector : Control::Kind::colour;
    case Type::file: return Control::Kind::file;
    case Type::name_or_file: return Control::Kind::solid;
    default: return words ? Control::Kind::selector : Control::Kind::field;
    }
}

std::vector<std::string> words_of(const Parameter& p)
{
    if (p.type == Type::faces || p.type == Type::edges || p.type == Type::vertices) return {"selected", "all", "none"};
    return p.domain.words;
}

double number_of(std::string_view text)
{
    try {
        return parse_number(text);
    } catch (const CommandError&) {
        return 0;
    }
}

} // namespace

double Control::snap(double x) const
{
    // A sum of decimal steps is seldom the decimal number one means.
    const double places = std::pow(10.0, std::ceil(-std::log10(step) - 1e-9));
    const auto decimal = [places](double v) { return places >= 1 ? std::round(v * places) / places : v; };
    double value = decimal(std::clamp(std::round(x / step) * step, low, high));
    if (value < low) value = decimal(value + step); // an end that is no such number, as 1/3
    if (value > high) value = decimal(value - step);
    if (range.without_zero && value == 0) value = x < 0 ? -step : step;
    return value;
}

bool Control::is_like(const Control& other) const
{
    const auto key = [](const Control& c) { return std::tie(c.kind, c.parameter, c.place, c.label, c.initial, c.slider, c.low, c.high, c.step); };
    return key(*this) == key(other);
}

std::vector<Control> controls_of(const Operator& op, const Implied& implied)
{
    std::vector<Control> result;
    for (const Parameter& p : op.parameters) {
        Control c;
        c.kind = kind_of(p);
        c.parameter = p.name;
        c.label = readable(p.name);
        c.help = tooltip(p);
        c.words = words_of(p);
        c.initial = p.default_text;
        c.required = p.required;
        c.range = p.domain.range;
        c.integer = p.type == Type::integer || p.type == Type::integers;

        const auto in_full = implied.find(p.name);
        const std::string& whole = in_full == implied.end() ? p.default_text : in_full->second.text;
        const int length = p.fixed_length > 0 ? p.fixed_length : in_full == implied.end() ? 0 : int(split(whole, ',').size());
        const bool list = (p.type == Type::numbers || p.type == Type::integers) && length > 0;
        const bool full = int(split(whole, ',').size()) == length;
        if (list && full && p.domain.words.empty()) {
            c.kind = Control::Kind::number;
            const bool one_for_all = int(split(p.default_text, ',').size()) == 1;
            for (int i = 0; i < length; ++i) {
                Control piece = c;
                piece.place = i;
                piece.initial = piece_of(p.default_text, one_for_all ? 0 : i);
                if (length > 1) piece.label = label_of_piece(p, i);
                set_slider(piece, p.domain.range, number_of(piece.initial));
                result.push_back(std::move(piece));
            }
            continue;
        }
        if ((p.type == Type::number || p.type == Type::integer) && in_full != implied.end()) {
            c.kind = Control::Kind::number;
            set_slider(c, p.domain.range, in_full->second.usual);
        } else if (c.kind == Control::Kind::number && !c.initial.empty()) {
            set_slider(c, p.domain.range, number_of(c.initial));
        }
        result.push_back(std::move(c));
    }
    return result;
}

void slide_around_zero(Control& control, double reach)
{
    control.kind = Control::Kind::number;
    control.slider = true;
    control.range.without_zero = true;
    control.step = round_step(reach / 150);
    control.high = control.step * std::ceil(reach / control.step);
    control.low = -control.high;
}

std::string piece_of(std::string_view text, int place)
{
    if (place < 0) return std::string(text);
    const auto pieces = split(text, ',');
    return place < int(pieces.size()) ? std::string(pieces[std::size_t(place)]) : std::string();
}

std::string with_piece(std::string_view text, int place, std::string_view piece)
{
    if (place < 0) return std::string(piece);
    auto pieces = split(text, ',');
    pieces.at(std::size_t(place)) = piece;
    std::string result;
    for (std::size_t i = 0; i < pieces.size(); ++i) result.append(i == 0 ? "" : ",").append(pieces[i]);
    return result;
}

} // namespace druse::ui
