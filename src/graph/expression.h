#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace druse {

/// A formula in x, y, r and t: numbers, `pi`, + - * / ^, brackets, and sin cos tan sqrt exp log abs min max.
///
/// As in mathematics ^ binds first and to the right, and before a sign in front of it: -r^2 is −(r²), 2^-1 a half.
class Expression {
public:
    struct Variables {
        double x, y, r, t;
    };

    /// @throws CommandError that says what was expected where; also where brackets and signs are nested more than 100 deep
    explicit Expression(std::string_view text);

    /// Its value. @throws CommandError where a part of it has none: `log(0) is not a number`, `1/0 …`. Cost: linear in its length, allocates nothing.
    double operator()(const Variables& at) const;

private:
    enum class Code : unsigned char { number, x, y, r, t, plus, minus, times, over, power, negate, sin, cos, tan, sqrt, exp, log, abs, min, max };
    struct Step {
        Code code;
        double number = 0;
    };
    class Parser;

    std::vector<Step> steps_; // postfix
};

} // namespace druse
