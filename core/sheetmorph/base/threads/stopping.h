// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <thread>

namespace sheetmorph
{

//! Cancels a long call from inside. While a StopSignal exists, look_for_stop() in its thread runs
//! the check, at most once per pause. Pool threads that help with the call never run the check.
//! After it has thrown, they end with the same exception.
class StopSignal
{
public:
    //! Throws to cancel the call; the exception reaches its caller.
    using Check = std::function<void()>;

    explicit StopSignal(Check check,
                        std::chrono::milliseconds pause = std::chrono::milliseconds(100));
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    //! The signal of this thread, or nullptr.
    static StopSignal* current();

    //! \throws what the check threw, now or earlier
    void look();

    //! Cancels the work of all threads with this exception.
    void end(std::exception_ptr reason);

private:
    const Check check_;
    const std::chrono::milliseconds pause_;
    const std::thread::id owner_;
    StopSignal* const outer_;
    std::chrono::steady_clock::time_point next_;  // only the owner uses it
    std::exception_ptr reason_;
    std::atomic<bool> is_ended_{false};
};

//! During its lifetime, this thread obeys the signal of another thread.
class WorkFor
{
public:
    explicit WorkFor(StopSignal* signal);
    ~WorkFor();
    WorkFor(const WorkFor&) = delete;
    WorkFor& operator=(const WorkFor&) = delete;

private:
    StopSignal* const before_;
};

//! Call this in every loop that may take longer than 0.1 s. It costs a few nanoseconds.
//! \throws what the check of this thread's signal threw
void look_for_stop();

}  // namespace sheetmorph
