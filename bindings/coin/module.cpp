// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Inventor/SoDB.h>
#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "mesh_nodes.h"
#include "patch.h"
#include "value_colours.h"

namespace py = pybind11;
using sheetmorph::Points;
using sheetmorph::Triangles;
using sheetmorph::coin::MeshNodes;
using sheetmorph::coin::NodeAddresses;
using sheetmorph::coin::ValueColours;

namespace
{

void bind_colours(py::module_& module)
{
    py::class_<ValueColours>(module, "ValueColours",
                             "Shows one value a vertex as colours of a material, kept alive.")
        .def(py::init<std::uintptr_t, sheetmorph::coin::Colours, Eigen::RowVector3f>(),
             py::arg("material"), py::arg("ramp"), py::arg("missing"),
             "material: address int(node.this) of an SoMaterial bound PER_VERTEX_INDEXED; ramp\n"
             "(k, 3) from the low to the high end; missing (3,): where there is no value.\n"
             "ValueError for a wrong address, type or ramp.")
        .def("show", &ValueColours::show, py::arg("values"), py::arg("span"),
             "Colours (n,) values, NaN where there is none, in a span (low, high).");
}

void bind_patch(py::module_& module)
{
    module.def(
        "show_patch",
        [](const py::tuple& nodes, const Eigen::Ref<const Triangles>& triangles,
           const Eigen::Ref<const Eigen::VectorXi>& vertices)
        {
            const sheetmorph::coin::PatchAddresses addresses{nodes[0].cast<std::uintptr_t>(),
                                                             nodes[1].cast<std::uintptr_t>(),
                                                             nodes[2].cast<std::uintptr_t>()};
            return show_patch(addresses, sheetmorph::coin::patch_pieces(triangles, vertices));
        },
        py::arg("nodes"), py::arg("triangles"), py::arg("vertices"),
        "Draws vertices (k,) of a mesh with triangles (m, 3): facets between them, the outline of\n"
        "those, and the vertices that are left; whether there is anything. nodes: addresses\n"
        "int(node.this) of SoIndexedFaceSet, SoIndexedLineSet, SoIndexedPointSet. ValueError for "
        "a\n"
        "wrong address or a negative index.");
}

}  // namespace

PYBIND11_MODULE(_coin, module)
{
    module.doc() = "Kernel positions straight into Coin nodes.";
    module.attr("__version__") = SHEETMORPH_VERSION;
    module.def(
        "coin_version", [] { return std::string(SoDB::getVersion()); },
        "Version of the Coin library that is loaded.");
    py::class_<MeshNodes>(module, "MeshNodes",
                          "Draws one mesh through three Coin nodes, which it keeps alive.")
        .def(py::init(
                 [](const py::tuple& nodes, const Eigen::Ref<const Points>& points,
                    const Eigen::Ref<const Triangles>& triangles, double crease)
                 {
                     const NodeAddresses addresses{nodes[0].cast<std::uintptr_t>(),
                                                   nodes[1].cast<std::uintptr_t>(),
                                                   nodes[2].cast<std::uintptr_t>()};
                     return std::make_unique<MeshNodes>(addresses, points, triangles, crease);
                 }),
             py::arg("nodes"), py::arg("points"), py::arg("triangles"), py::arg("crease"),
             "nodes: addresses int(node.this) of SoCoordinate3, SoNormal (PER_VERTEX_INDEXED) and\n"
             "SoIndexedFaceSet; points (n, 3) mm; triangles (m, 3); crease: radians beyond which\n"
             "shading breaks. ValueError for a wrong address, type or index.")
        .def(
            "show",
            [](const MeshNodes& self, const Eigen::Ref<const Points>& points)
            { self.show(points); },
            py::arg("points"),
            "Shows other positions, (n, 3) mm, with their own normals. ValueError for another n.")
        .def(
            "show",
            [](MeshNodes& self, const Eigen::Ref<const Points>& points,
               const sheetmorph::Matrix3& rotation, const sheetmorph::Vector3& base) {
                self.show(points, {rotation, base});
            },
            py::arg("points"), py::arg("rotation"), py::arg("base"),
            "The same of global positions: shown is (points - base) @ rotation, (3, 3) and (3,).");
    bind_colours(module);
    bind_patch(module);
}
