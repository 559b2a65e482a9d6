// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <thread>

namespace sheetmorph
{

//! Ends the work of a thread from inside, however deep it is. While a StopSignal lives, every
//! look_for_stop() in its thread asks whether to go on, at most once per pause. Threads of the pool
//! that help with the work look too: they never ask, and end with the same exception.
class StopSignal
{
public:
    //! Throws to end the work; the exception reaches whoever started it.
    using Ask = std::function<void()>;

    explicit StopSignal(Ask ask, std::chrono::milliseconds pause = std::chrono::milliseconds(100));
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    //! The signal of the work that this thread does, or nullptr.
    static StopSignal* current();

    //! \throws what `ask` threw, now or before
    void look();

    //! Ends the work of all threads with this exception.
    void end(std::exception_ptr reason);

private:
    const Ask ask_;
    const std::chrono::milliseconds pause_;
    const std::thread::id owner_;
    StopSignal* const outer_;
    std::chrono::steady_clock::time_point next_;  // of the owner
    std::exception_ptr reason_;
    std::atomic<bool> is_ended_{false};
};

//! This thread works for a signal of another thread while it lives.
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

//! Every loop that can take longer than a tenth of a second calls this. It costs some nanoseconds.
//! \throws whatever ends the work
void look_for_stop();

}  // namespace sheetmorph
