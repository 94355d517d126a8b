#include "io/ply.h"

#include "dlfl/errors.h"
#include "dlfl/mesh_builder.h"
#include "io/build_mesh.h"
#include "io/face_colours.h"
#include "io/limits.h"
#include "io/ply_header.h"
#include "io/ply_values.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace druse {

namespace {

/// What the properties of an element mean: one step each, in their order.
struct Step {
    static constexpr int passed_over = -1, corners = -2;
    PlyType type;
    std::optional<PlyType> length;
    int meaning; // or the place of the value among those wanted
};

class PlyReader {
public:
    explicit PlyReader(ByteSource& source) : source_(source), header_(read_ply_header(source)) {}
    Model read();

private:
    void understand();
    std::vector<Step> steps(const PlyElement& element, std::span<const std::string_view> wanted) const;

    template <class Values> void elements(Values&& in);
    template <class Values> void vertices(Values& in, const PlyElement& element);
    template <class Values> void faces(Values& in, const PlyElement& element);
    template <class Values> void others(Values& in, const PlyElement& element);
    template <class Values> std::uint64_t length(Values& in, PlyType type);
    template <class Values> void corners(Values& in, const Step& step);
    template <class Values> double channel(Values& in, PlyType type, double value);

    void make_groups(Model& model);

    ByteSource& source_;
    PlyHeader header_;
    MeshBuilder builder_;
    std::vector<std::string> notes_;

    std::uint64_t vertex_count_ = 0;
    std::vector<Step> vertex_steps_, face_steps_;
    bool has_groups_ = false, has_face_colours_ = false, has_vertex_colours_ = false;
    std::array<PlyType, 3> face_colour_types_{}, vertex_colour_types_{};

