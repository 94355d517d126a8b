#include "ui/worker.h"

#include <gtest/gtest.h>

#include <atomic>

namespace druse::ui {
namespace {

TEST(Worker, DoesAJobAndTellsWhenItIsDone)
{
    Worker worker;
    int result = 0;
    worker.start([&](Progress&) { result = 42; });
    worker.wait();
    EXPECT_EQ(result, 42);
    EXPECT_FALSE(worker.busy());
    bool told = false;
    worker.when_done([&] { told = true; });
    EXPECT_TRUE(told); // at once: it is done already
}

TEST(Worker, WaitsNoLongerThanItsPatience)
{
    Worker worker;
    std::atomic<bool> go{false}, told{false};
    worker.start([&](Progress&) {
        while (!go) std::this_thread::yield();
    });
    EXPECT_FALSE(worker.wait(std::chrono::milliseconds(1)));
    worker.when_done([&] { told = true; });
    EXPECT_FALSE(told);
    go = true;
    worker.wait();
    while (!told) std::this_thread::yield();
}

TEST(Worker, AJobHearsThatItIsCancelled)
{
    Worker worker;
    std::atomic<bool> cancelled{false};
    worker.start([&](Progress& progress) {
        try {
            while (true) progress.step(0.5);
        } catch (const Cancelled&) {
            cancelled = true;
        }
    });
    while (worker.fraction() != 0.5) std::this_thread::yield();
    worker.cancel();
    worker.wait();
    EXPECT_TRUE(cancelled);
}

TEST(Worker, GoesAwayInTheMiddleOfAJob)
{
    std::atomic<bool> ended{false};
    {
        Worker worker;
        worker.start([&](Progress& progress) {
            try {
                while (true) progress.step(0);
            } catch (const Cancelled&) {
                ended = true;
            }
        });
    }
    EXPECT_TRUE(ended);
}

} // namespace
} // namespace druse::ui
