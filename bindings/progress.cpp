// SPDX-License-Identifier: LGPL-2.1-or-later
#include "progress.h"

#include "sheetmorph/base/errors.h"

#include <string>
#include <thread>

namespace py = pybind11;

namespace sheetmorph
{

//! The callback and the arguments of its last call.
struct LongWork::Report
{
    bool call() const
    {
        const py::object answer = (*callback)(fraction, task);
        return answer.is_none() || PyObject_IsTrue(answer.ptr()) != 0;
    }

    // Signals first: Ctrl-C must work before the first report, too.
    void check() const
    {
        const py::gil_scoped_acquire gil;
        if (PyErr_CheckSignals() != 0)
            throw py::error_already_set();
        if (!task.empty() && !call())
            throw Cancelled();
    }

    const py::object* callback;
    const std::thread::id caller = std::this_thread::get_id();
    double fraction = 0.0;
    std::string task = {};
};

LongWork::LongWork(const py::object& callback)
    : report_(std::make_shared<Report>(Report{&callback})),
      stop_([report = report_] { report->check(); })
{
    if (callback.is_none())
        return;
    progress_ = Progress(
        [report = report_](double fraction, const std::string& task)
        {
            if (std::this_thread::get_id() != report->caller)
                return true;
            const py::gil_scoped_acquire gil;
            report->fraction = fraction;
            report->task = task;
            return report->call();
        });
}

}  // namespace sheetmorph
