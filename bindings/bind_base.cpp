// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/rigid_motion.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/base/threads/freed_memory.h"
#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"
#include "arrays.h"
#include "faults.h"
#include "layers.h"

namespace py = pybind11;

namespace sheetmorph
{

namespace
{

// Raised with every change of the module's interface; the package and the workbench compare it.
constexpr int kernel_api = 1;

py::function without_traceback(const py::function& method)
{
    const auto raise = [method](const py::args& arguments)
    {
        const py::object error = method(*arguments);
        if (error.is_none())
            return;
        PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
        throw py::error_already_set();
    };
    return py::cpp_function(raise);
}

void bind_errors(py::module_& module)
{
    const py::module_ errors = py::module_::import("sheetmorph.base.errors");
    py::register_exception<InvalidInput>(module, "InvalidInput", errors.attr("InputError"));
    py::register_exception<SolverError>(module, "SolverError", errors.attr("FailedError"));
    py::register_exception_translator(translate_errors);
    py::register_exception<Cancelled>(module, "Cancelled", errors.attr("FailedError"));
    module.def(
        "without_traceback", &without_traceback, py::arg("method"),
        "A function that raises the exception that `method` returns, None for none. It comes "
        "without a traceback, which every Python function in between would add to.");
}

py::dict abi_info()
{
    py::dict info;
    info["version"] = SHEETMORPH_VERSION;
    info["kernel_api"] = kernel_api;
    info["python"] = PY_VERSION;
    info["compiler"] = __VERSION__;
    info["linear_algebra"] = numerics::linear_algebra_version();
    return info;
}

RigidMotion motion_from(const py::handle& translation, const py::handle& rotation_log,
                        const py::handle& pivot)
{
    RigidMotion motion;
    motion.translation = vector_from(translation, "translation");
    motion.rotation_log = vector_from(rotation_log, "rotation_log");
    motion.pivot = vector_from(pivot, "pivot");
    return motion;
}

void bind_rigid_motion(py::module_& module)
{
    const py::tuple zero = py::make_tuple(0.0, 0.0, 0.0);
    py::class_<RigidMotion>(module, "RigidMotion",
                            "A turn about a pivot, then a shift (mm): "
                            "p -> pivot + translation + R (p - pivot).")
        .def(py::init(&motion_from), py::arg("translation") = zero, py::arg("rotation_log") = zero,
             py::arg("pivot") = zero,
             "All (3,): mm, rotation logarithm (theta / 2) axis in radians (2.6), mm.")
        .def_property_readonly("translation",
                               [](const RigidMotion& m) { return to_numpy(m.translation); })
        .def_property_readonly("rotation_log",
                               [](const RigidMotion& m) { return to_numpy(m.rotation_log); })
        .def_property_readonly("pivot", [](const RigidMotion& m) { return to_numpy(m.pivot); })
        .def_property_readonly("rotation",
                               [](const RigidMotion& m) { return to_numpy(m.rotation()); })
        .def(
            "apply",
            [](const RigidMotion& motion, const py::object& points)
            { return to_numpy(motion.apply(points_from(points, "points"))); },
            py::arg("points"), "(n, 3) float64 points moved, mm.");
}

}  // namespace

void bind_base(py::module_& module)
{
    module.attr("__version__") = SHEETMORPH_VERSION;
    module.attr("KERNEL_API") = kernel_api;
    module.def("abi_info", &abi_info, "What the kernel was built with, for reports.");
    module.def("return_freed_memory", &return_freed_memory,
               py::call_guard<py::gil_scoped_release>(),
               "Returns freed memory to the system. glibc would keep it.");
    bind_errors(module);
    bind_rigid_motion(module);
    module.def(
        "rotation_log",
        [](const py::object& axis, double radians)
        { return to_numpy(rotation_log(vector_from(axis, "axis"), radians)); },
        py::arg("axis"), py::arg("radians"),
        "Quaternion logarithm (theta / 2) v of a turn (2.6), (3,). Angles beyond half a turn are "
        "kept. Raises InvalidInput for an axis without length.");
    module.def(
        "rotation_matrix",
        [](const py::object& log) { return to_numpy(rotation_from_log(vector_from(log, "log"))); },
        py::arg("log"), "The (3, 3) rotation about log / |log| by the angle 2 |log|.");
}

}  // namespace sheetmorph
