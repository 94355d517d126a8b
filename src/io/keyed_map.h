#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace druse {

/// What an object of JSON is kept in: keys in the order in which they came, as in nlohmann::ordered_map, which looks at all of them for each that is asked
/// for. Here a table of places is laid once there are many, so that an object with a key for each point of a tile takes linear time.
template <class Key, class T, class Ignored = std::less<Key>, class Allocator = std::allocator<std::pair<const Key, T>>>
class KeyedMap : public nlohmann::ordered_map<Key, T, Ignored, Allocator> {
    using Base = nlohmann::ordered_map<Key, T, Ignored, Allocator>;

public:
    using typename Base::const_iterator;
    using typename Base::iterator;
    using typename Base::size_type;
    using typename Base::value_type;
    using key_compare = std::equal_to<Key>; // other types become a Key before they are looked for

    using Base::Base;
    KeyedMap() = default;
    /// Of several with one key the first counts.
    template <class It>
    KeyedMap(It first, It last, const Allocator& allocator = Allocator()) : Base(allocator)
    {
        insert(first, last);
    }

    std::pair<iterator, bool> emplace(const Key& key, T&& value)
    {
        if (const iterator found = find(key); found != this->end()) return {found, false};
        Base::Container::emplace_back(key, std::move(value));
        note(this->size() - 1);
        return {std::prev(this->end()), true};
    }
    std::pair<iterator, bool> emplace(const Key& key, const T& value) { return emplace(key, T(value)); }
    std::pair<iterator, bool> insert(value_type&& value) { return emplace(value.first, std::move(value.second)); }
    std::pair<iterator, bool> insert(const value_type& value) { return emplace(value.first, T(value.second)); }
    template <class It>
    void insert(It first, It last)
    {
        for (; first != last; ++first) insert(*first);
    }

    T& operator[](const Key& key) { return emplace(key, T()).first->second; }
    iterator find(const Key& key) { return this->begin() + static_cast<std::ptrdiff_t>(place(key)); }
    const_iterator find(const Key& key) const { return this->begin() + static_cast<std::ptrdiff_t>(place(key)); }
    size_type count(const Key& key) const { return place(key) < this->size() ? 1 : 0; }

    size_type erase(const Key& key)
    {
        const iterator found = find(key);
        if (found == this->end()) return 0;
        erase(found);
        return 1;
    }
    iterator erase(iterator at) { return erase(at, std::next(at)); }
    iterator erase(iterator first, iterator last)
    {
        table_.clear();
        return Base::erase(first, last);
    }
    void clear()
    {
        table_.clear();
        Base::clear();
    }

private:
    static constexpr std::size_t few = 16; // are looked through

    /// Where a key is, or size().
    std::size_t place(const Key& key) const
    {
        if (table_.empty()) {
            std::size_t i = 0;
            while (i < this->size() && this->data()[i].first != key) ++i;
            return i;
        }
        for (std::size_t slot = std::hash<Key>()(key);; ++slot) {
            const std::uint32_t at = table_[slot & (table_.size() - 1)];
            if (at == 0) return this->size();
            if (this->data()[at - 1].first == key) return at - 1;
        }
    }

    /// The last item is new: the table knows it too, or is laid anew for all, with room for as many again.
    void note(std::size_t last)
    {
        if (this->size() <= few) return;
        if (2 * this->size() > table_.size()) {
            std::size_t slots = 4 * few;
            while (slots < 4 * this->size()) slots *= 2;
            table_.assign(slots, 0);
            for (std::size_t i = 0; i < last; ++i) put(i);
        }
        put(last);
    }

    void put(std::size_t i)
    {
        std::size_t slot = std::hash<Key>()(this->data()[i].first);
        while (table_[slot & (table_.size() - 1)] != 0) ++slot;
        table_[slot & (table_.size() - 1)] = static_cast<std::uint32_t>(i + 1);
    }

    std::vector<std::uint32_t> table_; // places + 1, by hash; a power of two, at most half of it taken; or empty
};

} // namespace druse
