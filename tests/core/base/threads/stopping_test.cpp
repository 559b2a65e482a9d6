// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/threads/stopping.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/threads/parallel.h"

#include <gtest/gtest.h>
#include <memory>
#include <mutex>
#include <set>
#include <string>

namespace sheetmorph
{
namespace
{

constexpr std::chrono::milliseconds at_every_look(0);

TEST(Stopping, NobodyIsAskedWithoutASignal)
{
    EXPECT_EQ(StopSignal::current(), nullptr);
    EXPECT_NO_THROW(look_for_stop());
}

TEST(Stopping, TheInnermostSignalIsAskedAndTheOuterOneAgainLater)
{
    int outer = 0, inner = 0;
    const StopSignal first([&] { ++outer; }, at_every_look);
    look_for_stop();
    {
        const StopSignal second([&] { ++inner; }, at_every_look);
        look_for_stop();
        look_for_stop();
    }
    look_for_stop();
    EXPECT_EQ(outer, 2);
    EXPECT_EQ(inner, 2);
}

TEST(Stopping, NobodyIsAskedBeforeThePauseIsOver)
{
    const StopSignal signal([] { FAIL(); }, std::chrono::hours(1));
    for (int k = 0; k < 1000; ++k)
        look_for_stop();
}

TEST(Stopping, WhatHasEndedStaysEnded)
{
    int asked = 0;
    StopSignal signal(
        [&]
        {
            ++asked;
            throw Cancelled();
        },
        at_every_look);
    EXPECT_THROW(look_for_stop(), Cancelled);
    EXPECT_THROW(look_for_stop(), Cancelled);
    EXPECT_EQ(asked, 1);
}

class StoppingThreads : public testing::TestWithParam<int>
{
private:
    ThreadCount threads_{GetParam()};
};

// What ends it is one exception, whichever thread has seen the end first.
struct Reason
{
    int number;
};

TEST_P(StoppingThreads, WorkWithinWorkEndsWithTheReasonAndOnlyTheCallerIsAsked)
{
    for (int after = 1; after < 40; ++after)
    {
        std::mutex mutex;
        std::set<std::thread::id> askers;
        int looks = 0;
        const StopSignal signal(
            [&]
            {
                askers.insert(std::this_thread::get_id());
                if (++looks == after)
                    throw Reason{after};
            },
            at_every_look);
        try
        {
            parallel_items(50, [&](Eigen::Index)
                           { parallel_ranges(100, 10, [](Eigen::Index, Eigen::Index) {}); });
            parallel_items(1000, [](Eigen::Index) {});
            FAIL() << "it was not stopped";
        }
        catch (const Reason& reason)
        {
            EXPECT_EQ(reason.number, after);
        }
        EXPECT_EQ(askers, std::set<std::thread::id>{std::this_thread::get_id()});
    }
}

// Items of other threads go on for ever unless they see it.
TEST_P(StoppingThreads, ThreadsThatHelpEndTooWhileTheCallerWaitsForThem)
{
    std::atomic<int> begun{0};
    const StopSignal signal(
        [&]
        {
            if (begun >= 2 || GetParam() == 1)
                throw Cancelled();
        },
        std::chrono::milliseconds(1));
    const std::thread::id caller = std::this_thread::get_id();
    EXPECT_THROW(parallel_items(2,
                                [&](Eigen::Index)
                                {
                                    ++begun;
                                    while (std::this_thread::get_id() != caller || begun < 2)
                                        look_for_stop();
                                }),
                 Cancelled);
}

TEST_P(StoppingThreads, TasksThatReportNothingEndWhenTheProgressCancels)
{
    int reports = 0;
    const Progress progress([&](double, const std::string&) { return ++reports < 2; });
    const StopSignal signal([] {}, at_every_look);
    const auto endless = [&](const Progress& own)
    {
        while (true)
            GetParam() == 1 ? own.report(0.0, "in turn") : look_for_stop();
    };
    EXPECT_THROW(run_tasks({{"a", endless}, {"b", endless}}, progress), Cancelled);
}

INSTANTIATE_TEST_SUITE_P(Threads, StoppingThreads, testing::Values(1, 2, 4));

}  // namespace
}  // namespace sheetmorph
