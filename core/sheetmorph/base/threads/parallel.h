// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace sheetmorph
{

//! All work on threads goes through here: one pool of threads for the process, which sleep until
//! there is something to do. Work may start further work. Exceptions reach the caller, once all
//! that has begun has ended: the one that the first item in the list has thrown, whatever the
//! number of threads. How work is cut does not depend on that number either, so results are the
//! same bits with any.

//! How many threads share work, the calling one among them: SHEETMORPH_THREADS, else the cores
//! that this process may run on.
int thread_count();

//! Another number of threads while it lives, for tests and measurements.
class ThreadCount
{
public:
    explicit ThreadCount(int threads);
    ~ThreadCount();
    ThreadCount(const ThreadCount&) = delete;
    ThreadCount& operator=(const ThreadCount&) = delete;

private:
    int before_;
};

//! Calls work(item) for 0 .. count - 1, in any order and at the same time.
void parallel_items(Eigen::Index count, const std::function<void(Eigen::Index item)>& work);

//! Items of a microsecond each in one range. Chosen: several times the 30 microseconds that waking
//! a thread takes (thread_pool.cpp).
constexpr Eigen::Index microsecond_items = 200;

//! Calls work(begin, end) on disjoint ranges that cover 0 .. count - 1.
//! \param least  items of a range, at least, unless there are fewer: some ten microseconds of work
void parallel_ranges(Eigen::Index count, Eigen::Index least,
                     const std::function<void(Eigen::Index begin, Eigen::Index end)>& work);

//! Both at the same time.
void parallel_pair(const std::function<void()>& one, const std::function<void()>& other);

//! One independent piece of a long work.
struct Task
{
    std::string name;                           //!< what is being done, as the user is told
    std::function<void(const Progress&)> work;  //!< reports to be cancelled
};

//! Runs independent tasks; only the calling thread reports to `progress`.
//! \throws Cancelled  if the progress callback asks for it, after the running tasks end
void run_tasks(const std::vector<Task>& tasks, const Progress& progress);

}  // namespace sheetmorph
