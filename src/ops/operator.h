#pragma once

#include "dlfl/errors.h"
#include "geom/progress.h"
#include "ops/parameter.h"
#include "ops/remesh_again.h"
#include "ops/scene.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace druse {

/// What an operator gets beside the scene and its parameters, and what it says.
struct Context {
    Progress& progress;
    std::filesystem::path folder{}; // what file parameters are relative to
    std::vector<std::filesystem::path> scripts{}; // being run, from the outermost in: none of them may be opened again
    std::vector<std::string> notes{}; // one line each, without `note:`
    std::string output{};           // of a query: one JSON object
    bool failed = false;            // of a query: something it looked for is wrong (exit 2 with strict=true)
    std::function<Mesh(const std::filesystem::path&)> read_mesh{}; // reads a mesh file, `folder` and all. @throws InputError

    void note(std::string line) { notes.push_back(std::move(line)); }
};

/// A stored set of an operator's parameters, written like the end of a command: `angle=90 heights=0.5`.
struct Preset {
    std::string name, arguments;
};

/// One entry of the registry: everything that menus, panels, the command line, scripts, history and the reference page know.
struct Operator {
    enum class Kind {
        edit,  // changes the scene: one step of the history
        query, // changes nothing, prints one JSON object
        travel // goes along the history (document.undo, redo, goto)
    };

    std::string name; // family.word_word
    std::string help; // one line
    std::string source, example;
    std::vector<std::string> aliases;
    Kind kind = Kind::edit;
    std::vector<Parameter> parameters;
    std::vector<std::vector<std::string>> exclusive; // exactly one of each set is given
    std::vector<Preset> presets;
    std::optional<std::int64_t> euler_change; // what χ = V − E + F grows by, where it is the same for every mesh and all parameters

    std::function<std::shared_ptr<void>()> make;                       // parameters with their defaults
    std::function<void(Scene&, const void*, Context&)> run;            // throws CommandError; Document::apply puts the scene back
    KeepRun keep = nullptr; // how a run is kept, of remeshings that treat every face alike

    std::string family() const { return name.substr(0, name.find('.')); }
    std::string title() const; // `Truncated cube` for family.truncated_cube
    const Parameter* find(std::string_view parameter) const;
    /// Whether a parameter counts, where the parameter that decides on that has this value.
    static bool counts(const Parameter& p, std::string_view value);
};

/// What of a Definition does not depend on the type of its parameters.
class Registration {
public:
    operator Operator() const { return operator_; }

protected:
    Registration(std::string_view name, std::string_view help, std::function<std::shared_ptr<void>()> make);
    void add(Parameter&& parameter);
    void add_exclusive(std::initializer_list<const char*> names);
    void add_preset(std::string_view name, std::string_view arguments);

    Operator operator_;
};

/// The typed way to an Operator: what `define` returns. P is a struct whose initialisers are the defaults; B below is P or a base of it.
template <class P>
class Definition : public Registration {
public:
    Definition(std::string_view name, std::string_view help)
        : Registration(name, help, [] { return std::static_pointer_cast<void>(std::make_shared<P>()); })
    {
    }

    /// A number, integer or list of them, with unit and range.
    template <class T, class B>
    Definition& param(T B::*member, std::string_view name, Unit unit, const Range& range, std::string_view help)
    {
        add(make_parameter<P>(member, name, help, Domain{unit, range, {}, {}}));
        return *this;
    }
    /// A list with a range for its length (of numbers, or of anything else).
    template <class T, class B>
    Definition& param(T B::*member, std::string_view name, Unit unit, const Range& range, const Range& length, std::string_view help)
    {
        add(make_parameter<P>(member, name, help, Domain{unit, range, length, {}}));
        return *this;
    }
    /// One of a set of words: an enum with its values in order, or words beside another type.
    template <class T, class B>
    Definition& param(T B::*member, std::string_view name, Words words, std::string_view help)
    {
        add(make_parameter<P>(member, name, help, Domain{Unit::none, {}, {}, std::move(words.list)}));
        return *this;
    }
    template <class T, class B>
    Definition& param(T B::*member, std::string_view name, Unit unit, const Range& range, Words words, std::string_view help)
    {
        add(make_parameter<P>(member, name, help, Domain{unit, range, {}, std::move(words.list)}));
        return *this;
    }
    /// A switch, selector, id, point, colour, text or file.
    template <class T, class B>
    Definition& param(T B::*member, std::string_view name, std::string_view help)
    {
        add(make_parameter<P>(member, name, help, Domain{}));
        return *this;
    }

    /// The parameter added last has no default and must be given.
    Definition& required()
    {
        operator_.parameters.back().required = true;
        operator_.parameters.back().default_text.clear();
        return *this;
    }
    /// The parameter added last counts only where another one, of words, has one of these values; with another value it must not be given.
    Definition& only_where(std::string_view parameter, std::initializer_list<const char*> values)
    {
        operator_.parameters.back().governor = parameter;
        operator_.parameters.back().governing.assign(values.begin(), values.end());
        return *this;
    }
    /// The parameter added last takes the place of another one: both must not be given.
    Definition& instead_of(std::string_view parameter)
    {
        operator_.parameters.back().instead_of = parameter;
        return *this;
    }
    /// Exactly one of these parameters is given.
    Definition& exactly_one(std::initializer_list<const char*> names)
    {
        add_exclusive(names);
        return *this;
    }
    Definition& preset(std::string_view name, std::string_view arguments)
    {
        add_preset(name, arguments);
        return *this;
    }
    /// χ grows by that much on every mesh and with all parameters.
    Definition& euler_change(std::int64_t change)
    {
        operator_.euler_change = change;
        return *this;
    }
    Definition& keeps_euler() { return euler_change(0); }
    Definition& alias(std::string_view name)
    {
        operator_.aliases.emplace_back(name);
        return *this;
    }
    Definition& example(std::string_view command)
    {
        operator_.example = command;
        return *this;
    }
    Definition& cites(std::string_view source)
    {
        operator_.source = source;
        return *this;
    }
    Definition& query()
    {
        operator_.kind = Operator::Kind::query;
        return *this;
    }
    Definition& travel()
    {
        operator_.kind = Operator::Kind::travel;
        return *this;
    }
    Definition& keeps_runs_by(KeepRun keep)
    {
        operator_.keep = keep;
        return *this;
    }
    template <class Function>
    Definition& run(Function function)
    {
        operator_.run = [function](Scene& scene, const void* p, Context& context) { function(scene, *static_cast<const P*>(p), context); };
        return *this;
    }
};

template <class P>
Definition<P> define(std::string_view name, std::string_view help)
{
    return Definition<P>(name, help);
}

/// A base for operators without parameters.
struct NoParameters {};

} // namespace druse
