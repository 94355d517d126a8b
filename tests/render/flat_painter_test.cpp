#include "render/flat_painter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace druse {
namespace {

constexpr Colour white{255, 255, 255};

/// What is white of a picture that was black, in pixels.
double painted_area(const Image& image)
{
    double sum = 0;
    for (const Pixel& p : image.pixels) sum += p.green / 255.0;
    return sum;
}

Image black(int width, int height)
{
    Image image(width, height);
    FlatPainter(image).clear({0, 0, 0});
    return image;
}

TEST(FlatPainter, CoversEachPixelOfAPolygonByItsPart)
{
    Image image = black(4, 3);
    FlatPainter(image).fill(std::array<Point2, 4>{{{0.5, 1}, {3, 1}, {3, 2}, {0.5, 2}}}, white);
    EXPECT_NEAR(image.at(0, 1).green, 128, 1);
    EXPECT_EQ(image.at(1, 1).green, 255);
    EXPECT_EQ(image.at(2, 1).green, 255);
    EXPECT_EQ(image.at(3, 1).green, 0);
    EXPECT_EQ(image.at(1, 0).green, 0);
    EXPECT_EQ(image.at(1, 2).green, 0);
}

TEST(FlatPainter, PaintsTheAreaOfAPolygonInEitherSense)
{
    std::vector<Point2> star; // an area of 5 r R sin 36°
    for (int i = 0; i < 10; ++i) {
        const double r = i % 2 == 0 ? 40 : 17, a = std::numbers::pi * i / 5 + 0.1;
        star.push_back(Point2(50.3, 47.7) + r * Point2(std::cos(a), std::sin(a)));
    }
    const double area = 5 * 40 * 17 * std::sin(std::numbers::pi / 5);
    for (int sense = 0; sense < 2; ++sense) {
        Image image = black(100, 100);
        FlatPainter(image).fill(star, white);
        EXPECT_NEAR(painted_area(image), area, 1.5);
        std::ranges::reverse(star);
    }
}

TEST(FlatPainter, CutsAPolygonOffAtTheEndsOfTheImage)
{
    // A square standing on its corner, its middle on the corner of the image: a quarter of its area of 2 · 30².
    for (const Point2& middle : {Point2(0, 0), Point2(50, 0), Point2(0, 50), Point2(50, 50)}) {
        Image image = black(50, 50);
        const std::array<Point2, 4> square{middle + Point2(30, 0), middle + Point2(0, 30), middle - Point2(30, 0), middle - Point2(0, 30)};
        FlatPainter(image).fill(square, white);
        EXPECT_NEAR(painted_area(image), 450, 1);
    }
    Image image = black(50, 50);
    FlatPainter(image).fill(std::array<Point2, 3>{{{-1e9, -1e9}, {1e9, -1e9}, {0, 1e9}}}, white);
    EXPECT_EQ(painted_area(image), 2500);
}

TEST(FlatPainter, DrawsLinesAsWideAsAsked)
{
    Image image = black(120, 120);
    FlatPainter(image).line({20, 30}, {100, 90}, 3, white); // 100 long, and a half disc at each end
    EXPECT_NEAR(painted_area(image), 300 + std::numbers::pi * 2.25, 3);
    Image thin = black(120, 120);
    FlatPainter(thin).line({20, 30}, {100, 90}, 0.5, white);
    EXPECT_NEAR(painted_area(thin), 50, 3);
}

TEST(FlatPainter, DrawsDiscsAndRings)
{
    Image image = black(60, 60);
    FlatPainter painter(image);
    painter.disc({30, 30}, 20, white);
    EXPECT_NEAR(painted_area(image), std::numbers::pi * 400, 4);
    painter.clear({0, 0, 0});
    painter.ring({30, 30}, 20, 4, white);
    EXPECT_NEAR(painted_area(image), 2 * std::numbers::pi * 20 * 4, 4);
    EXPECT_EQ(image.at(30, 30).green, 0);
}

TEST(FlatPainter, LeavesOutWhatIsNoNumberOrOutside)
{
    Image image = black(20, 20);
    FlatPainter painter(image);
    const double none = std::nan("");
    painter.fill(std::array<Point2, 3>{{{1, 1}, {none, 5}, {5, 1}}}, white);
    painter.line({none, 0}, {5, 5}, 2, white);
    painter.disc({0, none}, 3, white);
    painter.line({-50, -50}, {-40, 1e8}, 2, white);
    painter.disc({200, 200}, 5, white);
    EXPECT_EQ(painted_area(image), 0);
}

TEST(FlatPainter, PutsAnotherPictureUnderneathTurnedAndFaint)
{
    Image other(2, 1); // black and white
    other.at(0, 0) = {0, 0, 0, 255};
    other.at(1, 0) = {255, 255, 255, 255};
    Image image = black(4, 4);
    // Twice as large, turned by a quarter: down the image runs along the other.
    FlatPainter(image).picture(other, {0, 1}, {0, -0.25}, {0.5, 0}, 0.5);
    EXPECT_EQ(image.at(1, 0).green, 0);
    EXPECT_NEAR(image.at(1, 3).green, 128, 1);
}

} // namespace
} // namespace druse
