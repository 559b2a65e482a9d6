// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace sheetmorph
{

//! All parallel work uses these functions, and the process has one pool of threads, which sleep
//! without work. Work may start further work. An exception reaches the caller after all started
//! items have ended. With any number of threads, it is the exception of the first failing item. The
//! division of work does not depend on the number of threads either, so results are the same bits.

//! Number of threads that share work, including the calling one: SHEETMORPH_THREADS, else the cores
//! that this process may use.
int thread_count();

//! Changes the number of threads during its lifetime, for tests and measurements.
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
//! \param least  fewest items of a range, unless there are fewer in total; about ten microseconds
//!     of work
void parallel_ranges(Eigen::Index count, Eigen::Index least,
                     const std::function<void(Eigen::Index begin, Eigen::Index end)>& work);

//! Runs two functions in parallel.
void parallel_pair(const std::function<void()>& one, const std::function<void()>& other);

//! One independent piece of a long work.
struct Task
{
    std::string name;                           //!< current task, as shown to the user
    std::function<void(const Progress&)> work;  //!< checks for cancellation through its argument
};

//! Runs independent tasks; only the calling thread reports to `progress`.
//! \throws Cancelled  if the progress callback requests it, after the running tasks end
void run_tasks(const std::vector<Task>& tasks, const Progress& progress);

}  // namespace sheetmorph
