// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/parallel.h"

#include <algorithm>
#include <exception>
#include <thread>
#include <vector>

namespace sheetmorph
{

namespace
{

// Below this many items a range, starting a thread costs more than it saves.
constexpr Eigen::Index smallest_range = 4;

constexpr Eigen::Index short_items_for_two_threads = 2000;

Eigen::Index thread_count(Eigen::Index count, int threads)
{
    const Eigen::Index wanted =
        threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    return std::clamp<Eigen::Index>(count / smallest_range, 1, wanted);
}

}  // namespace

int threads_for(Eigen::Index count)
{
    return count < short_items_for_two_threads ? 1 : 0;
}

void parallel_ranges(Eigen::Index count, int threads,
                     const std::function<void(Eigen::Index begin, Eigen::Index end)>& work)
{
    const Eigen::Index parts = thread_count(count, threads);
    std::vector<std::exception_ptr> failures(parts);
    const auto run = [&](Eigen::Index part)
    {
        try
        {
            work(count * part / parts, count * (part + 1) / parts);
        }
        catch (...)
        {
            failures[part] = std::current_exception();
        }
    };
    std::vector<std::thread> others;
    for (Eigen::Index part = 1; part < parts; ++part)
        others.emplace_back(run, part);
    run(0);
    for (std::thread& other : others)
        other.join();
    for (const std::exception_ptr& failure : failures)
        if (failure)
            std::rethrow_exception(failure);
}

}  // namespace sheetmorph
