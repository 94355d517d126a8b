#pragma once

#include "dlfl/errors.h"
#include "geom/colour.h"
#include "ops/selector.h"
#include "ops/text.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace druse {

enum class Unit { none, degrees, length, area, ratio, count, id };
const char* name(Unit unit); // as in messages: "degrees", "model units", …; empty for none

/// The numbers a parameter takes.
struct Range {
    double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
    bool above_min = false, below_max = false; // the end itself is left out
    bool without_zero = false;

    bool contains(double x) const
    {
        return (above_min ? x > min : x >= min) && (below_max ? x < max : x <= max) && !(without_zero && x == 0.0);
    }
    bool is_everything() const { return std::isinf(min) && std::isinf(max) && !without_zero; }
    std::string text() const; // `1 to 179`, `above 0`, `-100 to 100, not 0`
};
inline Range nonzero(double min, double max) { return {min, max, false, false, true}; }
inline Range nonzero() { return {.without_zero = true}; }
inline Range between(double min, double max) { return {min, max, true, true, false}; } // both ends left out
inline Range above(double min) { return {min, std::numeric_limits<double>::infinity(), true, false, false}; }
inline Range at_least(double min) { return {min, std::numeric_limits<double>::infinity(), false, false, false}; }

/// Text, as a type of its own where it names a file.
struct FilePath {
    std::string path;
};

/// A value, or one of the words the registration lists beside it: `thickness=0.2` or `thickness=auto`.
template <class T>
struct OrWord {
    std::string word; // empty: the value counts
    T value{};

    OrWord() = default;
    OrWord(const char* w) : word(w) {}
    OrWord(T v) : value(std::move(v)) {}
};

struct Words {
    std::vector<std::string> list;
};
Words words(std::initializer_list<const char*> list);

/// What values a parameter takes, beside what its type says.
struct Domain {
    Unit unit = Unit::none;
    Range range;
    Range length; // of a list
    std::vector<std::string> words;
};

/// One parameter of an operator, its type erased.
struct Parameter {
    /// What a panel needs to know to make a control for it.
    enum class Type { number, integer, toggle, word, numbers, integers, texts, point, colour, text, file, name_or_file, faces, edges, vertices, id, corner };

    std::string name, help;
    Type type = Type::number;
    Domain domain;
    int fixed_length = 0; // of a list, 0: it varies
    std::string default_text; // empty: unset, or required
    bool required = false;
    bool optional = false;    // may stay unset
    bool repeated = false;    // a command may give it several times; as one text with blanks between the values
    std::string governor{};   // counts only where this parameter, of words, has one of these; elsewhere it must not be given
    std::vector<std::string> governing{};
    std::string instead_of{}; // takes the place of this parameter, which must not be given beside it

    /// Reads a value into the parameters `p` of an operator. @throws CommandError `expected …`
    void set(void* p, std::string_view value) const { read(p, value, domain); }
    /// The value in `p` as a command writes it; empty: unset.
    std::string text(const void* p) const { return write(p, domain); }

    std::string type_text() const;     // `number`, `3 numbers`, `faces`, …
    /// Whether this value names a file: of a name_or_file, one with a dot or a slash.
    bool names_file(std::string_view value) const
    {
        return type == Type::file || (type == Type::name_or_file && value.find_first_of("./") != std::string_view::npos);
    }

    // How make_parameter() fills it; `defaults` are an operator's parameters as they are without a command.
    void describe(std::string_view its_name, std::string_view its_help, Domain its_domain, const void* defaults);
    std::function<void(void*, std::string_view, const Domain&)> read;
    std::function<std::string(const void*, const Domain&)> write;
};

/// How a C++ type is a parameter: read<T>::from, read<T>::text, and its tag.
template <class T>
struct ParameterType;

