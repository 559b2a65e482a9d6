// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/search/triangle_queries.h"
#include "sheetmorph/pick/neighbourhood.h"
#include "sheetmorph/pick/sight.h"
#include "arrays.h"
#include "layers.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <algorithm>

namespace py = pybind11;

namespace sheetmorph
{

using namespace mesh;
using namespace pick;

namespace
{

using RowMatrix4 = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
using Released = py::call_guard<py::gil_scoped_release>;

void bind_first_hit(py::module_& module)
{
    module.def(
        "first_hit",
        [](const Eigen::Ref<const Points>& points, const Eigen::Ref<const Triangles>& triangles,
           const py::object& origin, const py::object& direction)
        {
            return first_hit(points, triangles, vector_from(origin, "origin"),
                             vector_from(direction, "direction"));
        },
        py::arg("points"), py::arg("triangles"), py::arg("origin"), py::arg("direction"),
        "What PickingTree.nearest_hit answers, without a tree: for (n, 3) float64 mm and (m, 3) "
        "int32 that are asked once.");
}

void bind_sight(py::module_& module)
{
    py::class_<Screen>(module, "Screen", "How a camera maps space to the screen.")
        .def(py::init([](const Eigen::Ref<const RowMatrix4>& to_clip, double width, double height)
                      { return Screen(to_clip, width, height); }),
             py::arg("to_clip"), py::arg("width"), py::arg("height"),
             "to_clip: (4, 4) from (x, y, z, 1), mm, to OpenGL's clip coordinates; width and "
             "height of the view, px.")
        .def(
            "seen",
            [](const Screen& screen, const py::object& point)
            { return to_numpy(screen.seen(vector_from(point, "point"))); },
            py::arg("point"),
            "(3,) float64: px from the lower left corner, and the depth from -1 (near) to 1 (far); "
            "infinite behind the eye.");
    module.def(
        "vertices_inside",
        [](const PickingTree& tree, const Screen& screen, const ScreenPoints& outline)
        { return to_numpy(vertices_inside(tree, screen, ScreenOutline(outline))); },
        py::arg("tree"), py::arg("screen"), py::arg("outline"),
        "The vertices seen inside a closed outline (k, 2), px, hidden ones too: (k,) int32, "
        "ascending.");
    module.def(
        "visible_vertices",
        [](const PickingTree& tree, const py::object& vertices, const Screen& screen,
           const std::vector<const PickingTree*>& shapes)
        {
            const VertexIds ids = ids_from(vertices, "vertices");
            if (std::count(shapes.begin(), shapes.end(), nullptr) > 0)
                throw py::type_error("shapes must hold PickingTrees; one of them is None");
            return to_numpy(visible_vertices(tree, ids, screen, shapes));
        },
        py::arg("tree"), py::arg("vertices"), py::arg("screen"), py::arg("shapes"),
        "Those of the vertices of a PickingTree that no triangle of the shapes, a list of "
        "PickingTrees, hides: (k,) int32, ascending.");
}

using NeighbourhoodClass = py::class_<Neighbourhood>;

void bind_pieces(NeighbourhoodClass& neighbourhood)
{
    neighbourhood
        .def(
            "pieces",
            [](const Neighbourhood& self, const py::object& vertices)
            { return to_lists(self.pieces(ids_from(vertices, "vertices"))); },
            py::arg("vertices"),
            "The connected pieces of some vertices: list of (k,) int32, each ascending.")
        .def(
            "rims",
            [](const Neighbourhood& self, double crease) { return to_lists(self.rims(crease)); },
            py::arg("crease"),
            "The closed loops of edges at which the sheet ends, or bends by `crease` radians or "
            "more: list of (k,) int32, each in order.");
}

void bind_neighbourhood(py::module_& module)
{
    NeighbourhoodClass neighbourhood(
        module, "Neighbourhood",
        "What grows from vertices and triangles of one mesh, from tables.");
    bind_pieces(neighbourhood);
    neighbourhood.def(py::init<const TriangleMesh&>(), py::arg("mesh"), Released())
        .def(
            "triangles_at",
            [](const Neighbourhood& self, const py::object& vertices)
            { return to_numpy(self.triangles_at(ids_from(vertices, "vertices"))); },
            py::arg("vertices"), "The triangles with a corner among the vertices, ascending.")
        .def(
            "grown",
            [](const Neighbourhood& self, const py::object& vertices, int rings)
            { return to_numpy(self.grown(ids_from(vertices, "vertices"), rings)); },
            py::arg("vertices"), py::arg("rings"), "As grow_rings.")
        .def(
            "shrunk",
            [](const Neighbourhood& self, const py::object& vertices, int rings)
            { return to_numpy(self.shrunk(ids_from(vertices, "vertices"), rings)); },
            py::arg("vertices"), py::arg("rings"), "As shrink_rings.")
        .def(
            "face",
            [](const Neighbourhood& self, int triangle, double max_angle)
            { return to_numpy(self.face(triangle, max_angle)); },
            py::arg("triangle"), py::arg("max_angle"), "As grow_to_creases.")
        .def(
            "piece",
            [](const Neighbourhood& self, int triangle) { return to_numpy(self.piece(triangle)); },
            py::arg("triangle"), "As connected_triangles.");
}

}  // namespace

void bind_pick(py::module_& module)
{
    bind_sight(module);
    bind_first_hit(module);
    bind_neighbourhood(module);
}

}  // namespace sheetmorph
