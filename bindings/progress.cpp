// SPDX-License-Identifier: LGPL-2.1-or-later
#include "progress.h"

namespace py = pybind11;

namespace sheetmorph
{

Progress progress_from(const py::object& callback)
{
    if (callback.is_none())
        return {};
    return Progress(
        [&callback](double fraction, const std::string& task)
        {
            const py::gil_scoped_acquire gil;
            const py::object answer = callback(fraction, task);
            return answer.is_none() || PyObject_IsTrue(answer.ptr()) != 0;
        });
}

}  // namespace sheetmorph
