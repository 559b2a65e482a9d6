// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/errors.h"
#include "sheetmorph/surface/flat/flattening.h"
#include "arrays.h"
#include "layers.h"
#include "progress.h"

#include <pybind11/stl.h>

namespace py = pybind11;

namespace sheetmorph
{

using namespace surface;

namespace
{

std::pair<py::object, std::vector<double>> neutral_from(const py::object& neutral)
{
    try
    {
        return neutral.cast<std::pair<py::object, std::vector<double>>>();
    }
    catch (const py::cast_error&)
    {
        throw InvalidInput("neutral must be a pair of directions (m, 3) and numbers (m,)");
    }
}

Flattening flattened(const mesh::TriangleMesh& mesh, const std::vector<VertexIds>& rims,
                     const py::object& neutral, const py::object& callback)
{
    FlatInput input{mesh, rims};
    if (!neutral.is_none())
    {
        const auto [directions, factors] = neutral_from(neutral);
        input.directions = points_from(directions, "directions");
        input.factors = Eigen::Map<const Eigen::VectorXd>(
            factors.data(), static_cast<Eigen::Index>(factors.size()));
    }
    const LongWork work(callback);
    return flatten(input, work.progress());
}

py::object places_of(const Flattening& flat)
{
    Points places = Points::Zero(flat.positions.rows(), 3);
    places.leftCols<2>() = flat.positions;
    return to_numpy(std::move(places));
}

}  // namespace

void bind_flat(py::module_& module)
{
    py::class_<Flattening>(module, "Flattening", "A sheet laid flat.")
        .def_property_readonly("positions", &places_of,
                               "(n, 3) mm with z = 0, seen from the side that its normals point to")
        .def_property_readonly(
            "unsettled", [](const Flattening& flat) { return flat.convergence.sentence(); },
            "empty, or what was not solved to its end")
        .def_property_readonly(
            "is_rigid",
            [](const Flattening& flat)
            { return std::vector<bool>(flat.is_rigid.begin(), flat.is_rigid.end()); },
            "by rim: it was plane, and kept its form")
        .def_readonly("turned", &Flattening::turned, "triangles that had to be turned over")
        .def_readonly("flipped", &Flattening::flipped, "triangles that came out upside down");
    module.def("flatten", &flattened, py::arg("mesh"), py::arg("rims"),
               py::arg("neutral") = py::none(), py::arg("progress") = py::none(),
               "Lays a sheet of one piece flat with as little stretch as it can; plane rims (lists "
               "of vertices) keep their form. neutral: (directions (m, 3), factors (m,)), how much "
               "longer each triangle is along one once it is flat. Raises InvalidInput.");
}

}  // namespace sheetmorph
