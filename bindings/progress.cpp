// SPDX-License-Identifier: LGPL-2.1-or-later
#include "progress.h"

#include <thread>

namespace py = pybind11;

namespace sheetmorph
{

Progress progress_from(const py::object& callback)
{
    if (callback.is_none())
        return {};
    const std::thread::id caller = std::this_thread::get_id();
    return Progress(
        [&callback, caller](double fraction, const std::string& task)
        {
            if (std::this_thread::get_id() != caller)
                return true;
            const py::gil_scoped_acquire gil;
            const py::object answer = callback(fraction, task);
            return answer.is_none() || PyObject_IsTrue(answer.ptr()) != 0;
        });
}

}  // namespace sheetmorph
