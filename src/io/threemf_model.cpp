#include "io/threemf_model.h"

#include "dlfl/errors.h"
#include "io/materials.h"
#include "io/limits.h"

#include <expat.h>
#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <exception>
#include <memory>
#include <set>
#include <string_view>
#include <type_traits>

namespace druse {

namespace {

constexpr std::uint64_t largest_package = std::uint64_t(1) << 31;
constexpr std::uint64_t largest_unpacked = std::uint64_t(1) << 30; // of all that is read of it
constexpr int deepest_part = 64;                                   // of elements in each other

constexpr std::string_view core_names = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02|";
constexpr std::string_view material_names = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02|";
constexpr std::string_view relationship_names = "http://schemas.openxmlformats.org/package/2006/relationships|";

/// The name of a part for an error: without bytes that a terminal would obey.
std::string shown(std::string part)
{
    constexpr std::size_t longest = 60;
    part.resize(std::min(part.size(), longest));
    for (char& c : part)
        if (c < ' ' || c > '~') c = '?';
    return part;
}

/// The files in a package.
class Package {
public:
    explicit Package(ByteSource& source) : source_(source), bytes_(source.read_all(largest_package))
    {
        zip_error_t error;
        zip_error_init(&error);
        zip_source_t* buffer = zip_source_buffer_create(bytes_.data(), bytes_.size(), 0, &error);
        if (buffer) zip_.reset(zip_open_from_source(buffer, ZIP_RDONLY, &error));
        if (buffer && !zip_) zip_source_free(buffer);
        zip_error_fini(&error);
        if (!zip_) throw InputError(source.name(), "is no 3MF file: it is no ZIP package");
    }

    bool has(const std::string& part) const { return find(part) >= 0; }

    /// Hands a part to `take` piece by piece.
    template <class F>
    void unpack(const std::string& part, F&& take)
    {
        const zip_int64_t index = find(part);
        const std::unique_ptr<zip_file_t, decltype(&zip_fclose)> file(index < 0 ? nullptr : zip_fopen_index(zip_.get(), static_cast<zip_uint64_t>(index), 0), &zip_fclose);
        if (!file) throw InputError(source_.name(), shown(part) + ": is not in the package, or cannot be unpacked");
        std::vector<char> piece(1u << 16);
        while (true) {
            const zip_int64_t count = zip_fread(file.get(), piece.data(), piece.size());
            if (count < 0) throw InputError(source_.name(), shown(part) + ": its package is damaged");
            unpacked_ += static_cast<std::uint64_t>(count);
            if (unpacked_ > largest_unpacked) throw InputError(source_.name(), fmt::format("unpacks to more than {} bytes", largest_unpacked));
            source_.read(nullptr, 0); // all is read, but a person may have enough
            take(std::string_view(piece.data(), static_cast<std::size_t>(count)), count == 0);
            if (count == 0) return;
        }
    }

private:
    zip_int64_t find(const std::string& part) const { return zip_name_locate(zip_.get(), part.c_str(), ZIP_FL_NOCASE); }

    ByteSource& source_;
    std::vector<char> bytes_;
    std::unique_ptr<zip_t, decltype(&zip_discard)> zip_{nullptr, &zip_discard};
    std::uint64_t unpacked_ = 0;
};

/// An element with what its tag says.
class Tag {
public:
    Tag(std::string_view name, const char** attributes) : name_(name), attributes_(attributes) {}
    /// Is it that one, of that part of the format?
    bool is(std::string_view space, std::string_view name) const { return name_.size() == space.size() + name.size() && name_.starts_with(space) && name_.ends_with(name); }
    /// Null if there is none. Names of other parts of the format count by what is behind the '|'.
    const char* find(std::string_view name) const
    {
        for (const char** a = attributes_; *a; a += 2) {
            const std::string_view its(*a);
            if (its == name || (its.ends_with(name) && its.size() > name.size() && its[its.size() - name.size() - 1] == '|')) return a[1];
        }
        return nullptr;
    }

private:
    std::string_view name_;
    const char** attributes_;
};

/// Goes through a part; what its elements say is taken by `open` and `close`.
class PartReader {
public:
    PartReader(ByteSource& source, Package& package, std::string part) : source_(source), package_(package), part_(std::move(part)) {}
    virtual ~PartReader() = default;
    PartReader(const PartReader&) = delete;
    PartReader& operator=(const PartReader&) = delete;

