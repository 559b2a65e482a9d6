// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <atomic>
#include <functional>
#include <memory>

namespace sheetmorph
{

//! The threads behind parallel.h. A waiting thread waits only for started items of its own job, so
//! nested jobs never wait in a circle.
//!
//! oneTBB 2021.8 in place of this pool (measured in 2026 on two cores): live frames of 1,000 to
//! 100,000 vertices equally fast, those of control meshes with 10 % more processor time, results
//! the same bits. But a forked process, as Python's multiprocessing starts it, waits for ever for
//! threads that it does not have, and a thread that waits cannot look for Ctrl-C.
class ThreadPool
{
public:
    using Work = std::function<void(Eigen::Index item)>;
    using Watch = std::function<void(Eigen::Index done)>;

    //! The pool of the process. A second one would compete for its cores.
    static ThreadPool& common();

    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    //! Number of threads that share work, including the calling one.
    int threads() const { return threads_; }
    void set_threads(int threads);

    //! Runs all items on the calling thread and on free threads.
    //! \throws what the first failing item threw; later items may not have started
    void run(Eigen::Index count, const Work& work);

    //! Runs all items on the pool's threads, while the calling thread calls watch() from time to
    //! time. If watch() throws, items that have not started are skipped.
    void run_watched(Eigen::Index count, const Work& work, const Watch& watch);

    //! Whether run_watched() has threads to run on: there are at least two, and the calling thread
    //! is not one of the pool.
    bool can_watch() const;

private:
    struct Job;
    struct Shared;
    ThreadPool();

    std::atomic<int> threads_;
    std::shared_ptr<Shared> shared_;  // the threads share and keep it
};

}  // namespace sheetmorph
