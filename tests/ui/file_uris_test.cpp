#include "ui/file_commands.h"

#include <gtest/gtest.h>

namespace druse::ui {
namespace {

using Paths = std::vector<std::filesystem::path>;

TEST(FileUris, AreDecodedOneALine)
{
    EXPECT_EQ(files_of_uris("file:///tmp/a%20b.obj\r\nfile://host/tmp/c.stl\r\n"), (Paths{"/tmp/a b.obj", "/tmp/c.stl"}));
    EXPECT_EQ(files_of_uris("/plain/path.obj"), Paths{"/plain/path.obj"});
}

TEST(FileUris, LeaveOutWhatIsNoFile)
{
    EXPECT_EQ(files_of_uris("http://example.org/x.obj\n# comment\n\nfile://nothing"), Paths());
    EXPECT_EQ(files_of_uris("file:///tmp/100%"), Paths{"/tmp/100%"});
    EXPECT_EQ(files_of_uris("file:///tmp/%zz"), Paths{"/tmp/%zz"});
}

} // namespace
} // namespace druse::ui
