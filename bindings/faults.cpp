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

py::tuple subjects_of(const py::module_& errors, const std::vector<Subject>& subjects)
{
    py::list found;
    for (const Subject& subject : subjects)
        found.append(errors.attr("Subject")(subject.kind, subject.name));
    return found;
}

py::tuple numbered(const Fault& fault)
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
    const py::module_ errors = py::module_::import("sheetmorph.base.errors");
    const std::vector<Subject>& subjects = fault.what.subjects();
    const py::object found =
        errors.attr("Fault")(fault.part.empty() ? "" : "part '" + fault.part + "'",
                             fault.what.full(fault.ids), fault.todo, name_of(fault.code),
                             subjects_of(errors, subjects.empty() ? fault.on : subjects),
                             numbered(fault), fault.what.brief());
    py::object error = type(found.attr("what"), found.attr("todo"), found.attr("where"));
    error.attr("faults") = py::make_tuple(found);
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
