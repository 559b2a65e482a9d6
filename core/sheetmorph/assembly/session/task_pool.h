// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"

#include <functional>
#include <string>
#include <vector>

namespace sheetmorph
{

//! One independent piece of pre-processing.
struct Task
{
    std::string name;
    std::function<void(const Progress&)> work;
};

//! Runs independent tasks on all cores; progress is reported by the calling thread alone.
//! \throws Cancelled        if the progress callback asks for it, after the running tasks end
//! \throws what a task threw, the first in the list of those that failed
void run_tasks(const std::vector<Task>& tasks, const Progress& progress);

}  // namespace sheetmorph
