// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/progress.h"
#include "sheetmorph/base/threads/stopping.h"

#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <string>

namespace sheetmorph::cad
{

//! Set by the thread that reports, read by those that work.
using StopFlag = std::atomic<bool>;

//! Throws Cancelled once the flag is set; no flag: never.
inline void stop_if(const StopFlag* flag)
{
    if (flag != nullptr && flag->load(std::memory_order_relaxed))
        throw Cancelled();
}

//! Does work(flag) in another thread and reports meanwhile, several times a second: long work of
//! OpenCASCADE has no place to report from. Where the report cancels or throws, or this thread is
//! to stop, the flag is set, and it throws when the work has ended.
//! \param work  must look at the flag, and throw Cancelled or return early
template <typename Work>
auto stoppable(const Progress& progress, double fraction, const std::string& task, Work&& work)
{
    StopFlag flag{false};
    auto found = std::async(std::launch::async, [&] { return work(flag); });
    try
    {
        while (found.wait_for(std::chrono::milliseconds(100)) == std::future_status::timeout)
        {
            progress.report(fraction, task);
            look_for_stop();
        }
    }
    catch (...)
    {
        flag = true;
        found.wait();
        throw;
    }
    return found.get();
}

}  // namespace sheetmorph::cad
