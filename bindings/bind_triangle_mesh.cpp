// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/triangle_mesh.h"
#include "arrays.h"
#include "layers.h"

namespace py = pybind11;

namespace sheetmorph
{

using namespace mesh;

void bind_triangle_mesh(py::module_& module)
{
    py::class_<TriangleMesh>(module, "TriangleMesh",
                             "A mesh at rest: any triangles over any points, manifold or not.")
        .def(py::init(
                 [](const py::object& points, const py::object& triangles) {
                     return TriangleMesh(points_from(points, "points"),
                                         triangles_from(triangles, "triangles"));
                 }),
             py::arg("points"), py::arg("triangles"),
             "points (n, 3) float64 mm, triangles (m, 3) int32. Raises InvalidInput naming "
             "points that are not finite and indices out of range.")
        .def_property_readonly("points", [](const py::object& self)
                               { return view_of(self.cast<const TriangleMesh&>().points(), self); })
        .def_property_readonly("triangles", [](const TriangleMesh& mesh)
                               { return to_numpy(Triangles(mesh.triangles())); })
        .def_property_readonly("size", &TriangleMesh::size, "diagonal of the bounding box, mm");
}

}  // namespace sheetmorph
