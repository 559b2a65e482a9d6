// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/sheet_diagnosis.h"
#include "layers.h"
#include "progress.h"

#include <pybind11/stl.h>

namespace py = pybind11;

namespace sheetmorph
{

using namespace mesh;

namespace
{

void bind_pieces(py::module_& module)
{
    py::class_<PieceDiagnosis>(module, "PieceDiagnosis", "What a connected piece of a mesh is.")
        .def_property_readonly(
            "kind",
            [](const PieceDiagnosis& piece)
            {
                static const char* const names[] = {"open shell", "thin solid", "solid"};
                return names[static_cast<int>(piece.kind)];
            },
            "\"open shell\", \"thin solid\" or \"solid\"")
        .def_readonly("triangles", &PieceDiagnosis::triangles, "their number")
        .def_readonly("area", &PieceDiagnosis::area, "mm^2")
        .def_readonly("volume", &PieceDiagnosis::volume, "mm^3, of closed pieces")
        .def_readonly("is_inside_out", &PieceDiagnosis::is_inside_out,
                      "closed, and most of it faces inwards")
        .def_readonly("thickness", &PieceDiagnosis::thickness, "mm, of thin solids: the median")
        .def_property_readonly(
            "thickness_range",
            [](const PieceDiagnosis& piece)
            { return py::make_tuple(piece.thinnest, piece.thickest); },
            "mm, of thin solids: nine tenths of it are between these");
}

void bind_lengths(py::class_<Diagnosis>& diagnosis)
{
    diagnosis.def_readonly("size", &Diagnosis::size, "diagonal of the bounding box, mm")
        .def_readonly("tolerance", &Diagnosis::tolerance, "mm")
        .def_property_readonly(
            "edge_lengths",
            [](const Diagnosis& d)
            { return py::make_tuple(d.edges.shortest, d.edges.median, d.edges.longest); },
            "shortest, median, longest, mm")
        .def_property_readonly(
            "round_rims", [](const Diagnosis& d) { return d.rims.count; },
            "closed round rims at borders and creases, their number")
        .def_property_readonly(
            "rim_radii",
            [](const Diagnosis& d)
            { return py::make_tuple(d.rims.smallest_radius, d.rims.largest_radius); },
            "smallest and largest, mm")
        .def_property_readonly(
            "fewest_rim_vertices", [](const Diagnosis& d) { return d.rims.fewest_vertices; },
            "of any round rim");
}

void bind_counts(py::class_<Diagnosis>& diagnosis)
{
    diagnosis.def_readonly("unused_vertices", &Diagnosis::unused_vertices)
        .def_readonly("duplicate_vertices", &Diagnosis::duplicate_vertices,
                      "in the place of an earlier one")
        .def_readonly("near_duplicate_vertices", &Diagnosis::near_duplicate_vertices,
                      "pairs of different places within the tolerance")
        .def_readonly("duplicate_triangles", &Diagnosis::duplicate_triangles)
        .def_readonly("degenerate_triangles", &Diagnosis::degenerate_triangles)
        .def_readonly("slivers", &Diagnosis::slivers, "longest edge over height above 25")
        .def_readonly("flipped_triangles", &Diagnosis::flipped_triangles)
        .def_readonly("is_one_sided", &Diagnosis::is_one_sided)
        .def_readonly("t_junctions", &Diagnosis::t_junctions, "vertices inside open edges")
        .def_readonly("open_edges", &Diagnosis::open_edges)
        .def_readonly("non_manifold_edges", &Diagnosis::non_manifold_edges)
        .def_readonly("open_edges_welded", &Diagnosis::open_edges_welded,
                      "left once near vertices are one")
        .def_readonly("non_manifold_edges_welded", &Diagnosis::non_manifold_edges_welded,
                      "left once near vertices are one")
        .def_readonly("pieces", &Diagnosis::pieces, "list of PieceDiagnosis");
}

}  // namespace

void bind_diagnosis(py::module_& module)
{
    bind_pieces(module);
    py::class_<Diagnosis> diagnosis(module, "Diagnosis",
                                    "What a mesh is and what is wrong with it.");
    bind_lengths(diagnosis);
    bind_counts(diagnosis);
    module.def(
        "diagnose",
        [](const TriangleMesh& mesh, double tolerance)
        {
            const LongWork work;
            return recognise::diagnose_sheets(mesh, tolerance);
        },
        py::arg("mesh"), py::arg("tolerance"),
        "Look at a mesh; vertices nearer than `tolerance` (mm) are one place. Changes nothing.");
}

}  // namespace sheetmorph
