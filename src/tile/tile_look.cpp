#include "tile/tile_look.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace druse {

namespace {

using LookJson = nlohmann::ordered_json;

LookJson kept_json(const TileDesign& design) { return design.kept.empty() ? LookJson::object() : LookJson::parse(design.kept); }

std::optional<TileTrace> trace_in(const LookJson& view)
{
    if (!view.contains("trace") || !view["trace"].is_object()) return {};
    const LookJson& j = view["trace"];
    TileTrace trace;
    if (!j.contains("image") || !j["image"].is_string()) return {};
    trace.image = j["image"].get<std::string>();
    if (j.contains("opacity") && j["opacity"].is_number()) trace.opacity = j["opacity"].get<double>();
    if (!j.contains("place")) return trace;
    const LookJson& place = j["place"];
    if (!place.is_array() || place.size() != trace.place.size()) return {};
    for (std::size_t i = 0; i < place.size(); ++i) {
        if (!place[i].is_number()) return {};
        trace.place[i] = place[i].get<double>();
    }
    return trace;
}

/// An object that is there already keeps its other keys, and their order.
LookJson& object_of(LookJson& parent, const char* key)
{
    LookJson& value = parent[key];
    if (!value.is_object()) value = LookJson::object();
    return value;
}

} // namespace

void check_trace(const TileTrace& trace)
{
    const auto& p = trace.place;
    for (const double x : p)
        if (!(std::abs(x) <= 1e100)) throw CommandError(fmt::format("place {}: numbers go to 1e100", x));
    if (!(std::abs(p[0] * p[4] - p[1] * p[3]) > 0)) throw CommandError("the picture would have no area");
}

TileLook look(const TileDesign& design)
{
    TileLook look;
    if (design.kept.find("\"view\"") == std::string::npos) return look; // as most have none
    const LookJson kept = kept_json(design);
    if (!kept.contains("view") || !kept["view"].is_object()) return look;
    const LookJson& view = kept["view"];
    look.trace = trace_in(view);
    if (view.contains("colors") && view["colors"].is_array() && view["colors"].size() == look.colours.size())
        for (std::size_t i = 0; i < look.colours.size(); ++i)
            if (const LookJson& j = view["colors"][i]; j.is_string()) look.colours[i] = colour_from_hex(j.get<std::string>()).value_or(look.colours[i]);
    return look;
}

LayeredTile with_look(const LayeredTile& tile, const TileLook& look)
{
    if (look.trace) check_trace(*look.trace);
    TileDesign design = tile.design();
    LookJson kept = kept_json(design);
    LookJson& view = object_of(kept, "view");
    if (look.trace) {
        LookJson& trace = object_of(view, "trace");
        trace["image"] = look.trace->image;
        trace["place"] = look.trace->place;
        trace["opacity"] = look.trace->opacity;
    } else {
        view.erase("trace");
    }
    if (look.colours != TileLook().colours || view.contains("colors")) {
        LookJson& colours = view["colors"] = LookJson::array();
        for (const Colour c : look.colours) colours.push_back(to_hex(c));
    }
    if (view.empty()) kept.erase("view");
    design.kept = kept.empty() ? std::string() : kept.dump();
    return LayeredTile(std::move(design));
}

} // namespace druse
