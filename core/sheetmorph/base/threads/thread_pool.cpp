// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/threads/thread_pool.h"

#include "sheetmorph/base/threads/stopping.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sched.h>
#endif
#ifndef _WIN32
#include <pthread.h>
#endif

namespace sheetmorph
{

namespace
{

// A thread that has just worked, or waits for short work, spins for this long before it sleeps.
// Chosen: waking a thread takes about as long.
constexpr std::chrono::microseconds looking{30};

constexpr std::chrono::milliseconds between_looks{100};  // chosen: a stop within 0.1 s

thread_local bool is_of_pool = false;

// A batch system may restrict a process to fewer cores than the machine has.
int cores_of_process()
{
#ifdef __linux__
    cpu_set_t cores;
    CPU_ZERO(&cores);
    if (sched_getaffinity(0, sizeof cores, &cores) == 0)
        return CPU_COUNT(&cores);
#endif
    return static_cast<int>(std::max(std::thread::hardware_concurrency(), 1U));
}

int threads_wanted()
{
    const char* const told = std::getenv("SHEETMORPH_THREADS");
    const int threads = told != nullptr ? std::atoi(told) : 0;
    return threads > 0 ? threads : cores_of_process();
}

// Spins until the condition holds, for a limited time. Returns whether it holds.
template <typename Condition>
bool holds_soon(const Condition& condition)
{
    const auto end = std::chrono::steady_clock::now() + looking;
    while (!condition())
    {
        if (std::chrono::steady_clock::now() > end)
            return false;
        std::this_thread::yield();
    }
    return true;
}

}  // namespace

//! The items of one call. Items start in order, so all items before a failed one have started too.
struct ThreadPool::Job
{
    Job(Eigen::Index items, const Work& done_by, int places)
        : count(items), work(done_by), stop(StopSignal::current()), free_places(places)
    {
    }

    void give_up() { next = count; }
    bool has_begun() const { return next >= count; }

    void work_on()
    {
        const WorkFor caller(stop);
        for (Eigen::Index item = next++; item < count; item = next++)
            try
            {
                look_for_stop();
                work(item);
                ++done;
            }
            catch (...)
            {
                fail(item);
            }
    }

    //! Ends the job with the current exception.
    void fail(Eigen::Index item)
    {
        give_up();
        const std::lock_guard<std::mutex> lock(failing);
        if (!failure || item < failed)
        {
            failure = std::current_exception();
            failed = item;
        }
    }

    //! Throws the exception in the calling thread. A pool thread that still refers to the job must
    //! not destroy a Python exception.
    void rethrow()
    {
        if (failure)
            std::rethrow_exception(std::exchange(failure, nullptr));
    }

    const Eigen::Index count;
    const Work& work;
    StopSignal* const stop;  // of the calling thread
    std::atomic<Eigen::Index> next{0}, done{0};
    std::atomic<int> helpers{0};  // threads that work on it
    int free_places;              // for further threads
    std::mutex failing;
    std::exception_ptr failure;
    Eigen::Index failed = 0;
};

//! The state that all threads share and keep alive.
struct ThreadPool::Shared : std::enable_shared_from_this<Shared>
{
    //! The newest job with free places and items left: others wait for it, or a user waits for its
    //! frame.
    std::shared_ptr<Job> take()
    {
        for (auto job = open.rbegin(); job != open.rend(); ++job)
            if ((*job)->free_places > 0 && !(*job)->has_begun())
            {
                --(*job)->free_places;
                ++(*job)->helpers;
                return *job;
            }
        return nullptr;
    }

    //! Offers the job to the threads. Returns their number; 0 if the system starts none.
    int offer(const std::shared_ptr<Job>& job)
    {
        const std::lock_guard<std::mutex> lock(mutex);
        grow(job->free_places);
        open.push_back(job);
        ++opened;
        for (int helper = 0; helper < job->free_places; ++helper)
            offered.notify_one();
        return threads;
    }

    void grow(int wanted)
    {
        try
        {
            for (; threads < wanted; ++threads)
                std::thread([own = shared_from_this()] { own->serve(); }).detach();
        }
        catch (const std::system_error&)
        {
            // Continues with the threads that exist, or with the calling one alone.
        }
    }