template <>
struct ParameterType<double> {
    static constexpr auto type = Parameter::Type::number;
    static double parse(std::string_view t, const Domain& d);
    static std::string text(double x, const Domain&) { return number_text(x); }
};
template <>
struct ParameterType<int> {
    static constexpr auto type = Parameter::Type::integer;
    static int parse(std::string_view t, const Domain& d);
    static std::string text(int x, const Domain&) { return std::to_string(x); }
};
template <>
struct ParameterType<bool> {
    static constexpr auto type = Parameter::Type::toggle;
    static bool parse(std::string_view t, const Domain&);
    static std::string text(bool x, const Domain&) { return x ? "true" : "false"; }
};
template <class E>
    requires std::is_enum_v<E>
struct ParameterType<E> {
    static constexpr auto type = Parameter::Type::word;
    static E parse(std::string_view t, const Domain& d)
    {
        for (std::size_t i = 0; i < d.words.size(); ++i)
            if (d.words[i] == t) return static_cast<E>(i);
        throw CommandError("expected " + listing(d.words));
    }
    static std::string text(E x, const Domain& d) { return d.words.at(static_cast<std::size_t>(x)); }
};
template <>
struct ParameterType<std::string> {
    static constexpr auto type = Parameter::Type::text;
    static std::string parse(std::string_view t, const Domain&) { return std::string(t); }
    static std::string text(const std::string& x, const Domain&) { return x; }
};
template <>
struct ParameterType<FilePath> {
    static constexpr auto type = Parameter::Type::file;
    static FilePath parse(std::string_view t, const Domain&);
    static std::string text(const FilePath& x, const Domain&) { return x.path; }
};
template <>
struct ParameterType<Colour> {
    static constexpr auto type = Parameter::Type::colour;
    static Colour parse(std::string_view t, const Domain&);
    static std::string text(Colour x, const Domain&) { return to_hex(x); }
};
template <>
struct ParameterType<Point> {
    static constexpr auto type = Parameter::Type::point;
    static Point parse(std::string_view t, const Domain&);
    static std::string text(const Point& x, const Domain&) { return number_text(x.x) + "," + number_text(x.y) + "," + number_text(x.z); }
};
template <class H>
struct ParameterType<Selector<H>> {
    static constexpr auto type = std::is_same_v<H, Face> ? Parameter::Type::faces
                                 : std::is_same_v<H, Edge> ? Parameter::Type::edges
                                                           : Parameter::Type::vertices;
    static Selector<H> parse(std::string_view t, const Domain&) { return Selector<H>::parse(t); }
    static std::string text(const Selector<H>& x, const Domain&) { return x.text(); }
};
template <>
struct ParameterType<FaceId> {
    static constexpr auto type = Parameter::Type::id;
    static FaceId parse(std::string_view t, const Domain&) { return {parse_id(t)}; }
    static std::string text(FaceId x, const Domain&) { return std::to_string(x.id); }
};
template <>
struct ParameterType<VertexId> {
    static constexpr auto type = Parameter::Type::id;
    static VertexId parse(std::string_view t, const Domain&) { return {parse_id(t)}; }
    static std::string text(VertexId x, const Domain&) { return std::to_string(x.id); }
};
template <>
struct ParameterType<EdgeId> {
    static constexpr auto type = Parameter::Type::id;
    static EdgeId parse(std::string_view t, const Domain&);
    static std::string text(EdgeId x, const Domain&);
};
template <>
struct ParameterType<CornerId> {
    static constexpr auto type = Parameter::Type::corner;
    static CornerId parse(std::string_view t, const Domain&);
    static std::string text(CornerId x, const Domain&) { return std::to_string(x.face) + ":" + std::to_string(x.place); }
};

/// Lists: fixed in length as std::array, of a length in a range as std::vector.
template <class T>
std::string list_text(const T& list, const Domain& d)
{
    std::string text;
    for (const auto& x : list) {
        if (&x != &*list.begin()) text += ',';
        text += ParameterType<std::remove_cvref_t<decltype(x)>>::text(x, d);
    }
    return text;
}
void check_length(std::size_t length, const Range& range, const char* what);

