#pragma once

#include <algorithm>
#include <vector>

namespace druse {

/// Sorts a list and leaves one of each value.
template <class T>
void sort_unique(std::vector<T>& list)
{
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

} // namespace druse