    void read()
    {
        parser_.reset(XML_ParserCreateNS(nullptr, '|'));
        if (!parser_) throw std::bad_alloc();
        XML_SetUserData(parser_.get(), this);
        XML_SetElementHandler(parser_.get(), &PartReader::start, &PartReader::end);
        XML_SetEntityDeclHandler(parser_.get(), &PartReader::declare);
        package_.unpack(part_, [this](std::string_view piece, bool is_last) {
            const XML_Status status = XML_Parse(parser_.get(), piece.data(), static_cast<int>(piece.size()), is_last);
            if (failure_) std::rethrow_exception(failure_);
            if (status != XML_STATUS_OK) fail(fmt::format("is no XML from here on: {}", XML_ErrorString(XML_GetErrorCode(parser_.get()))));
        });
    }

protected:
    virtual void open(const Tag& tag) = 0;

    const std::string& part() const { return part_; }
    [[noreturn]] void fail(const std::string& what) const
    {
        throw InputError(source_.name(), fmt::format("{}:{}: {}", shown(part_), XML_GetCurrentLineNumber(parser_.get()), what));
    }
    const char* require(const Tag& tag, const char* name) const
    {
        if (const char* value = tag.find(name)) return value;
        fail(fmt::format("{} is missing", name));
    }
    std::uint32_t number_of(const Tag& tag, const char* name) const { return count(require(tag, name), name); }
    std::uint32_t count(std::string_view text, const char* name) const
    {
        std::uint32_t value = 0;
        const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || stop != text.data() + text.size()) fail(fmt::format("{}: expected a whole number, 0 or above", name));
        return value;
    }
    double coordinate(const Tag& tag, const char* name) const
    {
        std::string_view text = require(tag, name);
        double value = 0;
        if (!take_number(text, value) || !text.empty()) fail(fmt::format("{}: expected a number", name));
        return value;
    }
    /// Takes one number off the front, with the blanks around it.
    bool take_number(std::string_view& text, double& value) const
    {
        const auto skip = [&] { text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size())); };
        skip();
        if (text.starts_with('+')) text.remove_prefix(1);
        const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc()) return false;
        if (!(std::abs(value) <= largest_coordinate)) fail(fmt::format("{}: expected at most {} in size", value, largest_coordinate));
        text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
        skip();
        return true;
    }

private:
    template <class F>
    static void guarded(void* self, F&& f) // exceptions do not go through the parser
    {
        auto* reader = static_cast<PartReader*>(self);
        if (reader->failure_) return;
        try {
            f(*reader);
        } catch (...) {
            reader->failure_ = std::current_exception();
            XML_StopParser(reader->parser_.get(), XML_FALSE);
        }
    }
    static void start(void* self, const char* name, const char** attributes)
    {
        guarded(self, [&](PartReader& reader) {
            if (++reader.depth_ > deepest_part) reader.fail(fmt::format("elements in elements, more than {} deep", deepest_part));
            reader.open(Tag(name, attributes));
        });
    }
    static void end(void* self, const char*)
    {
        guarded(self, [](PartReader& reader) {
            --reader.depth_;
        });
    }
    static void declare(void* self, const char*, int, const char*, int, const char*, const char*, const char*, const char*)
    {
        guarded(self, [](PartReader& reader) { reader.fail("declares entities, which 3MF has none of"); });
    }

    ByteSource& source_;
    Package& package_;
    std::string part_;
    std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser_{nullptr, &XML_ParserFree};
    int depth_ = 0;
    std::exception_ptr failure_;
};

