// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <functional>

namespace sheetmorph
{

//! Calls work(begin, end) on disjoint ranges that cover 0 .. count - 1, on several threads.
//! An exception of any range is rethrown here, the first range's first.
//! \param threads  at most so many; 0 for as many as the machine has
void parallel_ranges(Eigen::Index count, int threads,
                     const std::function<void(Eigen::Index begin, Eigen::Index end)>& work);

//! Threads for items of a microsecond or so: one where starting another would cost more.
int threads_for(Eigen::Index count);

}  // namespace sheetmorph
