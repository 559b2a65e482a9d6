// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/task_pool.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace sheetmorph
{

namespace
{

class TaskPool
{
public:
    explicit TaskPool(const std::vector<Task>& tasks) : tasks_(tasks), failures_(tasks.size())
    {
        const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
        for (std::size_t k = 0; k < std::min(cores, tasks.size()); ++k)
            workers_.emplace_back([this] { work(); });
    }
    TaskPool(const TaskPool&) = delete;
    TaskPool& operator=(const TaskPool&) = delete;

    // Joins the workers; tasks that have not begun are left out.
    ~TaskPool()
    {
        next_ = tasks_.size();
        for (std::thread& worker : workers_)
            worker.join();
    }

    void wait(const Progress& progress)
    {
        std::unique_lock<std::mutex> lock(mutex_);
        while (done_ < tasks_.size())
        {
            progress.report(static_cast<double>(done_) / static_cast<double>(tasks_.size()),
                            "preparing " + latest_);
            changed_.wait_for(lock, std::chrono::milliseconds(100));
        }
        for (const std::exception_ptr& failure : failures_)
            if (failure)
                std::rethrow_exception(failure);
    }

private:
    void work()
    {
        for (std::size_t task = next_++; task < tasks_.size(); task = next_++)
        {
            std::exception_ptr failure;
            try
            {
                tasks_[task].work(Progress());
            }
            catch (...)
            {
                failure = std::current_exception();
            }
            const std::lock_guard<std::mutex> lock(mutex_);
            failures_[task] = failure;
            latest_ = tasks_[task].name;
            ++done_;
            changed_.notify_one();
        }
    }

    const std::vector<Task>& tasks_;
    std::vector<std::exception_ptr> failures_;
    std::atomic<std::size_t> next_{0};
    std::size_t done_ = 0;
    std::string latest_ = "parts";
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<std::thread> workers_;
};

}  // namespace

void run_tasks(const std::vector<Task>& tasks, const Progress& progress)
{
    if (tasks.size() == 1)
    {
        tasks.front().work(progress);
        return;
    }
    TaskPool(tasks).wait(progress);
}

}  // namespace sheetmorph