/// Looks for the part that the package begins with.
class RootFinder : public PartReader {
public:
    RootFinder(ByteSource& source, Package& package) : PartReader(source, package, "_rels/.rels") {}
    std::string root = "3D/3dmodel.model";

protected:
    void open(const Tag& tag) override
    {
        if (!tag.is(relationship_names, "Relationship")) return;
        const char *type = tag.find("Type"), *target = tag.find("Target");
        if (!type || !target || !std::string_view(type).ends_with("/3dmodel")) return;
        root = target;
        root.erase(0, root.find_first_not_of('/'));
    }
};

class ModelReader : public PartReader {
public:
    ModelReader(ByteSource& source, Package& package, std::string part, bool is_root, ThreeMfModel& model)
        : PartReader(source, package, std::move(part)), is_root_(is_root), model_(model)
    {
    }
    std::set<std::string> others; // parts that have components of this one

protected:
    void open(const Tag& tag) override
    {
        if (tag.is(core_names, "vertex")) add_vertex(tag);
        else if (tag.is(core_names, "triangle")) add_triangle(tag);
        else if (tag.is(core_names, "object")) begin_object(tag);
        else if (tag.is(core_names, "component")) add_component(tag);
        else if (tag.is(core_names, "item")) add_item(tag);
        else if (tag.is(core_names, "basematerials") || tag.is(material_names, "colorgroup")) paints_ = &resources_[number_of(tag, "id")];
        else if (tag.is(core_names, "base")) add_paint(material_of(tag));
        else if (tag.is(material_names, "color")) add_paint({{}, colour_of(require(tag, "color")), {}});
        else if (tag.is(core_names, "model") && is_root_) model_.unit = unit_of(tag);
    }

private:
    void add_vertex(const Tag& tag) { object("vertex").points.emplace_back(coordinate(tag, "x"), coordinate(tag, "y"), coordinate(tag, "z")); }

    void add_triangle(const Tag& tag)
    {
        ThreeMfModel::Object& its = object("triangle");
        ThreeMfModel::Triangle t{{number_of(tag, "v1"), number_of(tag, "v2"), number_of(tag, "v3")}, object_paint_};
        for (const std::uint32_t p : t.points)
            if (p >= its.points.size()) fail(fmt::format("a triangle names vertex {}, its mesh has {}", p, its.points.size()));
        if (const char* first = tag.find("p1")) t.paint = paint(tag.find("pid") ? number_of(tag, "pid") : object_resource_, count(first, "p1"));
        its.triangles.push_back(t);
    }

    void begin_object(const Tag& tag)
    {
        const auto [at, is_new] = model_.objects.try_emplace({part(), number_of(tag, "id")});
        if (!is_new) fail(fmt::format("a second object {}", at->first.second));
        object_ = &at->second;
        object_resource_ = tag.find("pid") ? number_of(tag, "pid") : 0;
        object_paint_ = tag.find("pindex") ? paint(object_resource_, number_of(tag, "pindex")) : 0;
    }

    void add_component(const Tag& tag)
    {
        ThreeMfModel::Placed placed = place(tag);
        // Only what stands before can be a part of something, or what another file of the package has: nothing holds itself then.
        if (placed.object.first != part() && !is_root_) fail("a component in a third part");
        if (placed.object.first != part()) others.insert(placed.object.first);
        else if (!model_.objects.contains(placed.object) || &model_.objects.at(placed.object) == object_) fail(fmt::format("objectid {} is none before it", placed.object.second));
        object("component").components.push_back(std::move(placed));
    }

    void add_item(const Tag& tag)
    {
        if (!is_root_) return;
        ThreeMfModel::Placed placed = place(tag);
        if (placed.object.first != part()) others.insert(placed.object.first);
        model_.items.push_back(std::move(placed));
    }

