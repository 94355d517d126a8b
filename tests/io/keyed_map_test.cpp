// Objects of JSON that keep their order and find their keys by a table.
#include "io/keyed_map.h"

#include <gtest/gtest.h>

#include <string>

namespace druse {
namespace {

using KeyedJson = nlohmann::basic_json<KeyedMap>;

KeyedJson numbered(int count)
{
    KeyedJson j = KeyedJson::object();
    for (int i = 0; i < count; ++i) j["i" + std::to_string(i)] = i;
    return j;
}

TEST(KeyedMap, KeepsTheOrderOfKeysAndFindsEach)
{
    for (const int count : {0, 1, 16, 17, 18, 33, 5000}) {
        const KeyedJson j = numbered(count);
        ASSERT_EQ(j.size(), std::size_t(count));
        int i = 0;
        for (const auto& [key, value] : j.items()) {
            EXPECT_EQ(value, i);
            EXPECT_EQ(key, "i" + std::to_string(i++));
        }
        for (i = 0; i < count; ++i) ASSERT_EQ(j["i" + std::to_string(i)], i);
        EXPECT_FALSE(j.contains("i" + std::to_string(count)));
        EXPECT_EQ(KeyedJson::parse(j.dump()), j);
    }
}

TEST(KeyedMap, FindsWhatIsThereAfterKeysAreTakenAway)
{
    KeyedJson j = numbered(100);
    const KeyedJson before = j;
    for (int i = 0; i < 100; i += 2) EXPECT_EQ(j.erase("i" + std::to_string(i)), 1u);
    EXPECT_EQ(j.erase("i0"), 0u);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(j.contains("i" + std::to_string(i)), i % 2 == 1) << i;
    j["i0"] = "again";
    EXPECT_EQ(j.size(), 51u);
    EXPECT_EQ(std::prev(j.end()).key(), "i0");
    EXPECT_EQ(before.size(), 100u);
    KeyedJson moved = std::move(j);
    EXPECT_EQ(moved["i0"], "again");
    moved.clear();
    EXPECT_FALSE(moved.contains("i1"));
    moved["i1"] = 1;
    EXPECT_EQ(moved.size(), 1u);
}

TEST(KeyedMap, HasOneValueForAKeyThatIsGivenTwice)
{
    EXPECT_EQ(KeyedJson::parse(R"({"a": 1, "b": 2, "a": 3})").dump(), R"({"a":3,"b":2})");
}

} // namespace
} // namespace druse
