// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/cures.h"
#include "sheetmorph/repair/remeshing/remeshing.h"
#include "sheetmorph/repair/self_intersections.h"
#include "arrays.h"
#include "layers.h"
#include "progress.h"

#include <utility>

namespace py = pybind11;

namespace sheetmorph
{

using namespace repair;

namespace
{

void bind_cured(py::module_& module)
{
    py::class_<CuredMesh>(module, "CuredMesh", "A mesh after its cures.")
        .def_property_readonly(
            "points", [](const CuredMesh& cure) { return to_numpy(Points(cure.mesh.points())); },
            "(k, 3) mm")
        .def_property_readonly(
            "triangles",
            [](const CuredMesh& cure) { return to_numpy(Triangles(cure.mesh.triangles())); },
            "(l, 3)")
        .def_property_readonly(
            "vertex_of", [](const CuredMesh& cure) { return to_numpy(cure.vertex_of); },
            "(n,) of every vertex given: its place in `points`, -1 if gone")
        .def_property_readonly(
            "triangle_of", [](const CuredMesh& cure) { return to_numpy(cure.triangle_of); },
            "(l,) of every triangle: the one given it is part of")
        .def_readonly("welded", &CuredMesh::welded, "vertices that became one with another")
        .def_readonly("removed", &CuredMesh::removed, "triangles without height or doubled")
        .def_readonly("split", &CuredMesh::split, "triangles cut at T-junctions")
        .def_readonly("turned", &CuredMesh::turned, "triangles turned over")
        .def_property_readonly(
            "unsettled", [](const CuredMesh& cure) { return cure.convergence.sentence(); },
            "empty, or that the cuts did not end, and how far they got");
    module.def(
        "cured",
        [](const mesh::TriangleMesh& mesh, double tolerance)
        {
            const LongWork work;
            return cured(mesh, tolerance);
        },
        py::arg("mesh"), py::arg("tolerance"),
        "Weld vertices nearer than `tolerance` (mm), remove triangles without height and "
        "doubled ones, cut edges at T-junctions, orient each piece. Raises InvalidInput.");
}

void bind_self_intersections(py::module_& module)
{
    module.def(
        "self_intersections",
        [](const mesh::TriangleMesh& mesh)
        {
            std::vector<std::pair<int, int>> found;
            {
                const LongWork work;
                found = self_intersections(mesh);
            }
            VertexIds ids;
            for (const auto& [one, other] : found)
                ids.insert(ids.end(), {one, other});
            return py::array(to_numpy(ids))
                .reshape({static_cast<py::ssize_t>(found.size()), py::ssize_t{2}});
        },
        py::arg("mesh"),
        "The pairs of triangles, (k, 2) int32, that meet anywhere but in what they share "
        "(CGAL). Triangles without area do not count.");
}

void bind_remeshed_type(py::module_& module)
{
    py::class_<RemeshedMesh>(module, "RemeshedMesh", "A mesh made anew on the facets of another.")
        .def_property_readonly(
            "points", [](const RemeshedMesh& m) { return to_numpy(Points(m.mesh.points())); },
            "(n, 3) mm: the vertices given that are still in place, then new ones")
        .def_property_readonly(
            "triangles",
            [](const RemeshedMesh& m) { return to_numpy(Triangles(m.mesh.triangles())); }, "(m, 3)")
        .def_property_readonly(
            "triangle", [](const RemeshedMesh& m) { return to_numpy(m.triangle); },
            "(n,) the facet given that each vertex lies on")
        .def_property_readonly(
            "barycentric", [](const RemeshedMesh& m) { return to_numpy(Points(m.barycentric)); },
            "(n, 3) where on it; exact zeros on its edges and corners")
        .def_property_readonly(
            "vertex_of", [](const RemeshedMesh& m) { return to_numpy(m.vertex_of); },
            "(k,) of every vertex given: the vertex in or nearest its place, -1 if unused")
        .def_property_readonly(
            "is_kept",
            [](const RemeshedMesh& m)
            { return to_numpy(VertexIds(m.is_kept.begin(), m.is_kept.end())); },
            "(k,) 1 where that is exactly its place")
        .def_property_readonly(
            "patch", [](const RemeshedMesh& m) { return to_numpy(m.patch); },
            "(m,) the flat or curved region of every triangle")
        .def_readonly("flats", &RemeshedMesh::flats, "how many of these are flats")
        .def_readonly("circles", &RemeshedMesh::circles, "rims put on their fitted circles")
        .def_readonly("deviation", &RemeshedMesh::deviation,
                      "farthest the new mesh and the facets given are from each other, mm")
        .def_readonly("flat_deviation", &RemeshedMesh::flat_deviation, "the same on flats, mm")
        .def_readonly("least_edge", &RemeshedMesh::least_edge,
                      "mm: no shorter edges were made, to stay in proportion to what was given; 0 "
                      "if all that were wanted were made")
        .def_property_readonly(
            "unsettled", [](const RemeshedMesh& m) { return m.convergence.sentence(); },
            "empty, or that its edges did not settle, and how far they got");
}

}  // namespace

void bind_repair(py::module_& module)
{
    bind_cured(module);
    bind_self_intersections(module);
    bind_remeshed_type(module);
    module.def(
        "remeshed",
        [](const mesh::TriangleMesh& mesh, double edge, bool are_rims_on_circles,
           const py::object& progress)
        {
            RemeshOptions options;
            options.edge = edge;
            options.are_rims_on_circles = are_rims_on_circles;
            const LongWork work(progress);
            return remeshed(mesh, options, work.progress());
        },
        py::arg("mesh"), py::arg("edge"), py::arg("are_rims_on_circles") = false,
        py::arg("progress") = py::none(),
        "Well-shaped triangles with edges of `edge` mm on flats, shorter at rims and bends, on the "
        "facets of a mesh without cuts (see cured). progress(fraction, task) returns whether to go "
        "on. Raises InvalidInput, Cancelled.");
}

}  // namespace sheetmorph
