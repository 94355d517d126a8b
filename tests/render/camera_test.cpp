#include "render/camera.h"

#include "dlfl/errors.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace druse {
namespace {

void expect_near(const Vector& a, const Vector& b, double tolerance = 1e-12)
{
    EXPECT_LE(glm::distance(a, b), tolerance)
        << a.x << ", " << a.y << ", " << a.z << " is not " << b.x << ", " << b.y << ", " << b.z;
}

Camera looking(std::string_view view)
{
    Camera camera;
    camera.resize(800, 600);
    camera.set_angles(*view_from_text(view));
    return camera;
}

TEST(Views, AreNamedOrGivenByTwoAngles)
{
    EXPECT_EQ(view_from_text("front"), (ViewAngles{0, 0}));
    EXPECT_EQ(view_from_text("right"), (ViewAngles{90, 0}));
    EXPECT_EQ(view_from_text("top"), (ViewAngles{0, 90}));
    EXPECT_EQ(view_from_text("-12.5,30"), (ViewAngles{-12.5, 30}));
    EXPECT_NEAR(view_from_text("iso")->elevation, 180 / M_PI * std::atan(std::sqrt(0.5)), 1e-12);
    for (const char* wrong : {"", "Front", "1", "1,", ",1", "1,2,3", "1, 2", "nan,0", "0,91", "0,-91", "inf,0", "0x1,2"})
        EXPECT_FALSE(view_from_text(wrong)) << wrong;
}

TEST(Views, LookAsTheInterfaceSays)
{
    // Each row: the name, where the eye is, and what is to the right and upward in the picture.
    const struct {
        const char* name;
        Vector eye, right, up;
    } rows[] = {
        {"front", {0, -1, 0}, {1, 0, 0}, {0, 0, 1}}, {"back", {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}},
        {"right", {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},  {"left", {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
        {"top", {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},    {"bottom", {0, 0, -1}, {1, 0, 0}, {0, -1, 0}},
    };
    for (const auto& row : rows) {
        SCOPED_TRACE(row.name);
        const Camera camera = looking(row.name);
        expect_near(camera.backward(), row.eye, 0);
        expect_near(camera.right(), row.right, 0);
        expect_near(camera.up(), row.up, 0);
    }
    const double third = std::sqrt(1.0 / 3);
    expect_near(looking("iso").backward(), {third, -third, third});
}

TEST(Camera, ProjectsTheTargetToTheMiddleAndUnitsToPixels)
{
    for (const bool parallel : {false, true}) {
        Camera camera = looking("front");
        camera.set_parallel(parallel);
        camera.set_target({5, 6, 7});
        camera.set_distance(10);
        const Point2 middle = *camera.project({5, 6, 7});
        EXPECT_DOUBLE_EQ(middle.x, 400);
        EXPECT_DOUBLE_EQ(middle.y, 300);
        // One unit is half the picture's height over tan(15°) · 10 units.
        const double pixels = 300 / (10 * std::tan(M_PI / 12));
        EXPECT_NEAR(camera.project({6, 6, 7})->x, 400 + pixels, 1e-9);
        EXPECT_NEAR(camera.project({5, 6, 8})->y, 300 - pixels, 1e-9);
        EXPECT_NEAR(camera.unit_per_pixel(), 1 / pixels, 1e-12);
    }
}

TEST(Camera, SeesNothingBehindTheEyeInPerspective)
{
    Camera camera = looking("front");
    camera.set_distance(10);
    EXPECT_FALSE(camera.project({0, -10.5, 0}));
    EXPECT_FALSE(camera.project({0, -10, 0}));
    camera.set_parallel(true);
    EXPECT_TRUE(camera.project({0, -10.5, 0}));
}

TEST(Camera, SendsARayThroughEveryPointToItsPixel)
{
    for (const bool parallel : {false, true})
        for (const char* view : {"iso", "top", "-130,-20"}) {
            Camera camera = looking(view);
            camera.set_parallel(parallel);
            camera.set_target({1e5, -2e5, 30});
            for (const Vector offset : {Vector(0.3, 0.2, -0.4), Vector(-0.9, 0.1, 0.7), Vector(0, 0, 0)}) {
                const Point p = camera.target() + offset;
                const Point2 pixel = *camera.project(p);
                const Ray ray = camera.ray(pixel.x, pixel.y);
                const Vector away = p - ray.origin;
                EXPECT_NEAR(glm::length(ray.direction), 1, 1e-12);
                EXPECT_LT(glm::length(away - glm::dot(away, ray.direction) * ray.direction), 1e-6);
                EXPECT_GT(glm::dot(away, ray.direction), 0);
            }
        }
}

TEST(Camera, ClipsWhereItProjects)
{
    const Box scene{{-1, -1, -1}, {1, 1, 1}};
    for (const bool parallel : {false, true}) {
        Camera camera = looking("iso");
        camera.set_parallel(parallel);
        camera.fit(scene);
        const Point origin(0.25, 0.5, 0.125);
        for (const Point p : {Point(1, 1, 1), Point(-1, 1, -1), Point(1, -1, 1), Point(-1, -1, -1), Point(0, 0, 0)}) {
            const glm::dvec4 clip = camera.to_clip(origin, scene) * glm::dvec4(p - origin, 1.0);
            const Point2 pixel = *camera.project(p);
            EXPECT_NEAR((clip.x / clip.w + 1) * 400, pixel.x, 1e-9);
            EXPECT_NEAR((1 - clip.y / clip.w) * 300, pixel.y, 1e-9);
            EXPECT_LT(std::abs(clip.z / clip.w), 1);
        }
    }
}

TEST(Camera, BringsDepthNearerByThePixelsAskedFor)
{
    const Box scene{{-1, -1, -1}, {1, 1, 1}};
    for (const bool parallel : {false, true}) {
        Camera camera = looking("front");
        camera.set_parallel(parallel);
        camera.fit(scene);
        const auto depth = [&](const Point& p) {
            const glm::dvec4 clip = camera.to_clip(Point(0), scene) * glm::dvec4(p, 1.0);
            return std::pair(clip.z / clip.w, clip.w);
        };
        const auto [z, w] = depth({0, 0, 0});
        const auto [nearer, unused] = depth({0, -5 * camera.unit_per_pixel(), 0});
        EXPECT_NEAR(z - camera.depth_shift(5, scene) / w, nearer, 2e-2 * (z - nearer));
    }
}

TEST(Camera, FramesABoxTightlyFromEverywhere)
{
    const Box box{{10, 20, 30}, {14, 21, 33}};
    for (const bool parallel : {false, true})
        for (const auto& [width, height] : {std::pair(800, 600), std::pair(300, 900)})
            for (const char* view : {"iso", "front", "top", "200,-50"}) {
                Camera camera = looking(view);
                camera.resize(width, height);
                camera.set_parallel(parallel);
                camera.fit(box);
                expect_near(camera.target(), {12, 20.5, 31.5});
                double widest = 0;
                for (int i = 0; i < 8; ++i) {
                    const Point corner(i & 1 ? 10 : 14, i & 2 ? 20 : 21, i & 4 ? 30 : 33);
                    const Point2 p = *camera.project(corner);
                    widest = std::max({widest, std::abs(2 * p.x / width - 1), std::abs(2 * p.y / height - 1)});
                }
                EXPECT_NEAR(widest, 0.9, 1e-9);
            }
}

TEST(Camera, FramesPointsAsTightlyAsTheirBoxAllows)
{
    // A ball of points leaves the corners of its box empty, so the camera comes nearer.
    const std::array<Point, 6> points{Point(1, 0, 0),  Point(-1, 0, 0), Point(0, 1, 0),
                                      Point(0, -1, 0), Point(0, 0, 1),  Point(0, 0, -1)};
    Camera by_points = looking("iso"), by_box = looking("iso");
    by_points.fit(points);
    by_box.fit(Box{Point(-1), Point(1)});
    EXPECT_LT(by_points.distance(), by_box.distance());
}

TEST(Camera, FramesNothingAndAPointAsIfTheyMeasuredOne)
{
    Camera nothing = looking("front"), point = looking("front"), cube = looking("front");
    nothing.fit(Box{});
    point.fit(Box{{3, 3, 3}, {3, 3, 3}});
    cube.fit(Box{Point(-0.5), Point(0.5)});
    EXPECT_DOUBLE_EQ(nothing.distance(), cube.distance());
    EXPECT_DOUBLE_EQ(point.distance(), cube.distance());
    expect_near(point.target(), {3, 3, 3});
}

TEST(Camera, TurnsRoundAndRoundButNotOverThePoles)
{
    Camera camera = looking("front");
    camera.orbit(350, 200);
    EXPECT_EQ(camera.angles(), (ViewAngles{-10, 90}));
    camera.orbit(20, -300);
    EXPECT_EQ(camera.angles(), (ViewAngles{10, -90}));
}

TEST(Camera, TurnsAboutAnyAxisAsARotationDoes)
{
    const auto expect_near = [](const Vector& a, const Vector& b) { EXPECT_LE(glm::distance(a, b), 1e-9) << a.x << " " << a.y << " " << a.z; };
    for (const ViewAngles start : {ViewAngles{0, 0}, ViewAngles{30, 50, 20}, ViewAngles{-160, -90, 0}, ViewAngles{70, 89.9999999, -100}})
        for (const Vector axis : {Vector(0, 0, 1), unit(Vector(1, 2, -3)), unit(Vector(-1, 1, 0))})
            for (const double degrees : {1e-7, 40.0, 90.0, 180.0, -137.0}) {
                Camera camera;
                camera.set_angles(start);
                const Vector right = camera.right(), up = camera.up(), backward = camera.backward();
                camera.turn(axis, degrees);
                const double angle = degrees * 3.141592653589793 / 180;
                const auto turned = [&](const Vector& v) {
                    return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) + axis * glm::dot(axis, v) * (1 - std::cos(angle));
                };
                expect_near(camera.right(), turned(right));
                expect_near(camera.up(), turned(up));
                expect_near(camera.backward(), turned(backward));
                camera.turn(axis, -degrees);
                expect_near(camera.right(), right);
                expect_near(camera.backward(), backward);
            }
}

TEST(Camera, StaysUprightWhereItTurnsAboutZ)
{
    Camera camera;
    camera.set_angles({10, 20});
    camera.turn({0, 0, 1}, 35);
    EXPECT_NEAR(camera.angles().azimuth, 45, 1e-9);
    EXPECT_NEAR(camera.angles().elevation, 20, 1e-9);
    EXPECT_EQ(camera.angles().roll, 0);
}

TEST(Camera, PansTheModelWithThePointer)
{
    Camera camera = looking("iso");
    const Point held = camera.target() + 0.1 * camera.right() - 0.2 * camera.up();
    const Point2 before = *camera.project(held);
    camera.pan(30, -12);
    const Point2 after = *camera.project(held);
    EXPECT_NEAR(after.x, before.x + 30, 1e-9);
    EXPECT_NEAR(after.y, before.y - 12, 1e-9);
}

TEST(Camera, ZoomsToThePointer)
{
    for (const bool parallel : {false, true}) {
        Camera camera = looking("iso");
        camera.set_parallel(parallel);
        const Point held = camera.target() + 0.4 * camera.right() + 0.3 * camera.up();
        const Point2 before = *camera.project(held);
        camera.zoom(3, before.x, before.y);
        const Point2 after = *camera.project(held);
        EXPECT_NEAR(after.x, before.x, 1e-9);
        EXPECT_NEAR(after.y, before.y, 1e-9);
        EXPECT_DOUBLE_EQ(camera.distance(), 4.0 / 3);
    }
}

TEST(Camera, RefusesAPictureWithoutPixels)
{
    Camera camera;
    EXPECT_THROW(camera.resize(0, 10), InternalError);
}

} // namespace
} // namespace druse
