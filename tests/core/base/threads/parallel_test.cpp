// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/threads/parallel.h"

#include "sheetmorph/base/errors.h"

#include <atomic>
#include <gtest/gtest.h>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace sheetmorph
{
namespace
{

class Parallel : public testing::TestWithParam<int>
{
private:
    ThreadCount threads_{GetParam()};
};

TEST_P(Parallel, EveryItemIsDoneOnce)
{
    for (const Eigen::Index count : {0, 1, 2, 5, 1000})
    {
        std::vector<std::atomic<int>> times(static_cast<std::size_t>(count));
        parallel_items(count, [&](Eigen::Index item) { ++times[static_cast<std::size_t>(item)]; });
        for (const std::atomic<int>& one : times)
            EXPECT_EQ(one, 1);
    }
}

TEST_P(Parallel, RangesCoverEverythingAndAreCutAlikeWhateverTheNumberOfThreads)
{
    for (const Eigen::Index count : {0, 1, 99, 100, 250, 100000})
    {
        std::mutex mutex;
        std::set<std::pair<Eigen::Index, Eigen::Index>> found, expected;
        const auto note = [&](Eigen::Index begin, Eigen::Index end)
        {
            const std::lock_guard<std::mutex> lock(mutex);
            found.insert({begin, end});
        };
        parallel_ranges(count, 100, note);
        expected.swap(found);
        Eigen::Index covered = 0;
        for (const auto& [begin, end] : expected)
        {
            EXPECT_EQ(begin, covered);
            covered = end;
        }
        EXPECT_EQ(covered, count);
        const ThreadCount one(1);
        parallel_ranges(count, 100, note);
        EXPECT_EQ(found, expected);
    }
}

TEST_P(Parallel, TheFirstItemThatFailsIsTold)
{
    for (int repeat = 0; repeat < 100; ++repeat)
    {
        std::atomic<int> inside{0};
        try
        {
            parallel_items(60,
                           [&](Eigen::Index item)
                           {
                               ++inside;
                               std::this_thread::yield();
                               --inside;
                               if (item >= 7)
                                   throw std::runtime_error(std::to_string(item));
                           });
            FAIL() << "nothing was thrown";
        }
        catch (const std::runtime_error& error)
        {
            EXPECT_STREQ(error.what(), "7");
            EXPECT_EQ(inside, 0) << "an item was still at work";
        }
    }
}

TEST_P(Parallel, ExceptionsOfAPairReachTheCallerFromEitherSide)
{
    const auto fail = [] { throw SolverError("no"); };
    const auto pass = [] {};
    EXPECT_THROW(parallel_pair(fail, pass), SolverError);
    EXPECT_THROW(parallel_pair(pass, fail), SolverError);
    EXPECT_THROW(parallel_pair(fail, fail), SolverError);
}

// A sum of 0 .. count - 1, halved again and again, some of it thrown away.
Eigen::Index nested_sum(Eigen::Index begin, Eigen::Index end)
{
    if (end - begin < 20)
    {
        Eigen::Index sum = 0;
        for (Eigen::Index k = begin; k < end; ++k)
            sum += k;
        return sum;
    }
    const Eigen::Index middle = (begin + end) / 2;
    Eigen::Index left = 0, right = 0;
    parallel_pair([&] { left = nested_sum(begin, middle); },
                  [&] { right = nested_sum(middle, end); });
    try
    {
        parallel_items(3, [](Eigen::Index) { throw std::out_of_range("inside"); });
    }
    catch (const std::out_of_range&)
    {
        return left + right;
    }
    return -1;
}

TEST_P(Parallel, WorkWithinWorkNeitherHangsNorLosesAnything)
{
    std::vector<std::thread> callers;
    std::atomic<int> right{0};
    for (int caller = 0; caller < 4; ++caller)
        callers.emplace_back([&] { right += nested_sum(0, 3000) == 3000 * 2999 / 2 ? 1 : 0; });
    for (std::thread& caller : callers)
        caller.join();
    EXPECT_EQ(right, 4);
}

std::vector<Task> tasks_of(int count, const std::function<void(int, const Progress&)>& work)
{
    std::vector<Task> tasks;
    for (int k = 0; k < count; ++k)
        tasks.push_back({"task " + std::to_string(k),
                         [work, k](const Progress& progress) { work(k, progress); }});
    return tasks;
}

TEST_P(Parallel, TasksAllRunAndTheirFirstFailureIsTold)
{
    std::atomic<int> run{0};
    run_tasks(tasks_of(30, [&](int, const Progress&) { ++run; }), Progress());
    EXPECT_EQ(run, 30);
    const auto fail = [](int k, const Progress&)
    {
        if (k >= 3)
            throw InvalidInput(std::to_string(k));
    };
    try
    {
        run_tasks(tasks_of(30, fail), Progress());
        FAIL() << "nothing was thrown";
    }
    catch (const InvalidInput& error)
    {
        EXPECT_STREQ(error.what(), "3");
    }
}

TEST_P(Parallel, ACancelledTaskEndsAtItsNextReport)
{
    const Progress cancel([](double, const std::string&) { return false; });
    const auto work_for_ever = [](int, const Progress& progress)
    {
        while (true)
            progress.report(0.5, "working");
    };
    EXPECT_THROW(run_tasks(tasks_of(6, work_for_ever), cancel), Cancelled);
}

TEST_P(Parallel, ProgressIsReportedByTheCallingThreadAlone)
{
    const std::thread::id own = std::this_thread::get_id();
    bool is_own = true;
    const Progress progress(
        [&](double, const std::string&)
        {
            is_own = is_own && std::this_thread::get_id() == own;
            return true;
        });
    run_tasks(tasks_of(8, [](int, const Progress& asked) { asked.report(0.5, "half"); }), progress);
    EXPECT_TRUE(is_own);
}

TEST_P(Parallel, TasksWithinTasksEnd)
{
    std::atomic<int> run{0};
    const auto inner = [&](int, const Progress&)
    { parallel_items(10, [&](Eigen::Index) { ++run; }); };
    const auto outer = [&](int, const Progress& progress)
    { run_tasks(tasks_of(5, inner), progress); };
    run_tasks(tasks_of(5, outer), Progress());
    EXPECT_EQ(run, 250);
}

TEST_P(Parallel, AForkedProcessWorksToo)
{
#ifdef __SANITIZE_THREAD__
    GTEST_SKIP() << "the thread sanitizer starts no threads after a fork";
#endif
    parallel_items(8, [](Eigen::Index) {});
    const pid_t child = fork();
    if (child == 0)
    {
        std::atomic<int> run{0};
        parallel_items(8, [&](Eigen::Index) { ++run; });
        run_tasks(tasks_of(8, [&](int, const Progress&) { ++run; }), Progress());
        _exit(run == 16 ? 0 : 1);
    }
    int status = -1;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
}

INSTANTIATE_TEST_SUITE_P(Threads, Parallel, testing::Values(1, 2, 3, 8));

TEST(ThreadCount, HoldsWhileItLives)
{
    const int before = thread_count();
    {
        const ThreadCount more(before + 5);
        EXPECT_EQ(thread_count(), before + 5);
    }
    EXPECT_EQ(thread_count(), before);
}

}  // namespace
}  // namespace sheetmorph
