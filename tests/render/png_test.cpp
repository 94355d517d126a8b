#include "render/png.h"

#include "dlfl/errors.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include <unistd.h>

namespace druse {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, removed afterwards.
class Png : public testing::Test {
protected:
    void SetUp() override
    {
        folder_ = fs::path(testing::TempDir()) / ("druse_png_" + std::to_string(getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    std::string file(const char* name) const { return (folder_ / name).string(); }
    std::size_t files() const
    {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator{}));
    }

    fs::path folder_;
};

Image gradient(bool opaque)
{
    Image image(7, 5);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 7; ++x) {
            const auto alpha = static_cast<std::uint8_t>(opaque ? 255 : 50 * y + 1);
            image.at(x, y) = {static_cast<std::uint8_t>(x * 30), static_cast<std::uint8_t>(y * 50), 200, alpha};
        }
    return image;
}

TEST_F(Png, GivesBackEveryPixel)
{
    for (const bool opaque : {true, false}) {
        const Image image = gradient(opaque);
        write_png(file("a.png"), image);
        EXPECT_TRUE(read_png(file("a.png")) == image);
    }
    EXPECT_EQ(files(), 1u) << "no temporary file is left";
}

TEST_F(Png, WritesTheSameBytesForTheSameImage)
{
    EXPECT_EQ(encode_png(gradient(false)), encode_png(gradient(false)));
    const std::vector<std::uint8_t> bytes = encode_png(gradient(true));
    write_png(file("a.png"), gradient(true));
    std::ifstream in(file("a.png"), std::ios::binary);
    EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), std::istreambuf_iterator<char>(in), {},
                           [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); }));
}

TEST_F(Png, KeepsAnAlphaChannelOnlyWhereItSaysSomething)
{
    // Byte 25 of a PNG file is its colour type: 2 RGB, 6 RGBA.
    EXPECT_EQ(encode_png(gradient(true)).at(25), 2);
    EXPECT_EQ(encode_png(gradient(false)).at(25), 6);
}

TEST_F(Png, NamesTheFileThatItCannotWrite)
{
    const std::string target = file("nowhere/a.png");
    try {
        write_png(target, gradient(true));
        FAIL() << "the folder does not exist";
    } catch (const InputError& e) {
        EXPECT_EQ(std::string(e.what()), target + ": cannot write: No such file or directory");
    }
    fs::create_directory(file("folder.png"));
    EXPECT_THROW(write_png(file("folder.png"), gradient(true)), InputError);
    EXPECT_EQ(files(), 1u) << "only the folder itself";
}

TEST_F(Png, NamesTheFileThatIsNoPng)
{
    std::ofstream(file("a.png")) << "solid cube\n";
    EXPECT_THROW(read_png(file("a.png")), InputError);
    EXPECT_THROW(read_png(file("b.png")), InputError);
}

} // namespace
} // namespace druse
