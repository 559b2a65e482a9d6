// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/thin/thickness_gauge.h"
#include "arrays.h"
#include "layers.h"
#include "progress.h"

#include <pybind11/stl.h>

namespace py = pybind11;

namespace sheetmorph
{

using namespace recognise;

namespace
{

py::array_t<int> sides_to_numpy(const std::vector<SolidSide>& sides)
{
    VertexIds numbers;
    for (const SolidSide side : sides)
        numbers.push_back(static_cast<int>(side));
    return to_numpy(numbers);
}

py::list to_lists(const std::vector<VertexIds>& pieces)
{
    py::list list;
    for (const VertexIds& piece : pieces)
        list.append(to_numpy(piece));
    return list;
}

void bind_change(py::module_& module)
{
    py::class_<ThicknessChange>(module, "ThicknessChange",
                                "The thickness of a thin solid at rest and in one pose, mm.")
        .def_readonly("rest_least", &ThicknessChange::rest_least)
        .def_readonly("rest_most", &ThicknessChange::rest_most)
        .def_readonly("least", &ThicknessChange::least)
        .def_readonly("most", &ThicknessChange::most)
        .def_readonly("worst", &ThicknessChange::worst,
                      "largest |t / t_rest - 1| away from the edges of walls")
        .def_readonly("worst_at_walls", &ThicknessChange::worst_at_walls)
        .def_property_readonly(
            "place",
            [](const ThicknessChange& change)
            {
                const ThicknessPlace& place = change.place;
                return py::make_tuple(place.vertex, place.rest, place.deformed);
            },
            "(vertex, mm at rest, mm in the pose) where it changes most; vertex -1 if nowhere");
    module.def(
        "thickness_change",
        [](const mesh::TriangleMesh& mesh, const ThinSolid& solid, const py::object& positions)
        {
            const Points points = points_from(positions, "positions");
            const LongWork work;
            return thickness_change(mesh, solid, points);
        },
        py::arg("mesh"), py::arg("solid"), py::arg("positions"),
        "ThicknessChange from the mesh at rest to positions (n, 3) float64, mm; lumps left out.");
}

void bind_solid(py::module_& module)
{
    py::class_<ThroughHole>(module, "ThroughHole", "A hole through both skins of a thin solid.")
        .def_property_readonly(
            "rim", [](const ThroughHole& hole) { return to_numpy(hole.rim); },
            "(k,) int32 on the main skin, ascending")
        .def_property_readonly(
            "vertices", [](const ThroughHole& hole) { return to_numpy(hole.vertices); },
            "(k,) int32: both rims and the wall, ascending");
    py::class_<ThinSolid>(module, "ThinSolid",
                          "A closed mesh that is a sheet: two skins and the walls between them. "
                          "Sides: 0 main skin, 1 opposite skin, 2 wall, 3 lump.")
        .def_readonly("thickness", &ThinSolid::thickness, "mm, the typical one")
        .def_property_readonly(
            "facets", [](const ThinSolid& solid) { return sides_to_numpy(solid.facets); },
            "(m,) int32: the side of every facet")
        .def_property_readonly(
            "vertices", [](const ThinSolid& solid) { return sides_to_numpy(solid.vertices); },
            "(n,) int32: the side of every vertex")
        .def_property_readonly(
            "thicknesses",
            [](const ThinSolid& solid)
            { return py::array_t<double>(solid.thicknesses.size(), solid.thicknesses.data()); },
            "(n,) float64 mm: the local thickness, NaN on walls and lumps")
        .def_readonly("holes", &ThinSolid::holes, "list of ThroughHole")
        .def_property_readonly(
            "walls", [](const ThinSolid& solid) { return to_lists(solid.walls); },
            "list of (k,) int32, rims included")
        .def_property_readonly(
            "lumps", [](const ThinSolid& solid) { return to_lists(solid.lumps); },
            "list of (k,) int32: where the solid is not thin");
}

void bind_finding(py::module_& module)
{
    module.def(
        "find_thin_solid",
        [](const mesh::TriangleMesh& mesh, double thickness) -> py::tuple
        {
            ThinFinding found;
            {
                const LongWork work;
                found = find_thin_solid(mesh, thickness);
            }
            return py::make_tuple(std::move(found.solid), found.reason);
        },
        py::arg("mesh"), py::arg("thickness") = 0.0,
        "(ThinSolid, \"\") of a closed mesh that is a sheet, else (None, why it is none). "
        "thickness: mm where it is known, 0 to find it out.");
}

}  // namespace

void bind_thin(py::module_& module)
{
    bind_solid(module);
    bind_change(module);
    bind_finding(module);
}

}  // namespace sheetmorph
