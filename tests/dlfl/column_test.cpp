// The journal of a column against a naive copy of every state.
#include "dlfl/column.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace druse {
namespace {

using Values = std::vector<std::uint64_t>;
using Numbers = Column<std::uint64_t>;

constexpr std::uint32_t page = Numbers::page_size;

Values values(const Numbers& column) { return {column.view().begin(), column.view().end()}; }

Numbers counting(std::uint32_t n)
{
    Numbers column;
    for (std::uint32_t i = 0; i < n; ++i) column.push_back(i);
    return column;
}

/// A column and the copy that says what it should hold.
struct Pair {
    Numbers column;
    Values copy;
};

void change_at_random(Pair& p, std::mt19937& random, bool replacing)
{
    const auto below = [&random](std::size_t n) { return static_cast<std::uint32_t>(random() % n); };
    const std::uint32_t size = p.column.size();
    switch (below(replacing ? 8 : 7)) {
    case 0: {
        if (size == 0) return;
        const std::uint32_t i = below(size), value = static_cast<std::uint32_t>(random());
        p.column.set(i, value);
        p.copy[i] = value;
        return;
    }
    case 1: {
        if (size == 0) return;
        const std::uint32_t first = below(size), count = below(size - first + 1);
        std::uint64_t* out = p.column.write(first, count);
        for (std::uint32_t i = 0; i < count; ++i) p.copy[first + i] = out[i] = random();
        return;
    }
    case 2:
        for (std::uint32_t i = below(200); i > 0; --i) {
            p.copy.push_back(i);
            p.column.push_back(i);
        }
        return;
    case 3: {
        const std::uint32_t count = below(2 * page);
        std::uint64_t* out = p.column.extend(count);
        for (std::uint32_t i = 0; i < count; ++i) p.copy.push_back(out[i] = random());
        return;
    }
    case 4: {
        const std::uint32_t count = size - below(std::min(size, 3 * page) + 1);
        p.column.truncate(count);
        p.copy.resize(count);
        return;
    }
    case 5: // twice in a row over the same place: short, then long again with other values
        p.column.truncate(size / 2);
        p.copy.resize(size / 2);
        for (std::uint32_t i = size / 2; i < size; ++i) {
            p.column.push_back(~std::uint64_t(i));
            p.copy.push_back(~std::uint64_t(i));
        }
        return;
    case 6: p.column.reserve(below(8 * page)); return;
    case 7: {
        Pair other;
        for (std::uint32_t i = below(3 * page); i > 0; --i) {
            other.column.push_back(random());
            other.copy.push_back(other.column[other.column.size() - 1]);
        }
        p.column.replace(std::move(other.column));
        p.copy = other.copy;
        return;
    }
    }
}

class RandomChanges : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Seeds, RandomChanges, testing::Range(0, 60));

TEST_P(RandomChanges, LeadBackAndForthToExactlyEachState)
{
    std::mt19937 random(static_cast<unsigned>(GetParam()));
    Pair p;
    std::vector<Values> states;
    std::vector<ColumnChange<std::uint64_t>> changes;
    for (int i = 0; i < 5; ++i) change_at_random(p, random, true); // not recorded
    states.push_back(p.copy);
    for (int step = 0; step < 12; ++step) {
        p.column.begin_change();
        for (int i = 0; i < 1 + step % 6; ++i) {
            change_at_random(p, random, GetParam() % 2 == 0);
            ASSERT_EQ(values(p.column), p.copy);
        }
        changes.push_back(p.column.end_change());
        states.push_back(p.copy);
    }
    std::size_t at = changes.size();
    for (int move = 0; move < 80; ++move) {
        if (at > 0 && (at == changes.size() || random() % 2 == 0)) p.column.exchange(changes[--at]);
        else p.column.exchange(changes[at++]);
        ASSERT_EQ(values(p.column), states[at]) << "state " << at;
    }
}

TEST_P(RandomChanges, AreGoneAfterRollBack)
{
    std::mt19937 random(static_cast<unsigned>(GetParam()) + 1000);
    Pair p;
    for (int i = 0; i < 6; ++i) change_at_random(p, random, true);
    for (int round = 0; round < 10; ++round) {
        const Values before = p.copy;
        p.column.begin_change();
        for (int i = 0; i < 4; ++i) change_at_random(p, random, GetParam() % 2 == 0);
        p.column.roll_back();
        ASSERT_EQ(values(p.column), before);
        ASSERT_FALSE(p.column.is_recording());
        p.copy = before;
        change_at_random(p, random, true);
    }
}

TEST(Column, KeepsOnlyTheTouchedPages)
{
    Numbers column = counting(100 * page);
    column.begin_change();
    column.set(7 * page + 3, 0);
    column.set(7 * page + 4, 0);
    const auto change = column.end_change();
    EXPECT_EQ(change.pages, std::vector<std::uint32_t>{7});
    EXPECT_LT(change.bytes(), 2 * page * sizeof(std::uint64_t));
}

TEST(Column, KeepsNothingOfWhatIsAppended)
{
    Numbers column = counting(100 * page);
    column.begin_change();
    column.extend(1000 * page);
    EXPECT_EQ(column.end_change().bytes(), 0u);
}

TEST(Column, TakesAnElementOfItsOwnWhereItHasToMove)
{
    Numbers column = counting(3);
    for (std::uint32_t i = 0; i < 10 * page; ++i) column.push_back(column[1]);
    for (std::uint32_t i = 3; i < column.size(); ++i) ASSERT_EQ(column[i], 1u);
}

TEST(Column, KeepsItsValuesWhereverTheyMoveWhileItGrows)
{
    Numbers column; // through small blocks, the first mapped one, and mapped ones that are moved
    for (std::uint32_t i = 0; i < 3'000'000; ++i) column.push_back(i);
    for (std::uint32_t i = 0; i < column.size(); ++i) ASSERT_EQ(column[i], i);
}

TEST(Column, RecordsAnAssignmentLikeAnyOtherChange)
{
    for (const bool by_copy : {true, false}) {
        Numbers column = counting(5), other = counting(3000);
        other.set(0, 77);
        column.begin_change();
        column.set(2, 9);
        if (by_copy) column = other;
        else column = std::move(other);
        EXPECT_EQ(column.size(), 3000u);
        auto change = column.end_change();
        column.exchange(change);
        EXPECT_EQ(values(column), (Values{0, 1, 2, 3, 4}));
        column.exchange(change);
        EXPECT_EQ(column.size(), 3000u);
        EXPECT_EQ(column[0], 77u);
    }
}

TEST(Column, RecordsInTheCopyNothing)
{
    Numbers column = counting(5);
    column.begin_change();
    Numbers copy = column;
    EXPECT_FALSE(copy.is_recording());
    copy.set(0, 9);
    EXPECT_EQ(column[0], 0u);
    EXPECT_TRUE(column.end_change().pages.empty());
}

TEST(Column, RefusesMoreElementsThanHandlesCanName)
{
    Numbers column = counting(5);
    EXPECT_THROW(column.extend(0xfffffffeu), std::bad_alloc);
    EXPECT_EQ(values(column), (Values{0, 1, 2, 3, 4}));
}

TEST(Column, IsEmptyAfterItWasMovedFrom)
{
    Numbers column = counting(5);
    const Numbers taken = std::move(column);
    EXPECT_EQ(taken.size(), 5u);
    EXPECT_EQ(column.size(), 0u); // NOLINT: that is the point
    column.push_back(1);
    EXPECT_EQ(values(column), Values{1});
}

} // namespace
} // namespace druse
