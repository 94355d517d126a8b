// Holds every registered operator, also those that are registered later, to what all of them promise.

#include "app/documents.h"
#include "app/registry.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace druse {
namespace {

using namespace test;

/// A document that begins with a shape whose faces are in groups 0 to 7, with everything selected, two steps done and one undone; for what opens
/// a crust, made one where it can be, for what maps a tessellation with one, and for what edits a pane or a tile with one of those.
Document prepared(const NamedShape& shape, const Operator& op)
{
    Mesh mesh = shape.make();
    for (const Face f : mesh.faces()) mesh.set_group(f, static_cast<int>(f.index % 8));
    Document document = document_of(all_operators(), std::move(mesh));
    if (op.name == "rind.punch" || op.name == "rind.peel") complaint(document, "rind.crust guard=off");
    if (op.name == "graph.map") complaint(document, "graph.tess layers=1");
    if (op.family() == "pane") {
        for (const char* command : {"pane.new loop=0,0,10,0,10,10,0,10 hole=5,4,6,4,6,5", "pane.add at=2,7", "pane.constrain line=1,2,4,8", "pane.refine min_angle=15"})
            EXPECT_EQ(complaint(document, command), "");
    }
    if (op.family() == "tile") {
        for (const char* command : {"tile.new type=IH41", "tile.edge path=0 points=0.25,0.1", "tile.point_add at=0.5,0.6", "tile.constrain from=v1 to=i0",
                                    "tile.stack mode=shift offset=0.3,0.2", "tile.extrude thickness=0.5", "tile.height points=i0 set=0.1"})
            EXPECT_EQ(complaint(document, command), "");
    }
    if (op.family() == "cell") {
        // Panes 0 and 1 have a point each and are flat; what is of phase II has the cell shaped.
        for (const char* command : {"cell.new cell=fcc", "cell.edge_add edge=1 t=0.25", "cell.point_add pane=0 at=0,0.05", "cell.point_add pane=1 at=0,0.05",
                                    "cell.constrain pane=1 from=v1 to=i0"})
            EXPECT_EQ(complaint(document, command), "");
        const bool is_shaped = op.name == "cell.move" || op.name.starts_with("cell.split") || op.name == "cell.flip" || op.name == "cell.rollback";
        if (is_shaped) {
            EXPECT_EQ(complaint(document, "cell.shape"), "");
        }
    }
    for (const char* command : {"select.vertices vertices=all", "select.edges edges=all", "select.faces faces=all", "select.faces faces=none", "document.undo"})
        if (complaint(document, command) != "") ADD_FAILURE() << command;
    return document;
}

/// What became of a command: how it ended, and the state after it.
struct Run {
    std::string complaint, text, output;
    std::vector<std::string> notes;
    State state;
    friend bool operator==(const Run&, const Run&) = default;
};

/// Applies a command. Whatever it does, it must end well or with a complaint of one line that leaves everything as it was.
Run run(Document& document, const std::string& command)
{
    SCOPED_TRACE(command);
    const State before(document);
    const std::size_t done = document.history().done(), size = document.history().size();
    Run r;
    Progress progress;
    try {
        Document::Outcome outcome = document.apply(command, progress, DRUSE_MODELS);
        r.text = std::move(outcome.text);
        r.output = std::move(outcome.output);
        r.notes = std::move(outcome.notes);
    } catch (const CommandError& e) {
        r.complaint = e.what();
    } catch (const InputError& e) {
        r.complaint = e.what();
    } catch (const std::exception& e) {
        ADD_FAILURE() << "ended in: " << e.what();
        r.complaint = e.what();
    }
    r.state = State(document);
    EXPECT_EQ(r.complaint.find('\n'), std::string::npos) << r.complaint;
    for (const std::string& note : r.notes) EXPECT_EQ(note.find('\n'), std::string::npos) << note;
    if (!r.complaint.empty()) {
        EXPECT_EQ(r.state, before);
        EXPECT_EQ(document.history().done(), done);
        EXPECT_EQ(document.history().size(), size);
    }
    return r;
}

void expect_numbered_without_gaps(const Mesh& mesh)
{
    EXPECT_FALSE(mesh.has_holes());
    EXPECT_EQ(mesh.vertex_count(), mesh.vertex_limit());
    EXPECT_EQ(mesh.edge_count(), mesh.edge_limit());
    EXPECT_EQ(mesh.face_count(), mesh.face_limit());
}

/// Everything an operator promises, for one command on one shape. @return whether the command went well
bool expect_promises(const Operator& op, const std::string& command, const NamedShape& shape)
{
    SCOPED_TRACE(shape.name + ": " + command);
    Document document = prepared(shape, op), again = prepared(shape, op);
    const State before(document);
    const std::size_t done = document.history().done();
    const Run first = run(document, command);
    EXPECT_EQ(run(again, command), first) << "another result when repeated";
    if (!first.complaint.empty()) {
        EXPECT_TRUE(op.kind == Operator::Kind::travel || first.complaint.find(op.name + ": ") == 0) << first.complaint;
        return false;
    }

    const Mesh& mesh = document.scene().mesh;
    EXPECT_SOUND(mesh);
    expect_numbered_without_gaps(mesh);
    if (op.euler_change) {
        EXPECT_EQ(euler_characteristic(mesh) - euler_characteristic(before.mesh), *op.euler_change);
    }

    // The canonical form does the same.
    Document canonical = prepared(shape, op);
    Run of_text = run(canonical, first.text);
    EXPECT_EQ(of_text, first) << first.text;

    switch (op.kind) {
    case Operator::Kind::query:
        EXPECT_EQ(first.state, before);
        EXPECT_EQ(document.history().done(), done);
        EXPECT_FALSE(first.output.empty());
        break;
    case Operator::Kind::edit:
        EXPECT_EQ(document.history().done(), done + 1);
        document.apply("document.undo");
        EXPECT_EQ(State(document), before) << "undo is not exact";
        document.apply("document.redo");
        EXPECT_EQ(State(document), first.state) << "redo is not exact";
        break;
    case Operator::Kind::travel: break;
    }
    return true;
}

class EveryOperator : public testing::TestWithParam<std::string> {
protected:
    const Operator& op() const { return all_operators().get(GetParam()); }
};

TEST_P(EveryOperator, KeepsItsPromisesOnEveryShapeAsInItsExample)
{
    bool went_well = false;
    for (const NamedShape& shape : all_shapes()) went_well = expect_promises(op(), op().example, shape) || went_well;
    EXPECT_TRUE(went_well) << "the example runs on none of the shapes: " << op().example;
}

TEST_P(EveryOperator, KeepsItsPromisesOnEveryShapeWithItsDefaults)
{
    for (const NamedShape& shape : all_shapes()) expect_promises(op(), op().name, shape);
}

TEST_P(EveryOperator, KeepsItsPromisesWhenActingOnOneElementAndOnAll)
{
    using Type = Parameter::Type;
    const std::string example = op().example;
    std::string one = op().name, all = op().name;
    bool selects = false;
    for (const Parameter& p : op().parameters) {
        if (p.type != Type::faces && p.type != Type::edges && p.type != Type::vertices) continue;
        selects = true;
        one += " " + p.name + "=0";
        all += " " + p.name + "=all";
    }
    if (!selects) return;
    // What else the example gives stays given.
    const Command given = parse_command(example);
    for (const auto& [key, value] : given.arguments) {
        const Parameter* p = op().find(key);
        if (!p || p->type == Type::faces || p->type == Type::edges || p->type == Type::vertices) continue;
        one += " " + argument_text(key, value);
        all += " " + argument_text(key, value);
    }
    for (const NamedShape& shape : all_shapes()) {
        expect_promises(op(), one, shape);
        expect_promises(op(), all, shape);
    }
}

std::vector<std::string> operator_names()
{
    std::vector<std::string> names;
    for (const Operator& op : all_operators().operators()) names.push_back(op.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryOperator, testing::ValuesIn(operator_names()), [](const auto& parameter) {
    std::string name = parameter.param;
    std::ranges::replace(name, '.', '_');
    return name;
});

// --- random sessions --------------------------------------------------------------------------------------------------------------

/// Makes up commands: any operator, with some of its parameters, most of them of the right form.
class RandomCommands {
public:
    explicit RandomCommands(unsigned seed) : random_(seed) {}

    std::string next()
    {
        const auto& operators = all_operators().operators();
        const Operator& op = operators[below(operators.size())];
        std::string text = op.name;
        for (const Parameter& p : op.parameters)
            if (p.type != Parameter::Type::file && (p.required || below(3) == 0)) text += " " + argument_text(p.name, value(p));
        return text;
    }

private:
    std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

    double number(const Range& range)
    {
        if (below(20) == 0) return 1e6 * (double(below(3)) - 1.0); // now and then what is not allowed
        const double low = std::max(range.min, -2.0), high = std::min(range.max, std::max(low + 1.0, 3.0));
        return low + (high - low) * double(below(9)) / 8.0;
    }

    std::string integer(const Range& range)
    {
        if (below(20) == 0) return std::to_string(below(1000000));
        const double low = std::isinf(range.min) ? 0.0 : range.min;
        return number_text(std::min(std::floor(low + double(below(4))), range.max));
    }

    std::string id() { return std::to_string(below(12)); }

    std::string selector(Parameter::Type type)
    {
        std::vector<std::string> choice{"all", "selected", "selected", "none", id(), id() + "," + id(), id() + "-" + id(), id() + "+" + id()};
        if (type == Parameter::Type::faces) choice.insert(choice.end(), {"group:1", "sides:4", "component:0", "normal:0,0,1,30", "sides:3+group:2"});
        if (type == Parameter::Type::edges) choice.push_back(id() + "~" + id());
        if (type == Parameter::Type::vertices) choice.push_back("valence:3");
        return choice[below(choice.size())];
    }

    template <class Piece>
    std::string list(const Parameter& p, Piece&& piece)
    {
        const double least = p.fixed_length > 0 ? p.fixed_length : std::max(1.0, p.domain.length.min);
        std::size_t length = static_cast<std::size_t>(std::isinf(least) ? 1.0 : least);
        if (p.fixed_length == 0 && length < p.domain.length.max) length += below(2);
        std::string text;
        for (std::size_t i = 0; i < length; ++i) text += (i > 0 ? "," : "") + piece();
        return text;
    }

    std::string value(const Parameter& p)
    {
        using Type = Parameter::Type;
        const std::vector<std::string>& words = p.domain.words;
        if (!words.empty() && (p.type == Type::word || below(2) == 0)) return words[below(words.size())];
        switch (p.type) {
        case Type::number: return number_text(number(p.domain.range));
        case Type::integer: return p.name == "iterations" || p.name == "level" ? std::to_string(1 + below(2)) : integer(p.domain.range); // some grow by 9 each
        case Type::toggle: return below(2) == 0 ? "true" : "false";
        case Type::numbers: return list(p, [&] { return number_text(number(p.domain.range)); });
        case Type::integers: return list(p, [&] { return integer(p.domain.range); });
        case Type::texts: return list(p, [&] { return id(); });
        case Type::point: return p.fixed_length == 2 ? fmt::format("{},{}", below(5), below(5)) : fmt::format("{},{},{}", below(5), below(5), below(5));
        case Type::colour: return "#12ab9f";
        case Type::faces:
        case Type::edges:
        case Type::vertices: return selector(p.type);
        case Type::id: return p.name == "edge" && below(2) == 0 ? id() + "~" + id() : id();
        case Type::corner: return id() + ":" + std::to_string(below(4));
        default: break;
        }
        static const char* const texts[] = {"cube", "prism:5", "a name", "x"};
        return texts[below(4)];
    }

    std::mt19937 random_;
};

class RandomSession : public testing::TestWithParam<unsigned> {};

TEST_P(RandomSession, StaysSoundAndComesBackByUndoAndByItsScript)
{
    constexpr std::uint32_t most_faces = 4000;
    Document document(all_operators());
    RandomCommands commands(GetParam());
    std::string told;
    SCOPED_TRACE(fmt::format("seed {}", GetParam()));
    for (int i = 0; i < 60; ++i) {
        const std::string command = i == 0 ? "make.cube" : commands.next();
        told += command + "\n";
        SCOPED_TRACE(told);
        run(document, command);
        ASSERT_SOUND(document.scene().mesh);
        expect_numbered_without_gaps(document.scene().mesh);
        if (document.scene().mesh.face_count() > most_faces) document.apply(document.history().done() > 0 ? "document.undo" : "document.clear");
        if (HasFailure()) return;
    }

    const std::size_t done = document.history().done();
    const State end(document);
    const std::string script = document.script({});
    document.apply("document.goto step=0");
    EXPECT_EQ(State(document), State());
    document.apply(fmt::format("document.goto step={}", done));
    EXPECT_EQ(State(document), end);

    Document again(all_operators());
    for (std::size_t from = 0; from < script.size();) {
        const std::size_t to = script.find('\n', from);
        ASSERT_EQ(complaint(again, script.substr(from, to - from)), "");
        from = to + 1;
    }
    EXPECT_EQ(State(again), end) << script;
}

INSTANTIATE_TEST_SUITE_P(Registry, RandomSession, testing::Range(0u, 40u));

} // namespace
} // namespace druse
