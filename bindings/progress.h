// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/base/threads/stopping.h"

#include <memory>
#include <pybind11/pybind11.h>

namespace sheetmorph
{

//! Every call of the kernel that may take long is done while one of these lives: the GIL is
//! released, and the kernel ends wherever it looks for a stop (Ctrl-C, or a progress that returns
//! False). Python runs in the calling thread alone: in another one it may collect garbage, widgets
//! among it, which belong to the window's thread.
class LongWork
{
public:
    //! \param callback  (fraction, task) -> anything; False cancels. None: no progress. It must
    //!                  outlive the work.
    explicit LongWork(const pybind11::object& callback = pybind11::none());

    //! Reports to the callback.
    const Progress& progress() const { return progress_; }

private:
    struct Told;
    std::shared_ptr<Told> told_;
    Progress progress_;
    pybind11::gil_scoped_release released_;
    StopSignal stop_;
};

}  // namespace sheetmorph
