#pragma once

#include "render/draw_lists.h"

#include <cstdint>
#include <unordered_map>

namespace druse {

/// Colours of groups as DrawVertex::look has them, asked for once each.
class Palette {
public:
    explicit Palette(const GroupColours& colours) : colours_(colours) {}

    std::uint32_t operator()(int group)
    {
        if (group != last_group_) {
            const auto [found, fresh] = packed_.try_emplace(group, 0u);
            if (fresh) {
                const Colour c = colours_(group);
                found->second = c.red | std::uint32_t(c.green) << 8 | std::uint32_t(c.blue) << 16;
            }
            last_group_ = group;
            last_ = found->second;
        }
        return last_;
    }

private:
    const GroupColours& colours_;
    std::unordered_map<int, std::uint32_t> packed_;
    int last_group_ = -1;
    std::uint32_t last_ = 0;
};

} // namespace druse