    void close(const std::shared_ptr<Job>& job)
    {
        const std::lock_guard<std::mutex> lock(mutex);
        open.erase(std::remove(open.begin(), open.end(), job), open.end());
    }

    //! Waits for a while. Returns whether all items have ended.
    bool is_over(const Job& job)
    {
        std::unique_lock<std::mutex> lock(mutex);
        return left.wait_for(lock, between_looks,
                             [&] { return job.has_begun() && job.helpers == 0; });
    }

    //! Closes the job to further threads, waits for those that work on it, and checks for
    //! cancellation meanwhile.
    void finish(const std::shared_ptr<Job>& job)
    {
        close(job);
        const auto is_left = [&] { return job->helpers == 0; };
        if (holds_soon(is_left))
            return;
        std::unique_lock<std::mutex> lock(mutex);
        while (!left.wait_for(lock, between_looks, is_left))
        {
            lock.unlock();
            look_for(*job);
            lock.lock();
        }
    }

    static void look_for(Job& job)
    {
        try
        {
            look_for_stop();
        }
        catch (...)
        {
            job.fail(job.count);
        }
    }

    //! The main function of a thread.
    void serve()
    {
        is_of_pool = true;
        std::unique_lock<std::mutex> lock(mutex);
        while (true)
            if (const std::shared_ptr<Job> job = take())
            {
                lock.unlock();
                job->work_on();
                lock.lock();
                if (--job->helpers == 0)
                    left.notify_all();
            }
            else
                await(lock);
    }

    //! Sleeps until another job is opened.
    void await(std::unique_lock<std::mutex>& lock)
    {
        const long seen = opened;
        const auto is_further = [&] { return opened != seen; };
        lock.unlock();
        const bool is_soon = holds_soon(is_further);
        lock.lock();
        if (!is_soon)
            offered.wait(lock, is_further);
    }

    std::mutex mutex;
    std::condition_variable offered, left;
    std::vector<std::shared_ptr<Job>> open;
    std::atomic<long> opened{0};  // number of jobs ever opened
    int threads = 0;
};

ThreadPool& ThreadPool::common()
{
    static ThreadPool pool;
    return pool;
}

ThreadPool::ThreadPool() : threads_(threads_wanted()), shared_(std::make_shared<Shared>())
{
#ifndef _WIN32
    // A forked process does not inherit the threads and starts its own.
    pthread_atfork(nullptr, nullptr,
                   []
                   {
                       common().shared_ = std::make_shared<Shared>();
                       common().threads_ = threads_wanted();
                   });
#endif
}

void ThreadPool::set_threads(int threads)
{
    threads_ = std::max(threads, 1);
}

bool ThreadPool::can_watch() const
{
    return !is_of_pool && threads_ > 1;
}

void ThreadPool::run(Eigen::Index count, const Work& work)
{
    const auto helpers = static_cast<int>(std::min<Eigen::Index>(count, threads_) - 1);
    if (helpers < 1)
    {
        for (Eigen::Index item = 0; item < count; ++item)
        {
            look_for_stop();
            work(item);
        }
        return;
    }
    const auto job = std::make_shared<Job>(count, work, helpers);
    const std::shared_ptr<Shared> shared = shared_;
    shared->offer(job);
    job->work_on();
    shared->finish(job);
    job->rethrow();
}

void ThreadPool::run_watched(Eigen::Index count, const Work& work, const Watch& watch)
{
    const auto helpers = static_cast<int>(std::min<Eigen::Index>(count, threads_));
    const auto job = std::make_shared<Job>(count, work, helpers);
    const std::shared_ptr<Shared> shared = shared_;
    if (shared->offer(job) == 0)
        job->work_on();
    try
    {
        while (!shared->is_over(*job))
        {
            watch(job->done);
            look_for_stop();
        }
    }
    catch (...)
    {
        job->give_up();
        if (StopSignal* const stop = StopSignal::current())
            stop->end(std::current_exception());
        shared->finish(job);
        throw;
    }
    shared->finish(job);
    job->rethrow();
}

}  // namespace sheetmorph
