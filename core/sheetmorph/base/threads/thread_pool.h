// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <atomic>
#include <functional>
#include <memory>

namespace sheetmorph
{

//! The threads behind parallel.h, which sleep until there is something to do. Whoever waits, waits
//! for items that others have begun of a job of his own: jobs within jobs never wait in a circle.
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

    //! The one of the process: more would fight for its cores.
    static ThreadPool& common();

    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    //! How many threads share work, the calling one among them.
    int threads() const { return threads_; }
    void set_threads(int threads);

    //! All items, on the calling thread and those that are free.
    //! \throws what the first item that failed threw; those after it may not have begun
    void run(Eigen::Index count, const Work& work);

    //! All items, on the pool's threads, while the calling one calls watch() from time to time. If
    //! it throws, items that have not begun are left out.
    void run_watched(Eigen::Index count, const Work& work, const Watch& watch);

    //! Whether run_watched() has threads to run on: there is more than one, and the calling one is
    //! not one of them.
    bool can_watch() const;

private:
    struct Job;
    struct Shared;
    ThreadPool();

    std::atomic<int> threads_;
    std::shared_ptr<Shared> shared_;  // with the threads, which keep it
};

}  // namespace sheetmorph