template <class T>
constexpr Parameter::Type list_type()
{
    if constexpr (std::is_same_v<T, double>) return Parameter::Type::numbers;
    else if constexpr (std::is_same_v<T, int>) return Parameter::Type::integers;
    else return Parameter::Type::texts;
}
template <class T>
constexpr const char* list_noun()
{
    return std::is_same_v<T, double> ? "numbers" : std::is_same_v<T, int> ? "integers" : "words";
}
template <class T, std::size_t N>
struct ParameterType<std::array<T, N>> {
    static constexpr auto type = list_type<T>();
    static std::array<T, N> parse(std::string_view t, const Domain& d)
    {
        const auto pieces = split(t, ',');
        check_length(pieces.size(), {double(N), double(N)}, list_noun<T>());
        std::array<T, N> list;
        for (std::size_t i = 0; i < N; ++i) list[i] = ParameterType<T>::parse(pieces[i], d);
        return list;
    }
    static std::string text(const std::array<T, N>& x, const Domain& d) { return list_text(x, d); }
};
template <class T>
struct ParameterType<std::vector<T>> {
    static constexpr auto type = list_type<T>();
    static std::vector<T> parse(std::string_view t, const Domain& d)
    {
        const auto pieces = split(t, ',');
        check_length(pieces.size(), d.length, list_noun<T>());
        std::vector<T> list;
        list.reserve(pieces.size());
        for (const auto piece : pieces) list.push_back(ParameterType<T>::parse(piece, d));
        return list;
    }
    static std::string text(const std::vector<T>& x, const Domain& d) { return list_text(x, d); }
};
template <class T>
struct ParameterType<OrWord<T>> {
    static constexpr auto type = ParameterType<T>::type;
    static OrWord<T> parse(std::string_view t, const Domain& d)
    {
        OrWord<T> result;
        for (const std::string& word : d.words)
            if (word == t) {
                result.word = word;
                return result;
            }
        try {
            result.value = ParameterType<T>::parse(t, d);
        } catch (const CommandError& e) {
            throw CommandError(std::string(e.what()) + ", or " + listing(d.words));
        }
        return result;
    }
    static std::string text(const OrWord<T>& x, const Domain& d) { return x.word.empty() ? ParameterType<T>::text(x.value, d) : x.word; }
};

template <class T>
struct IsOptional : std::false_type {
    using Value = T;
};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {
    using Value = T;
};
template <class T>
constexpr int fixed_length = 0;
template <class T, std::size_t N>
constexpr int fixed_length<std::array<T, N>> = int(N);

/// What an operator is called without any parameter.
template <class P>
const P& defaults()
{
    static const P values{};
    return values;
}

/// Of a member of P, or of a base of it. What does not depend on the types is done elsewhere: registrations are many, and all of them
/// pass through here.
template <class P, class T, class B>
Parameter make_parameter(T B::*member, std::string_view name, std::string_view help, Domain domain)
{
    using Value = typename IsOptional<T>::Value;
    Parameter result;
    result.type = ParameterType<Value>::type;
    result.fixed_length = fixed_length<Value>;
    result.optional = IsOptional<T>::value;
    result.repeated = requires { ParameterType<Value>::repeated; };
    result.read = [member](void* p, std::string_view t, const Domain& d) { static_cast<P*>(p)->*member = ParameterType<Value>::parse(t, d); };
    result.write = [member](const void* p, const Domain& d) -> std::string {
        const T& value = static_cast<const P*>(p)->*member;
        if constexpr (IsOptional<T>::value) return value ? ParameterType<Value>::text(*value, d) : std::string();
        else return ParameterType<Value>::text(value, d);
    };
    result.describe(name, help, std::move(domain), &defaults<P>());
    return result;
}

} // namespace druse
