#include "geom/do_both.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace druse {
namespace {

TEST(DoBoth, DoesBothApartOrNot)
{
    for (const bool apart : {false, true}) {
        int first = 0, second = 0;
        do_both(apart, [&] { first = 3; }, [&] { second = 4; });
        EXPECT_EQ(first, 3);
        EXPECT_EQ(second, 4);
    }
}

TEST(DoBoth, PassesOnWhatIsThrownTheFirstOnesBeforeTheSeconds)
{
    const auto fail = [](const char* what) { return [what] { throw std::runtime_error(what); }; };
    const auto error_of = [](auto&& work) -> std::string {
        try {
            work();
        } catch (const std::runtime_error& e) {
            return e.what();
        }
        return "nothing";
    };
    for (const bool apart : {false, true}) {
        EXPECT_EQ(error_of([&] { do_both(apart, fail("first"), fail("second")); }), "first");
        EXPECT_EQ(error_of([&] { do_both(apart, [] {}, fail("second")); }), "second");
        EXPECT_EQ(error_of([&] { do_both(apart, fail("first"), [] {}); }), "first");
    }
}

} // namespace
} // namespace druse
