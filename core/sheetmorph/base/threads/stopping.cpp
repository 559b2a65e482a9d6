// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/threads/stopping.h"

#include <utility>

namespace sheetmorph
{

namespace
{

// A thread-local signal, not a parameter: a single function that forgets to pass a parameter would
// make a call impossible to cancel.
thread_local StopSignal* of_this_thread = nullptr;

}  // namespace

StopSignal::StopSignal(Check check, std::chrono::milliseconds pause)
    : check_(std::move(check)),
      pause_(pause),
      owner_(std::this_thread::get_id()),
      outer_(of_this_thread),
      next_(std::chrono::steady_clock::now() + pause)
{
    of_this_thread = this;
}

StopSignal::~StopSignal()
{
    of_this_thread = outer_;
}

StopSignal* StopSignal::current()
{
    return of_this_thread;
}

void StopSignal::look()
{
    if (is_ended_.load(std::memory_order_acquire))
        std::rethrow_exception(reason_);
    if (std::this_thread::get_id() != owner_)
        return;
    const auto now = std::chrono::steady_clock::now();
    if (now < next_)
        return;
    next_ = now + pause_;
    try
    {
        check_();
    }
    catch (...)
    {
        end(std::current_exception());
        throw;
    }
}

void StopSignal::end(std::exception_ptr reason)
{
    if (std::this_thread::get_id() != owner_ || is_ended_)
        return;
    reason_ = std::move(reason);
    is_ended_.store(true, std::memory_order_release);
}

WorkFor::WorkFor(StopSignal* signal) : before_(std::exchange(of_this_thread, signal))
{
}

WorkFor::~WorkFor()
{
    of_this_thread = before_;
}

void look_for_stop()
{
    if (StopSignal* const signal = of_this_thread)
        signal->look();
}

}  // namespace sheetmorph
