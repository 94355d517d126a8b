#include "io/glb_file.h"

#include "dlfl/errors.h"
#include "io/glb_library.h"

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <unordered_map>

namespace druse {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are read as they lie in memory");

using nlohmann::json;

/// The container writes sizes in 32 bits; text may not be longer either.
constexpr std::uint64_t largest_file = 0xffffffff;
/// Descriptions are about ten levels deep; tinygltf walks through extras by recursion.
constexpr int deepest = 100;

struct Parts {
    std::string_view description, binary;
};

Parts take_apart(std::string_view file, const std::string& name)
{
    if (!file.starts_with("glTF")) return {file.substr(file.starts_with("\xEF\xBB\xBF") ? 3 : 0), {}};
    const auto number = [&](std::size_t at) {
        std::uint32_t value = 0;
        std::memcpy(&value, file.data() + at, sizeof value);
        return value;
    };
    if (file.size() < 12) throw InputError(name, "ends in its header");
    if (number(4) != 2) throw InputError(name, fmt::format("glTF version {}; expected 2", number(4)));
    if (number(8) > file.size())
        throw InputError(name, fmt::format("ends after {} bytes, its header promises {}", file.size(), number(8)));
    file = file.substr(0, std::max<std::size_t>(number(8), 12));

    Parts parts;
    std::size_t at = 12;
    for (int chunk = 0; at < file.size(); ++chunk) {
        constexpr std::uint32_t is_json = 0x4E4F534A, is_binary = 0x004E4942;
        if (file.size() - at < 8 || number(at) > file.size() - at - 8)
            throw InputError(name, fmt::format("the chunk at byte {} is longer than the file", at));
        const std::string_view content = file.substr(at + 8, number(at));
        const std::uint32_t type = number(at + 4);
        if (chunk == 0 && type != is_json) throw InputError(name, "the first chunk is no description");
        if (chunk == 0)
            parts.description = content;
        else if (chunk == 1 && type == is_binary)
            parts.binary = content;
        at += 8 + (content.size() + 3) / 4 * 4;
    }
    return parts;
}

json parse(std::string_view text, const std::string& name)
{
    static constexpr std::string_view wanted[] = {"asset",     "accessors", "buffers", "bufferViews", "extensionsRequired",
                                                  "materials", "meshes",    "nodes",   "scene",       "scenes"};
    const auto look = [&](int depth, json::parse_event_t event, json& parsed) {
        if (depth > deepest) throw InputError(name, fmt::format("lists in lists, more than {} deep", deepest));
        if (event != json::parse_event_t::key || depth != 1) return true;
        return std::find(std::begin(wanted), std::end(wanted), parsed.get_ref<const std::string&>()) != std::end(wanted);
    };
    try {
        json document = json::parse(text.begin(), text.end(), look);
        if (!document.is_object()) throw InputError(name, "is no glTF file: its description is no object of JSON");
        return document;
    } catch (const json::parse_error& error) {
        throw InputError(name, fmt::format("is no glTF file: its description is no JSON from byte {} on", error.byte));
    } catch (const json::exception&) {
        throw InputError(name, "is no glTF file: its description holds a number that is too large");
    }
}

/// %20 and the like; a percent sign without two digits stands for itself.
std::string decoded_uri(std::string_view uri)
{
    const auto digit = [](char c) {
        const char lower = static_cast<char>(c | 0x20);
        return c >= '0' && c <= '9' ? c - '0' : lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
    };
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0) {
            text += static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2]));
            i += 2;
        } else {
            text += uri[i];
        }
    }
    return text;
}

} // namespace

GlbFile::GlbFile(ByteSource& source)
{
    const auto keep = [&](std::vector<char> bytes) {
        kept_.push_back(std::move(bytes));
        return std::string_view(kept_.back().data(), kept_.back().size());
    };
    const Parts parts = take_apart(keep(source.read_all(largest_file)), source.name());
    json document = parse(parts.description, source.name());

    const json list = document.value("buffers", json::array());
    document.erase("buffers");
    std::unordered_map<std::string, std::string_view> files; // each is read once, however many buffers lie in it
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto fail = [&](const std::string& what) { throw InputError(source.name(), fmt::format("buffer {} {}", i, what)); };
        const json* const length =
            list.is_array() && list[i].is_object() && list[i].contains("byteLength") ? &list[i]["byteLength"] : nullptr;
        if (!length || !length->is_number_unsigned()) fail("has no byteLength");
        const json uri = list[i].value("uri", json());
        std::string_view bytes;
        if (uri.is_null()) {
            if (i > 0 || parts.binary.empty()) fail("has no data");
            bytes = parts.binary;
        } else if (!uri.is_string()) {
            fail("has no uri");
        } else if (const auto& text = uri.get_ref<const std::string&>(); text.starts_with("data:")) {
            std::vector<unsigned char> decoded;
            std::string type;
            if (!tinygltf::DecodeDataURI(&decoded, type, text, 0, false)) fail("is coded in an unknown way");
            bytes = keep(std::vector<char>(decoded.begin(), decoded.end()));
        } else if (const auto met = files.find(text); met != files.end()) {
            bytes = met->second;
        } else {
            const auto path = source.find_side_file(decoded_uri(text));
            if (!path) fail("lies in a file that is not there");
            ByteSource file = ByteSource::file(*path);
            bytes = files[text] = keep(file.read_all(largest_file));
            total += bytes.size();
            if (total > largest_file) fail(fmt::format("is too much: more than {} bytes in files", largest_file));
        }
        const auto promised = length->get<std::uint64_t>();
        if (promised > bytes.size()) fail(fmt::format("has {} bytes, its byteLength is {}", bytes.size(), promised));
        buffers_.push_back(bytes.substr(0, promised));
    }
    description_ = document.dump();
}

} // namespace druse
