#include "io/pane_file.h"

#include "dlfl/errors.h"
#include "pane/pane_record.h"

#include <cmath>
#include <string_view>

namespace druse {

namespace {

class PaneWriter {
public:
    explicit PaneWriter(ByteSink& sink) : sink_(sink) {}

    void write(const PaneRecord& pane)
    {
        sink_.put("{\"format\":\"druse-pane\",\n\"version\":1");
        key("points");
        list(pane.points);
        key("boundary");
        list(pane.boundary);
        key("constraints");
        list(pane.constraints);
        key("triangles");
        list(pane.triangles);
        key("ids");
        list(pane.ids);
        key("segments");
        list(pane.segments);
        key("locked");
        list(pane.locked);
        if (!pane.crossings.empty()) {
            key("crossings");
            list(pane.crossings);
        }
        if (!pane.refined.empty()) {
            key("refined");
            list(pane.refined);
        }
        key("snap");
        item(pane.snap);
        key("weld");
        item(pane.weld);
        key("next");
        list(std::array{pane.next_point, pane.next_segment});
        sink_.put("}\n");
    }

private:
    void key(std::string_view name)
    {
        sink_.put(",\n\"");
        sink_.put(name);
        sink_.put("\":");
    }

    void item(double x)
    {
        if (x == 0 && std::signbit(x)) sink_.put("-0.0"); // a reader may take -0 for a whole number, which has no sign then
        else sink_.put(x);
    }
    void item(PaneRecord::Number n) { sink_.put(std::uint64_t(n)); }
    void item(const Point2& p) { list(std::array{p.x, p.y}); }
    void item(const std::pair<PaneRecord::Number, std::vector<PaneRecord::Number>>& segment)
    {
        sink_.put('[');
        item(segment.first);
        sink_.put(',');
        list(segment.second);
        sink_.put(']');
    }
    template <class Items>
    void item(const Items& items)
    {
        list(items);
    }

    template <class Items>
    void list(const Items& items)
    {
        char before = '[';
        for (const auto& each : items) {
            sink_.put(before);
            item(each);
            before = ',';
        }
        if (before == '[') sink_.put('[');
        sink_.put(']');
    }

    ByteSink& sink_;
};

} // namespace

void write_pane(const ModelView& model, OutputFiles& out)
{
    if (!model.pane) throw InputError(out.name(), model.graph ? "the document holds a graph, not a pane" : "the document holds no pane to write");
    PaneWriter(out.main()).write(record(*model.pane));
}

} // namespace druse
