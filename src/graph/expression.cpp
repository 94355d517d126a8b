#include "graph/expression.h"

#include "dlfl/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

namespace druse {

namespace {

constexpr std::size_t deepest_nesting = 100;   // brackets, signs and powers in one another
constexpr std::size_t tallest_stack = 3 * (deepest_nesting + 2); // values that wait: of each nesting a sum, a product and the first of two arguments

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

} // namespace

/// Descends through sums, products, signs and powers, and writes down what it meets in the order in which it is to be done.
class Expression::Parser {
public:
    Parser(std::string_view text, std::vector<Step>& steps) : text_(text), steps_(steps) {}

    void parse()
    {
        if (at_end()) throw CommandError("expected a formula");
        sum(0);
        if (!at_end()) fail("an operator");
    }

private:
    void sum(std::size_t depth)
    {
        product(depth);
        for (;;) {
            if (take('+')) binary(Code::plus, depth);
            else if (take('-')) binary(Code::minus, depth);
            else return;
        }
    }
    void binary(Code code, std::size_t depth)
    {
        product(depth);
        steps_.push_back({code});
    }

    void product(std::size_t depth)
    {
        sign(depth);
        for (;;) {
            const bool times = take('*');
            if (!times && !take('/')) return;
            sign(depth);
            steps_.push_back({times ? Code::times : Code::over});
        }
    }

    void sign(std::size_t depth)
    {
        if (depth > deepest_nesting) throw CommandError(fmt::format("nested more than {} deep", deepest_nesting));
        if (take('+')) return sign(depth + 1);
        if (!take('-')) return power(depth);
        sign(depth + 1);
        steps_.push_back({Code::negate});
    }

    void power(std::size_t depth)
    {
        value(depth);
        if (!take('^')) return;
        sign(depth + 1);
        steps_.push_back({Code::power});
    }

    void value(std::size_t depth)
    {
        if (at_end()) fail("a value");
        if (take('(')) {
            sum(depth + 1);
            return close();
        }
        if (is_letter(text_[at_])) return word(depth);
        double number = 0;
        const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), number);
        if (error == std::errc::result_out_of_range)
            throw CommandError(fmt::format("the number at character {} is too large or too small", at_ + 1));
        if ((!is_digit(text_[at_]) && text_[at_] != '.') || error != std::errc()) fail("a value");
        at_ = static_cast<std::size_t>(end - text_.data());
        steps_.push_back({Code::number, number});
    }

    void word(std::size_t depth)
    {
        const std::size_t begin = at_;
        while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
        const std::string_view name = text_.substr(begin, at_ - begin);
        if (name == "pi") return steps_.push_back({Code::number, std::numbers::pi});
        static constexpr std::array<std::pair<std::string_view, Code>, 4> variables{{{"x", Code::x}, {"y", Code::y}, {"r", Code::r}, {"t", Code::t}}};
        for (const auto& [variable, code] : variables)
            if (name == variable) return steps_.push_back({code});
        static constexpr std::array<std::pair<std::string_view, Code>, 9> functions{{{"sin", Code::sin}, {"cos", Code::cos}, {"tan", Code::tan},
                                                                                    {"sqrt", Code::sqrt}, {"exp", Code::exp}, {"log", Code::log},
                                                                                    {"abs", Code::abs}, {"min", Code::min}, {"max", Code::max}}};
        for (const auto& [function, code] : functions) {
            if (name != function) continue;
            if (!take('(')) fail(fmt::format("( after {}", name));
            sum(depth + 1);
            if (code == Code::min || code == Code::max) {
                if (!take(',')) fail(fmt::format("a comma and a second value of {}", name));
                sum(depth + 1);
            }
            close();
            return steps_.push_back({code});
        }
        at_ = begin;
        fail("x, y, r, t, pi or one of sin cos tan sqrt exp log abs min max");
    }

    void close()
    {
        if (!take(')')) fail(")");
    }

    bool at_end()
    {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
        return at_ == text_.size();
    }
    bool take(char c)
    {
        if (at_end() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    [[noreturn]] void fail(std::string_view expected)
    {
        if (at_end()) throw CommandError(fmt::format("expected {} at the end", expected));
        // The word or sign that stands there.
        std::size_t end = at_ + 1;
        while (end < text_.size() && end < at_ + 20 && is_letter(text_[at_]) && is_letter(text_[end])) ++end;
        while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xc0u) == 0x80u) ++end; // the rest of a character of UTF-8
        throw CommandError(fmt::format("expected {} at character {}, found '{}'", expected, at_ + 1, text_.substr(at_, end - at_)));
    }

    std::string_view text_;
    std::vector<Step>& steps_;
    std::size_t at_ = 0;
};

Expression::Expression(std::string_view text) { Parser(text, steps_).parse(); }

double Expression::operator()(const Variables& at) const
{
    std::array<double, tallest_stack> stack;
    std::size_t height = 0;
    const auto require = [](double value, const auto& what) {
        if (!std::isfinite(value)) throw CommandError(what() + " is not a finite number");
        return value;
    };
    for (const Step& step : steps_) {
        const auto push = [&](double value) { stack[height++] = value; };
        const auto apply = [&](const char* name, double (*function)(double)) {
            double& top = stack[height - 1];
            const double argument = top;
            top = require(function(argument), [&] { return fmt::format("{}({})", name, argument); });
        };
        const auto combine = [&](const char* sign, auto function) {
            const double b = stack[--height], a = stack[height - 1];
            const auto text = [](double x) { return x < 0 ? fmt::format("({})", x) : fmt::format("{}", x); };
            stack[height - 1] = require(function(a, b), [&] { return text(a) + sign + text(b); });
        };
        switch (step.code) {
        case Code::number: push(step.number); break;
        case Code::x: push(at.x); break;
        case Code::y: push(at.y); break;
        case Code::r: push(at.r); break;
        case Code::t: push(at.t); break;
        case Code::plus: combine("+", [](double a, double b) { return a + b; }); break;
        case Code::minus: combine("-", [](double a, double b) { return a - b; }); break;
        case Code::times: combine("*", [](double a, double b) { return a * b; }); break;
        case Code::over: combine("/", [](double a, double b) { return a / b; }); break;
        case Code::power: combine("^", [](double a, double b) { return std::pow(a, b); }); break;
        case Code::negate: stack[height - 1] = -stack[height - 1]; break;
        case Code::sin: apply("sin", [](double a) { return std::sin(a); }); break;
        case Code::cos: apply("cos", [](double a) { return std::cos(a); }); break;
        case Code::tan: apply("tan", [](double a) { return std::tan(a); }); break;
        case Code::sqrt: apply("sqrt", [](double a) { return std::sqrt(a); }); break;
        case Code::exp: apply("exp", [](double a) { return std::exp(a); }); break;
        case Code::log: apply("log", [](double a) { return std::log(a); }); break;
        case Code::abs: apply("abs", [](double a) { return std::abs(a); }); break;
        case Code::min: combine(" min ", [](double a, double b) { return std::min(a, b); }); break;
        case Code::max: combine(" max ", [](double a, double b) { return std::max(a, b); }); break;
        }
    }
    return stack[0];
}

} // namespace druse
