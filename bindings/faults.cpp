// SPDX-License-Identifier: LGPL-2.1-or-later
#include "faults.h"

namespace py = pybind11;

namespace sheetmorph
{

namespace
{

const char* name_of(FaultCode code)
{
    switch (code)
    {
        case FaultCode::unheld:
            return "unheld";
        case FaultCode::overlap:
            return "overlap";
        case FaultCode::torn:
            return "torn";
        case FaultCode::other:
            break;
    }
    return "other";
}

py::list pairs_of(const std::vector<Subject>& subjects)
{
    py::list pairs;
    for (const Subject& subject : subjects)
        pairs.append(py::make_tuple(subject.kind, subject.name));
    return pairs;
}

py::list numbered(const Fault& fault)
{
    py::list numbers;
    for (const int vertex : fault.what.vertices())
        numbers.append(static_cast<std::size_t>(vertex) < fault.ids.size()
                           ? fault.ids[static_cast<std::size_t>(vertex)]
                           : vertex);
    return numbers;
}

void set_error(const py::handle& type, const Fault& fault)
{
    py::object error = type(fault.sentence());
    const std::vector<Subject>& subjects = fault.what.subjects();
    error.attr("what") = fault.what.full(fault.ids);
    error.attr("brief") = fault.what.brief();
    error.attr("todo") = fault.todo;
    error.attr("code") = name_of(fault.code);
    error.attr("where") = fault.part.empty() ? "" : "part '" + fault.part + "'";
    error.attr("objects") = pairs_of(subjects.empty() ? fault.on : subjects);
    error.attr("vertices") = numbered(fault);
    PyErr_SetObject(type.ptr(), error.ptr());
}

}  // namespace

void translate_errors(std::exception_ptr thrown)
{
    const auto type = [](const char* name)
    { return py::module_::import("sheetmorph._core").attr(name); };
    try
    {
        std::rethrow_exception(std::move(thrown));
    }
    catch (const InvalidInput& error)
    {
        set_error(type("InvalidInput"), error.fault());
    }
    catch (const Cancelled& error)
    {
        PyErr_SetString(py::object(type("Cancelled")).ptr(), error.what());
    }
    catch (const SolverError& error)
    {
        set_error(type("SolverError"), error.fault());
    }
}

}  // namespace sheetmorph
