// SPDX-License-Identifier: LGPL-2.1-or-later
#include "progress.h"

#include "sheetmorph/base/errors.h"

#include <string>
#include <thread>

namespace py = pybind11;

namespace sheetmorph
{

//! The callback and what it was called with last.
struct LongWork::Told
{
    bool call() const
    {
        const py::object answer = (*callback)(fraction, task);
        return answer.is_none() || PyObject_IsTrue(answer.ptr()) != 0;
    }

    // Signals first: they are due even if there is nothing to repeat.
    void ask() const
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
    : told_(std::make_shared<Told>(Told{&callback})), stop_([told = told_] { told->ask(); })
{
    if (callback.is_none())
        return;
    progress_ = Progress(
        [told = told_](double fraction, const std::string& task)
        {
            if (std::this_thread::get_id() != told->caller)
                return true;
            const py::gil_scoped_acquire gil;
            told->fraction = fraction;
            told->task = task;
            return told->call();
        });
}

}  // namespace sheetmorph
