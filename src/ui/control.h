#pragma once

#include "ui/implied.h"

#include "ops/operator.h"

#include <string>
#include <string_view>
#include <vector>

namespace druse::ui {

/// One row of the parameter panel: what its control is, without a widget. A list of numbers of fixed length has a row for each.
struct Control {
    enum class Kind {
        number,   // a field, with a slider where the numbers have a range one can slide over
        toggle,   // a check button
        choice,   // one of some words
        field,    // text as a command writes it
        selector, // a field, with words to choose from
        colour,   // a field and a swatch
        file,     // a field and a button that asks for a file
        solid     // a field and a button that shows all solids there are
    };

    Kind kind = Kind::field;
    std::string parameter; // its name in commands
    int place = -1;        // in a list, from 0; −1: not a list
    std::string label;
    std::string help;      // help, type, unit, range and default, as a tooltip
    std::vector<std::string> words;
    std::string initial;   // the text of the default; empty: unset or required
    bool required = false;

    // Of a number.
    bool integer = false, slider = false;
    Range range;              // what is allowed
    double low = 0, high = 0; // where the slider ends; typing may go on to the ends of `range`
    double step = 0;
    std::vector<double> marks; // places that are marked on the slider

    /// The number that a slider gives at `x`: a multiple of the step, inside the slider and allowed.
    double snap(double x) const;

    /// Does the same row serve both? Precondition: both are of one operator.
    bool is_like(const Control& other) const;
};

/// The rows for an operator, in the order of its parameters. Those that have an implied value slide as others do.
std::vector<Control> controls_of(const Operator& op, const Implied& implied = {});

/// Makes it a number with a slider that goes as far above 0 as below it, about that far.
void slide_around_zero(Control& control, double reach);

/// The piece of a list at `place`, or all of `text` if that is negative; empty if the list is too short.
std::string piece_of(std::string_view text, int place);
/// `text` with that piece replaced. Precondition: the list is long enough.
std::string with_piece(std::string_view text, int place, std::string_view piece);

} // namespace druse::ui
