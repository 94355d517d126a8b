#pragma once

#include "dlfl/column.h"

#include <algorithm>
#include <cstdint>

namespace druse {

/// Calls f(i, old) for each element that was another one before, below the end that both states have; `now(i)` is what it is.
/// Precondition: the change holds pages, not a whole block. Cost: comparing the pages that were written to.
template <class T, class Now, class F>
void for_each_changed(const ColumnChange<T>& before, Now&& now, F&& f)
{
    std::size_t at = 0;
    for (const std::uint32_t page : before.pages) {
        const std::uint32_t first = page << Column<T>::page_bits, count = std::min(Column<T>::page_size, before.common - first);
        for (std::uint32_t k = 0; k < count; ++k)
            if (const T& old = before.contents[at + k]; old != now(first + k)) f(first + k, old);
        at += count;
    }
}

} // namespace druse
