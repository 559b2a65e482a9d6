// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/base/threads/stopping.h"

#include <memory>
#include <pybind11/pybind11.h>

namespace sheetmorph
{

//! Surrounds every kernel call that may take long. It releases the GIL, and lets Ctrl-C or a
//! callback that returns False cancel the call. The callback runs in the calling thread alone:
//! Python may collect garbage in it, and widgets must be destroyed in the window's thread.
class LongWork
{
public:
    //! \param callback  (fraction, task) -> anything; False cancels. None: no progress. It must
    //!                  outlive this object.
    explicit LongWork(const pybind11::object& callback = pybind11::none());

    //! Reports to the callback.
    const Progress& progress() const { return progress_; }

private:
    struct Report;
    std::shared_ptr<Report> report_;
    Progress progress_;
    pybind11::gil_scoped_release released_;
    StopSignal stop_;
};

}  // namespace sheetmorph
