#include "ui/pictures.h"

#include "ui/pattern.h"

#include "dlfl/errors.h"
#include "ops/solid.h"

#include <array>
#include <chrono>

namespace druse::ui {

namespace {

constexpr double at_once = 0.001, later = 0.2; // seconds
constexpr std::chrono::milliseconds at_a_time{20};

} // namespace

Fl_RGB_Image* Pictures::find(const Operator& op, const std::string& solid, int size)
{
    if (!solid.empty() && solid_parameter(op) && !solid_parameter(op)->names_file(solid)) return find(solid, size);
    return find({op.name, size}, [&op, solid] { return pattern_of(op, solid); });
}

Fl_RGB_Image* Pictures::find(const std::string& solid, int size)
{
    return find({"solid " + solid, size}, [solid]() -> std::optional<Mesh> {
        try {
            return make_solid(solid, 1.0);
        } catch (const CommandError&) {
            return {};
        }
    });
}

Fl_RGB_Image* Pictures::find(Key key, std::function<std::optional<Mesh>()> solid)
{
    if (hopeless_) return nullptr;
    const auto [place, is_new] = pictures_.try_emplace(key);
    if (is_new) {
        wanted_.push_back({std::move(key), std::move(solid)});
        if (!timer_.is_running()) timer_.start(at_once);
    }
    return place->second.image.get();
}

void Pictures::draw_some()
{
    const auto start = std::chrono::steady_clock::now();
    bool some = false;
    try {
        while (!wanted_.empty() && std::chrono::steady_clock::now() - start < at_a_time) {
            const Wanted& next = wanted_.front();
            if (const std::optional<Mesh> solid = next.solid()) {
                std::optional<Image> image = painter_(*solid, next.key.second);
                if (!image) { // there is no context yet
                    timer_.start(later);
                    return;
                }
                Picture& picture = pictures_[next.key];
                picture.pixels = std::move(*image);
                picture.image = std::make_unique<Fl_RGB_Image>(reinterpret_cast<const unsigned char*>(picture.pixels.pixels.data()), picture.pixels.width,
                                                               picture.pixels.height, int(sizeof(Pixel)));
                some = true;
            }
            wanted_.pop_front();
        }
    } catch (const SystemError&) {
        hopeless_ = true;
        wanted_.clear();
    }
    if (!wanted_.empty()) timer_.start(at_once);
    if (some && on_ready) on_ready();
}

Image shrunk(const Image& image, int factor)
{
    Image small(image.width / factor, image.height / factor);
    const int count = factor * factor;
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            std::array<int, 3> colour{}; // weighted by alpha
            int alpha = 0;
            for (int j = 0; j < factor; ++j)
                for (int i = 0; i < factor; ++i) {
                    const Pixel& p = image.at(x * factor + i, y * factor + j);
                    colour[0] += p.red * p.alpha;
                    colour[1] += p.green * p.alpha;
                    colour[2] += p.blue * p.alpha;
                    alpha += p.alpha;
                }
            if (alpha == 0) {
                small.at(x, y) = {0, 0, 0, 0};
                continue;
            }
            const auto mean = [alpha](int sum) { return static_cast<std::uint8_t>((sum + alpha / 2) / alpha); };
            small.at(x, y) = {mean(colour[0]), mean(colour[1]), mean(colour[2]), static_cast<std::uint8_t>((alpha + count / 2) / count)};
        }
    return small;
}

} // namespace druse::ui