    ColourNumbers colours_;               // of faces, without groups
    std::map<int, Colour> group_colours_; // of the first face of each
    Column<Vector> vertex_colours_;
};

constexpr std::array<std::string_view, 6> vertex_values = {"x", "y", "z", "red", "green", "blue"};
constexpr std::array<std::string_view, 4> face_values = {"group", "red", "green", "blue"};

std::vector<Step> PlyReader::steps(const PlyElement& element, std::span<const std::string_view> wanted) const
{
    std::vector<Step> steps;
    std::vector<bool> found(wanted.size(), false);
    bool has_corners = false;
    for (const PlyProperty& property : element.properties) {
        Step step{property.type, property.length, Step::passed_over};
        if (property.length) {
            if (!has_corners && (property.name == "vertex_indices" || property.name == "vertex_index")) {
                step.meaning = Step::corners;
                has_corners = true;
            }
        } else {
            for (std::size_t i = 0; i < wanted.size(); ++i)
                if (!found[i] && property.name == wanted[i]) {
                    step.meaning = static_cast<int>(i);
                    found[i] = true;
                    break;
                }
        }
        steps.push_back(step);
    }
    return steps;
}

/// Finds what the properties mean, and whether all that is needed is there.
void PlyReader::understand()
{
    const auto find = [](const std::vector<Step>& steps, int meaning) -> const Step* {
        for (const Step& step : steps)
            if (step.meaning == meaning) return &step;
        return nullptr;
    };
    const auto colour_types = [&](const std::vector<Step>& steps, int first, std::array<PlyType, 3>& types) {
        for (int i = 0; i < 3; ++i) {
            const Step* const step = find(steps, first + i);
            if (!step) return false;
            types[static_cast<std::size_t>(i)] = step->type;
        }
        return true;
    };
    std::uint64_t face_count = 0;
    for (const PlyElement& element : header_.elements) {
        if (element.name == "vertex") {
            vertex_count_ = element.count;
            vertex_steps_ = steps(element, vertex_values);
            for (int i = 0; i < 3; ++i)
                if (!find(vertex_steps_, i)) throw InputError(source_.name(), "has vertices without x, y and z");
            has_vertex_colours_ = colour_types(vertex_steps_, 3, vertex_colour_types_);
        } else if (element.name == "face") {
            face_count = element.count;
            face_steps_ = steps(element, face_values);
            if (!find(face_steps_, Step::corners)) throw InputError(source_.name(), "has faces without a list of vertex_indices");
            has_groups_ = find(face_steps_, 0);
            has_face_colours_ = colour_types(face_steps_, 1, face_colour_types_);
        }
    }
    if (face_count == 0) throw InputError(source_.name(), "holds no faces");
    has_vertex_colours_ = has_vertex_colours_ && !has_groups_ && !has_face_colours_;
}

template <class Values> std::uint64_t PlyReader::length(Values& in, PlyType type)
{
    const double value = in.number(type);
    if (!(value >= 0 && value <= double(most_elements) && value == std::trunc(value)))
        in.fail(fmt::format("a list of {} values; expected 0 to {}", value, most_elements));
    return static_cast<std::uint64_t>(value);
}

template <class Values> void PlyReader::corners(Values& in, const Step& step)
{
    const std::uint64_t count = length(in, *step.length);
    if (count == 0 || count == 2) in.fail(fmt::format("a face with {} corners; expected at least 3", count));
    if (builder_.corner_count() + count > most_elements) in.fail(fmt::format("more than {} corners", most_elements));
    for (std::uint64_t i = 0; i < count; ++i) {
        const double value = in.number(step.type);
        if (!(value >= 0 && value < double(vertex_count_) && value == std::trunc(value)))
            in.fail(fmt::format("face names vertex {}, the file has {}", value, vertex_count_));
        builder_.add_corner(static_cast<std::uint32_t>(value));
    }
}

/// A channel of a colour as 0 to 1.
template <class Values> double PlyReader::channel(Values& in, PlyType type, double value)
{
    const double most = type >= PlyType::float32 ? 1 : type == PlyType::uint16 ? 65535 : 255;
    if (!(value >= 0 && value <= most)) in.fail(fmt::format("colour {}: expected 0 to {}", value, most));
    return value / most;
}

template <class Values> void PlyReader::vertices(Values& in, const PlyElement& element)
{
    std::array<double, vertex_values.size()> value{};
    for (std::uint64_t i = 0; i < element.count; ++i) {
        in.next(element.name, i + 1, element.count);
        for (const Step& step : vertex_steps_)
            if (step.meaning >= 0)
                value[static_cast<std::size_t>(step.meaning)] = in.number(step.type);
            else
                in.pass_over(step.type, step.length ? length(in, *step.length) : 1);
        in.end();
        for (std::size_t k = 0; k < 3; ++k)
            if (!(std::abs(value[k]) <= largest_coordinate))
                in.fail(fmt::format("coordinate {}: expected at most {} in size", value[k], largest_coordinate));
        builder_.add_vertex({value[0], value[1], value[2]});
        if (has_vertex_colours_) {
            Vector colour;
            for (int k = 0; k < 3; ++k)
                colour[k] =
                    channel(in, vertex_colour_types_[static_cast<std::size_t>(k)], value[static_cast<std::size_t>(3 + k)]);
            vertex_colours_.push_back(colour);
        }
    }
}

template <class Values> void PlyReader::faces(Values& in, const PlyElement& element)
{
    std::array<double, face_values.size()> value{};
    int last_group = -1;
    for (std::uint64_t i = 0; i < element.count; ++i) {
        in.next(element.name, i + 1, element.count);
        for (const Step& step : face_steps_)
            if (step.meaning >= 0)
                value[static_cast<std::size_t>(step.meaning)] = in.number(step.type);
            else if (step.meaning == Step::corners)
                corners(in, step);
            else
                in.pass_over(step.type, step.length ? length(in, *step.length) : 1);
        in.end();
        int group = 0;
        Colour colour;
        if (has_face_colours_) {
            double rgb[3];
            for (std::size_t k = 0; k < 3; ++k) rgb[k] = channel(in, face_colour_types_[k], value[1 + k]);
            colour = colour_from_unit(rgb[0], rgb[1], rgb[2]);
            if (!has_groups_) group = colours_.number(colour);
        }
        if (has_groups_) {
            if (!(value[0] >= 0 && value[0] <= std::numeric_limits<int>::max() && value[0] == std::trunc(value[0])))
                in.fail(fmt::format("there is no group {}", value[0]));
            group = static_cast<int>(value[0]);
            if (has_face_colours_ && group != last_group) group_colours_.try_emplace(group, colour);
            last_group = group;
        }
        builder_.end_face(group);
    }
}

template <class Values> void PlyReader::others(Values& in, const PlyElement& element)
{
    if (element.properties.empty()) return;
    for (std::uint64_t i = 0; i < element.count; ++i) {
        in.next(element.name, i + 1, element.count);
        for (const PlyProperty& property : element.properties)
            in.pass_over(property.type, property.length ? length(in, *property.length) : 1);
        in.end();
    }
}

template <class Values> void PlyReader::elements(Values&& in)
{
    for (const PlyElement& element : header_.elements) {
        if (element.name == "vertex")
            vertices(in, element);
        else if (element.name == "face")
            faces(in, element);
        else
            others(in, element);
    }
    if (in.has_more()) notes_.push_back("there is more after the last element: passed over");
}

void PlyReader::make_groups(Model& model)
{
    if (has_groups_) {
        // Our own writer gives every group a colour; the one that it would have anyway is not its own.
        for (const auto& [id, colour] : group_colours_)
            if (colour != GroupTable::default_colour(id)) model.groups.set_colour(id, colour);
        for (auto& [id, name] : header_.group_names) model.groups.set_name(id, std::move(name));
    } else if (has_face_colours_) {
        int id = 0;
        for (const Colour colour : colours_.colours()) model.groups.set_colour(++id, colour);
    } else if (has_vertex_colours_) {
        groups_from_vertex_colours(builder_.corners(), builder_.face_ends(), vertex_colours_.view(), builder_.groups(),
                                   model.groups);
    }
}

Model PlyReader::read()
{
    understand();
    if (header_.encoding == PlyEncoding::ascii)
        elements(PlyText(source_, header_));
    else
        elements(PlyBytes(source_, header_));
    Model model;
    model.notes = std::move(notes_);
    make_groups(model);
    build_mesh(builder_, source_, model);
    return model;
}

} // namespace

Model read_ply(ByteSource& source)
{
    return PlyReader(source).read();
}

} // namespace druse
