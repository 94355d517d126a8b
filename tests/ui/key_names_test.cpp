#include "ui/key_names.h"

#include <FL/Enumerations.H>

#include <gtest/gtest.h>

namespace druse::ui {
namespace {

TEST(KeyNames, AreWhatMenusShow)
{
    EXPECT_EQ(key_text({'z', FL_CTRL}), "Ctrl+Z");
    EXPECT_EQ(key_text({'z', FL_CTRL | FL_SHIFT}), "Ctrl+Shift+Z");
    EXPECT_EQ(key_text({FL_Escape, 0}), "Escape");
    EXPECT_EQ(key_text({FL_F + 12, 0}), "F12");
    EXPECT_EQ(key_text({'a', 0}), "a");
}

TEST(KeyNames, ReadBackAsTheSameKey)
{
    for (const Key& key : {Key{'z', FL_CTRL}, Key{'y', FL_CTRL | FL_SHIFT}, Key{FL_Escape, 0}, Key{FL_F + 1, 0}, Key{FL_KP + '7', FL_CTRL}, Key{' ', 0},
                           Key{'+', 0}, Key{']', 0}, Key{FL_Tab, 0}, Key{'b', FL_SHIFT}})
        EXPECT_EQ(key_from_text(key_text(key)), key) << key_text(key);
    EXPECT_FALSE(key_from_text(""));
    EXPECT_FALSE(key_from_text("Ctrl+"));
    EXPECT_FALSE(key_from_text("Fine"));
    EXPECT_FALSE(key_from_text("Hyper+X"));
}

} // namespace
} // namespace druse::ui