    /// Rows of a transform are what it makes of the axes, and where it puts the origin.
    ThreeMfModel::Placed place(const Tag& tag) const
    {
        ThreeMfModel::Placed placed;
        placed.object = {part(), number_of(tag, "objectid")};
        if (const char* path = tag.find("path")) {
            placed.object.first = path;
            placed.object.first.erase(0, placed.object.first.find_first_not_of('/'));
        }
        if (const char* transform = tag.find("transform")) {
            std::string_view text(transform);
            for (int i = 0; i < 12; ++i) {
                double value = 0;
                if (!take_number(text, value)) fail("transform: expected 12 numbers");
                placed.place[i / 3][i % 3] = value;
            }
            if (!text.empty()) fail("transform: expected 12 numbers");
        }
        return placed;
    }

    void add_paint(NamedColour material)
    {
        if (!paints_) fail("a colour outside of a list of colours");
        model_.materials.push_back(std::move(material));
        paints_->push_back(static_cast<std::int32_t>(model_.materials.size()));
    }

    /// Of textures and what else may paint a triangle there is none.
    std::int32_t paint(std::uint32_t resource, std::uint32_t index) const
    {
        const auto list = resources_.find(resource);
        if (list == resources_.end()) return 0;
        if (index >= list->second.size()) fail(fmt::format("colour {} of resource {}, which has {}", index, resource, list->second.size()));
        return list->second[index];
    }

    NamedColour material_of(const Tag& tag) const
    {
        const std::string_view name = require(tag, "name");
        const std::size_t blank = std::min(name.find(' '), name.size());
        return {group_of_material(name.substr(0, blank)), colour_of(require(tag, "displaycolor")), std::string(name.substr(std::min(blank + 1, name.size())))};
    }

    /// `#RRGGBB`, or with an opacity behind.
    Colour colour_of(std::string_view text) const
    {
        std::uint32_t code = 0;
        const bool has_size = text.size() == 7 || text.size() == 9;
        if (has_size && text[0] == '#') {
            const auto [stop, error] = std::from_chars(text.data() + 1, text.data() + 7, code, 16);
            if (error == std::errc() && stop == text.data() + 7)
                return {static_cast<std::uint8_t>(code >> 16), static_cast<std::uint8_t>(code >> 8 & 255), static_cast<std::uint8_t>(code & 255)};
        }
        fail("expected a colour as #rrggbb");
    }

    double unit_of(const Tag& tag) const
    {
        const char* unit = tag.find("unit");
        if (!unit) return 1;
        constexpr std::pair<std::string_view, double> units[] = {{"millimeter", 1}, {"micron", 0.001}, {"centimeter", 10}, {"inch", 25.4}, {"foot", 304.8}, {"meter", 1000}};
        for (const auto& [name, millimetres] : units)
            if (name == unit) return millimetres;
        fail("unit: expected micron, millimeter, centimeter, inch, foot or meter");
    }

    ThreeMfModel::Object& object(const char* what) const
    {
        if (!object_) fail(fmt::format("a {} outside of an object", what));
        return *object_;
    }

    bool is_root_;
    ThreeMfModel& model_;
    ThreeMfModel::Object* object_ = nullptr;
    std::uint32_t object_resource_ = 0;
    std::int32_t object_paint_ = 0;
    std::map<std::uint32_t, std::vector<std::int32_t>> resources_; // numbers of paints
    std::vector<std::int32_t>* paints_ = nullptr;
};

} // namespace

ThreeMfModel read_3mf_model(ByteSource& source)
{
    Package package(source);
    RootFinder finder(source, package);
    if (package.has("_rels/.rels")) finder.read();
    ThreeMfModel model;
    ModelReader root(source, package, finder.root, true, model);
    root.read();
    for (const std::string& part : root.others) ModelReader(source, package, part, false, model).read();
    return model;
}

} // namespace druse
