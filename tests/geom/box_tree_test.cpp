#include "geom/box_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace druse {
namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

Box box(const Point& a, const Vector& size)
{
    Box b;
    b.add(a);
    b.add(a + size);
    return b;
}

bool overlap(const Box& a, const Box& b)
{
    return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

Pairs told(const std::vector<Box>& boxes)
{
    Progress progress;
    const BoxTree tree(boxes, progress, 0, 0.5);
    Pairs pairs;
    tree.for_each_pair(progress, 0.5, [&](std::uint32_t i, std::uint32_t j) {
        EXPECT_TRUE(pairs.emplace(std::min(i, j), std::max(i, j)).second) << i << " and " << j << " are told twice";
        return true;
    });
    return pairs;
}

std::vector<Box> random_boxes(std::size_t count, double size, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(0, 1);
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < count; ++i)
        boxes.push_back(box(Point(number(random), number(random), number(random)), size * Vector(number(random), number(random), number(random))));
    return boxes;
}

/// All that overlap are told; with plain numbers, no others.
void expect_all(const std::vector<Box>& boxes, bool no_others)
{
    const Pairs pairs = told(boxes);
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
            const bool expected = overlap(boxes[i], boxes[j]), is_told = pairs.contains({i, j});
            EXPECT_TRUE(is_told == expected || (is_told && !no_others)) << i << " and " << j;
        }
}

TEST(BoxTree, TellsAllThatOverlapWhateverTheirNumber)
{
    for (const std::size_t n : {0, 1, 2, 3, 4, 5, 7, 8, 9, 16, 17, 33, 100, 400}) expect_all(random_boxes(n, 0.3, unsigned(n)), true);
}

TEST(BoxTree, TellsBoxesThatTouch)
{
    // Cubes of a grid: each touches up to 26 others.
    std::vector<Box> boxes;
    for (int x = 0; x < 8; ++x)
        for (int y = 0; y < 8; ++y)
            for (int z = 0; z < 8; ++z) boxes.push_back(box(Point(x, y, z), Vector(1)));
    // Σ of neighbours: along each axis 8 + 2·7 ordered pairs, so 22³, less each with itself, halved.
    EXPECT_EQ(told(boxes).size(), (22u * 22 * 22 - 512) / 2);
    expect_all(boxes, true);
}

TEST(BoxTree, LosesNoneFarFromTheOriginNextToOutliersOrAtTheEndOfTheNumbers)
{
    for (const auto& [scale, move] : {std::pair{1.0, 1e9}, {1e-30, 0.0}, {1e-310, 0.0}, {1e307, -5e307}, {8e307, -1e308}}) {
        std::vector<Box> boxes = random_boxes(100, 0.2, 3);
        for (Box& b : boxes) {
            b.min = scale * b.min + move;
            b.max = scale * b.max + move;
        }
        expect_all(boxes, false);
    }
    std::vector<Box> boxes = random_boxes(100, 0.2, 4);
    boxes.push_back(box(Point(1e12), Vector(1)));
    expect_all(boxes, false);
    expect_all(std::vector<Box>(20, box(Point(1), Vector(0))), true);
}

TEST(BoxTree, StopsWhenTold)
{
    Progress progress;
    const std::vector<Box> boxes(1000, box(Point(0), Vector(1)));
    const BoxTree tree(boxes, progress, 0, 0.5);
    int calls = 0;
    tree.for_each_pair(progress, 0.5, [&](std::uint32_t, std::uint32_t) { return ++calls < 10; });
    EXPECT_EQ(calls, 10);
}

TEST(BoxTree, StopsWhenCancelled)
{
    Progress progress;
    const std::vector<Box> boxes = random_boxes(5000, 0.5, 5);
    const BoxTree tree(boxes, progress, 0, 0.5);
    int calls = 0;
    EXPECT_THROW(tree.for_each_pair(progress, 0.5, [&](std::uint32_t, std::uint32_t) {
        if (++calls == 100) progress.cancel();
        return true;
    }), Cancelled);
    EXPECT_LT(calls, 100000); // of some millions
    EXPECT_THROW(BoxTree(boxes, progress, 0, 0.5), Cancelled);
}

TEST(BoxTree, TellsTheBoxesOnARay)
{
    const std::vector<Box> boxes = random_boxes(500, 0.2, 6);
    Progress progress;
    const BoxTree tree(boxes, progress, 0, 1);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-0.5, 1.5);
    for (int i = 0; i < 200; ++i) {
        const Point from(number(random), number(random), number(random));
        Vector direction = glm::normalize(Vector(number(random), number(random), number(random)) - Vector(0.5));
        if (i % 10 == 0) direction = Vector(0, 0, 1);
        std::set<std::uint32_t> met;
        tree.for_each_on_ray(from, direction, 0.7, [&](std::uint32_t k, double&) { EXPECT_TRUE(met.insert(k).second); });
        for (std::uint32_t k = 0; k < boxes.size(); ++k) // along the ray, in small steps
            for (int step = 0; step <= 100; ++step) {
                const Point p = from + 0.007 * step * direction;
                if (overlap(boxes[k], box(p, Vector(0)))) {
                    EXPECT_TRUE(met.contains(k)) << k;
                    break;
                }
            }
    }
}

TEST(BoxTree, LooksNoFartherThanTheReach)
{
    std::vector<Box> boxes;
    for (int i = 0; i < 1000; ++i) boxes.push_back(box(Point(i, 0, 0), Vector(0.5)));
    Progress progress;
    const BoxTree tree(boxes, progress, 0, 1);
    std::set<std::uint32_t> met;
    tree.for_each_on_ray(Point(-1, 0.25, 0.25), Vector(1, 0, 0), 1e9, [&](std::uint32_t k, double& reach) {
        met.insert(k);
        reach = std::min(reach, 1.0 + k);
    });
    EXPECT_TRUE(met.contains(0));
    EXPECT_LT(met.size(), 10u);
}

} // namespace
} // namespace druse
