#include "dlfl/storage.h"

#include <gtest/gtest.h>

#include <cstring>
#include <thread>
#include <utility>
#include <vector>

namespace druse {
namespace {

constexpr std::size_t megabyte = std::size_t(1) << 20;

void fill(Storage& block, std::size_t from, std::size_t to)
{
    for (std::size_t i = from; i < to; i += 4096) block.data()[i] = std::byte(i / 4096 % 251);
}

bool is_filled(const Storage& block, std::size_t to)
{
    for (std::size_t i = 0; i < to; i += 4096)
        if (block.data()[i] != std::byte(i / 4096 % 251)) return false;
    return true;
}

TEST(Storage, KeepsItsContentsWhileItGrows)
{
    Storage block;
    std::size_t filled = 0;
    for (const std::size_t bytes : {std::size_t(4096), megabyte - 4096, megabyte, 3 * megabyte, 40 * megabyte, 41 * megabyte}) {
        block.reserve(bytes);
        ASSERT_GE(block.capacity(), bytes);
        fill(block, filled, bytes);
        filled = bytes;
        EXPECT_TRUE(is_filled(block, filled)) << bytes;
    }
}

TEST(Storage, GrowsIntoMemoryThatAnotherBlockLeftBehind)
{
    Storage large;
    large.reserve(64 * megabyte);
    std::memset(large.data(), 255, large.capacity());
    Storage grows;
    grows.reserve(8 * megabyte);
    fill(grows, 0, 8 * megabyte);
    large = Storage();
    grows.reserve(48 * megabyte);
    EXPECT_TRUE(is_filled(grows, 8 * megabyte));
}

TEST(Storage, CapacityDoesNotDependOnWhatWasThereBefore)
{
    const auto capacity = [] {
        Storage block;
        block.reserve(20 * megabyte + 1);
        return block.capacity();
    };
    const std::size_t fresh = capacity();
    {
        Storage larger;
        larger.reserve(37 * megabyte);
    }
    for (int again = 0; again < 4; ++again) EXPECT_EQ(capacity(), fresh);
}

TEST(Storage, AMovedBlockLeavesNothing)
{
    Storage from;
    from.reserve(2 * megabyte);
    fill(from, 0, 2 * megabyte);
    const std::byte* const data = from.data();
    Storage to = std::move(from);
    EXPECT_EQ(to.data(), data);
    EXPECT_EQ(from.capacity(), 0u); // NOLINT: what is left is part of the promise
    EXPECT_TRUE(is_filled(to, 2 * megabyte));
}

TEST(Storage, BlocksComeAndGoOnSeveralThreads)
{
    std::vector<std::thread> threads;
    std::vector<int> wrong(4, 0);
    for (std::size_t t = 0; t < wrong.size(); ++t)
        threads.emplace_back([&wrong, t] {
            for (std::size_t k = 0; k < 200; ++k) {
                Storage block;
                const std::size_t bytes = (1 + (k * 7 + t * 3) % 9) * megabyte;
                block.reserve(bytes);
                std::byte* const ends[] = {block.data(), block.data() + bytes - 1};
                for (std::byte* const end : ends) *end = std::byte(t);
                for (const std::byte* const end : ends) wrong[t] += *end != std::byte(t);
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

} // namespace
} // namespace druse
