// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/threads/parallel.h"

#include "sheetmorph/base/threads/stopping.h"
#include "sheetmorph/base/threads/thread_pool.h"

#include <algorithm>
#include <atomic>

namespace sheetmorph
{

namespace
{

// Chosen: enough that faster threads take work from threads that are slow for a while.
constexpr Eigen::Index most_ranges = 64;

void run_in_turn(const std::vector<Task>& tasks, const Progress& progress)
{
    const auto count = static_cast<double>(tasks.size());
    for (std::size_t k = 0; k < tasks.size(); ++k)
    {
        look_for_stop();
        tasks[k].work(
            progress.part(static_cast<double>(k) / count, static_cast<double>(k + 1) / count));
    }
}

}  // namespace

int thread_count()
{
    return ThreadPool::common().threads();
}

ThreadCount::ThreadCount(int threads) : before_(thread_count())
{
    ThreadPool::common().set_threads(threads);
}

ThreadCount::~ThreadCount()
{
    ThreadPool::common().set_threads(before_);
}

void parallel_items(Eigen::Index count, const std::function<void(Eigen::Index item)>& work)
{
    ThreadPool::common().run(count, work);
}

void parallel_ranges(Eigen::Index count, Eigen::Index least,
                     const std::function<void(Eigen::Index begin, Eigen::Index end)>& work)
{
    const Eigen::Index ranges =
        std::clamp<Eigen::Index>(count / std::max<Eigen::Index>(least, 1), 1, most_ranges);
    if (ranges == 1)
    {
        look_for_stop();
        work(0, count);
    }
    else
        parallel_items(ranges, [&](Eigen::Index range)
                       { work(count * range / ranges, count * (range + 1) / ranges); });
}

void parallel_pair(const std::function<void()>& one, const std::function<void()>& other)
{
    parallel_items(2, [&](Eigen::Index item) { item == 0 ? one() : other(); });
}

void run_tasks(const std::vector<Task>& tasks, const Progress& progress)
{
    ThreadPool& pool = ThreadPool::common();
    const auto count = static_cast<Eigen::Index>(tasks.size());
    if (tasks.size() == 1 || pool.threads() == 1)
    {
        run_in_turn(tasks, progress);
        return;
    }
    if (!pool.can_watch())  // inside another task: that one reports
    {
        pool.run(count, [&](Eigen::Index k) { tasks[static_cast<std::size_t>(k)].work(progress); });
        return;
    }
    std::atomic<bool> is_wanted{true};
    std::atomic<std::size_t> latest{0};
    const Progress asked([&](double, const std::string&) { return is_wanted.load(); });
    const auto work = [&](Eigen::Index k)
    {
        latest = static_cast<std::size_t>(k);
        tasks[static_cast<std::size_t>(k)].work(asked);
    };
    const auto watch = [&](Eigen::Index done)
    {
        try
        {
            progress.report(static_cast<double>(done) / static_cast<double>(count),
                            tasks[latest].name);
        }
        catch (...)
        {
            is_wanted = false;
            throw;
        }
    };
    pool.run_watched(count, work, watch);
}

}  // namespace sheetmorph
