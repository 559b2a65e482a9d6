// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/errors.h"
#include "sheetmorph/cad/analytic_features.h"
#include "sheetmorph/cad/reading/cad_reader.h"
#include "sheetmorph/cad/writing/cad_writer.h"
#include "sheetmorph/cad/writing/kept_model.h"
#include "arrays.h"
#include "faults.h"
#include "progress.h"

#include <pybind11/stl.h>

namespace py = pybind11;

namespace sheetmorph
{

using namespace cad;

namespace
{

const char* name_of(SurfaceKind kind)
{
    switch (kind)
    {
        case SurfaceKind::plane:
            return "plane";
        case SurfaceKind::cylinder:
            return "cylinder";
        case SurfaceKind::cone:
            return "cone";
        case SurfaceKind::sphere:
            return "sphere";
        case SurfaceKind::torus:
            return "torus";
        default:
            return "other";
    }
}

void bind_surface(py::module_& module)
{
    py::class_<CadSurface>(module, "CadSurface", "The surface under a face, as the file has it.")
        .def_property_readonly(
            "kind", [](const CadSurface& s) { return name_of(s.kind); },
            "plane, cylinder, cone, sphere, torus or other")
        .def_property_readonly(
            "point", [](const CadSurface& s) { return to_numpy(s.point); },
            "(3,) mm: on a plane, on the axis, a cone's apex, a centre")
        .def_property_readonly(
            "axis", [](const CadSurface& s) { return to_numpy(s.axis); },
            "(3,) of length 1; a plane's normal")
        .def_readonly("radius", &CadSurface::radius, "mm; of a torus, the circle of centres")
        .def_readonly("minor_radius", &CadSurface::minor_radius, "mm, of a torus' tube")
        .def_readonly("half_angle", &CadSurface::half_angle, "of a cone, radians")
        .def_readonly("fit_error", &CadSurface::fit_error,
                      "mm: 0, or how well a spline surface is of this kind")
        .def_readonly("name", &CadSurface::name, "of the face in the file, empty if it has none")
        .def_readonly("colour", &CadSurface::colour, "#rrggbb, empty if it has none");
}

const char* name_of(CadFeatureKind kind)
{
    switch (kind)
    {
        case CadFeatureKind::round_hole:
            return "round hole";
        case CadFeatureKind::cylinder:
            return "cylinder";
        case CadFeatureKind::cone:
            return "cone";
        case CadFeatureKind::sphere:
            return "sphere";
        default:
            return "plane";
    }
}

void bind_feature(py::module_& module)
{
    py::class_<CadFeature>(module, "CadFeature",
                           "Faces of a part that are one shape, from their surfaces.")
        .def_property_readonly(
            "kind", [](const CadFeature& f) { return name_of(f.kind); },
            "round hole, cylinder, plane, cone or sphere")
        .def_property_readonly(
            "center", [](const CadFeature& f) { return to_numpy(f.centre); },
            "(3,) mm; of a hole, cylinder or cone on the axis, halfway along it")
        .def_property_readonly(
            "axis", [](const CadFeature& f) { return to_numpy(f.axis); }, "(3,) of length 1")
        .def_readonly("radius", &CadFeature::radius, "mm, 0 for a plane and a cone")
        .def_readonly("half_angle", &CadFeature::half_angle, "of a cone, radians")
        .def_readonly("length", &CadFeature::length, "along the axis, mm")
        .def_readonly("is_hollow", &CadFeature::is_hollow, "curved, and seen from inside")
        .def_property_readonly(
            "vertices", [](const CadFeature& f) { return to_numpy(f.vertices); },
            "(k,) int32, ascending")
        .def_readonly("residual", &CadFeature::residual,
                      "largest distance of a vertex from the surface, mm");
}

void bind_model(py::module_& module)
{
    py::class_<CadModel>(module, "CadModel", "What a CAD file holds, in mm.")
        .def_readonly("parts", &CadModel::parts)
        .def_readonly("edge", &CadModel::edge, "the longest edge wanted, mm")
        .def_readonly("deflection", &CadModel::deflection, "mm")
        .def_readonly("angle", &CadModel::angle, "radians")
        .def_readonly("lost_faces", &CadModel::lost_faces,
                      "how many faces of the file OpenCASCADE could not make; no part has them")
        .def_readonly("lost_in", &CadModel::lost_in, "solids of a STEP file that lack some of them")
        .def_readonly("unread", &CadModel::unread,
                      "entities of a STEP file with values that make no sense: number, and why")
        .def(
            "kept_mesh",
            [](const CadModel& model, std::size_t part)
            { return py::bytes(kept_mesh(model.parts.at(part))); },
            py::arg("part"), "What kept_model needs to know of the mesh of a part.")
        .def("brep", &brep_of, py::arg("part"),
             "The shape of one part as the text of a BREP file, where it stands, at rest.");
}

void bind_part(py::module_& module)
{
    py::class_<CadPart>(module, "CadPart", "One solid or free shell of a CAD file, meshed.")
        .def_readonly("name", &CadPart::name)
        .def_property_readonly("points", [](const py::object& self)
                               { return view_of(self.cast<const CadPart&>().mesh.points(), self); })
        .def_property_readonly("triangles", [](const CadPart& part)
                               { return to_numpy(Triangles(part.mesh.triangles())); })
        .def_property_readonly(
            "face_of_triangle", [](const CadPart& p) { return to_numpy(p.face_of_triangle); },
            "(m,) int32, index into `surfaces`")
        .def_readonly("surfaces", &CadPart::surfaces, "one CadSurface a face")
        .def(
            "features", [](const CadPart& part) { return analytic_features(part); },
            "Holes first: a list of CadFeature.")
        .def_readonly("is_closed", &CadPart::is_closed)
        .def_readonly("deviation", &CadPart::deviation,
                      "largest distance found between mesh and surfaces, mm")
        .def_readonly("skipped_faces", &CadPart::skipped_faces, "faces that were not meshed")
        .def_readonly("faults", &CadPart::faults, "why its shape is not valid, a few words each")
        .def_readonly("healed", &CadPart::healed, "the same before it was healed")
        .def_readonly("healed_within", &CadPart::healed_within, "how far that moved anything, mm")
        .def_property_readonly(
            "unsettled", [](const CadPart& part) { return part.convergence.sentence(); },
            "empty, or that the meshing of a face did not end, and how far it got");
}

CadMeshing meshing_from(const py::dict& sizes)
{
    CadMeshing meshing;
    for (const auto& [key, value] : sizes)
    {
        const auto name = key.cast<std::string>();
        if (name != "edge" && name != "deflection" && name != "angle")
            throw py::key_error("sizes are edge, deflection and angle, not " + name);
        double& size = name == "edge"         ? meshing.edge
                       : name == "deflection" ? meshing.deflection
                                              : meshing.angle;
        size = value.cast<double>();
    }
    return meshing;
}

void bind_readers(py::module_& module)
{
    module.def(
        "read_cad",
        [](const std::string& path, const py::dict& sizes, const py::object& progress)
        {
            const CadMeshing meshing = meshing_from(sizes);
            const LongWork work(progress);
            return read_cad(path, meshing, work.progress());
        },
        py::arg("path"), py::arg("sizes") = py::dict(), py::arg("progress") = py::none(),
        "The parts of a STEP, IGES or BREP file as a CadModel. sizes: `edge` mm, that no edge is "
        "longer than (1/100 of the diagonal); `deflection` mm, that none is farther from its "
        "surface (edge / 50); `angle` radians, that the surface turns by at most along it (0.35). "
        "progress(fraction, task) returns False to stop. Raises InvalidInput, Cancelled.");
    module.def(
        "read_brep",
        [](const std::string& text, const std::string& name, const py::dict& sizes)
        {
            const CadMeshing meshing = meshing_from(sizes);
            const LongWork work;
            return read_brep(text, name, meshing, work.progress());
        },
        py::arg("text"), py::arg("name"), py::arg("sizes") = py::dict(),
        "The same for the text of a BREP file; its parts are called name, or name.1, name.2, ...");
}

py::dict as_dict(const WorstAt& worst)
{
    py::dict found;
    found["value"] = worst.value;
    found["face"] = worst.face < 0 ? py::object(py::none()) : py::object(py::int_(worst.face));
    found["place"] = to_numpy(worst.place);
    return found;
}

py::dict as_dict(const CadMeasures& measures)
{
    py::dict found;
    found["name"] = measures.name;
    found["faces"] = measures.faces;
    found["washers"] = measures.washers;
    found["kept"] = measures.kept;
    found["fitted_faces"] = measures.fitted_faces;
    found["is_valid"] = measures.is_valid;
    found["invalid_faces"] = measures.invalid_faces;
    found["is_closed"] = measures.is_closed;
    found["was_closed"] = measures.was_closed;
    found["was_valid"] = measures.was_valid;
    found["faults_before"] = measures.faults;
    found["healed"] = measures.healed;
    found["healed_within"] = measures.healed_within;
    found["gap"] = as_dict(measures.gap);
    found["distance"] = as_dict(measures.distance);
    found["kink"] = as_dict(measures.kink);
    found["edge_tolerance"] = measures.edge_tolerance;
    found["edge_tolerance_read"] = measures.edge_tolerance_read;
    found["vertex_tolerance"] = measures.vertex_tolerance;
    found["volume_before"] = measures.volume_before;
    found["volume_after"] = measures.volume_after;
    found["points"] = to_numpy(Points(measures.points));
    found["far_faces"] = measures.far_faces;
    py::list cylinders;
    for (const KeptCylinder& one : measures.cylinders)
        cylinders.append(py::make_tuple(one.face, one.before, one.wanted, one.after));
    found["cylinders"] = cylinders;
    return found;
}

CadFormat format_from(const std::string& name)
{
    if (name == "iges")
        return CadFormat::iges;
    if (name == "brep")
        return CadFormat::brep;
    if (name != "step")
        throw InvalidInput("a CAD file is written as step, iges or brep, not " + name);
    return CadFormat::step;
}

void bind_writer(py::module_& module)
{
    module.def(
        "kept_model",
        [](const std::string& brep, const py::bytes& mesh, const std::string& name)
        { return kept_model(brep, mesh, name); },
        py::arg("brep"), py::arg("mesh"), py::arg("name"),
        "A CadModel of one part of another, of its brep() and its kept_mesh(), not meshed again. "
        "Raises InvalidInput.");
    module.def(
        "write_cad",
        [](const CadModel& model, const py::list& of_parts, const std::string& path,
           const py::dict& writing, const py::object& progress)
        {
            std::vector<Points> positions;
            for (const py::handle& one : of_parts)
                positions.push_back(points_from(one, "positions"));
            CadWriting wanted;
            wanted.path = path;
            wanted.format = format_from(writing["format"].cast<std::string>());
            wanted.tolerance = writing["tolerance"].cast<double>();
            wanted.edge_tolerance = writing["edge_tolerance"].cast<double>();
            std::vector<CadMeasures> measures;
            {
                const LongWork work(progress);
                measures = write_cad(model, positions, wanted, work.progress());
            }
            py::list found;
            for (const CadMeasures& one : measures)
                found.append(as_dict(one));
            return found;
        },
        py::arg("model"), py::arg("positions"), py::arg("path"), py::arg("writing"),
        py::arg("progress") = py::none(),
        "Write the file that a CadModel was read of with its parts at positions, (n, 3) mm each. "
        "writing: `format` step, iges or brep, `tolerance` and `edge_tolerance` in mm. Returns "
        "what the file holds, read again: a dict a part. Raises InvalidInput, SolverError, "
        "Cancelled.");
}

}  // namespace

}  // namespace sheetmorph

PYBIND11_MODULE(_cad, module)
{
    module.doc() = "CAD files as meshes whose faces are known.";
    module.attr("__version__") = SHEETMORPH_VERSION;
    py::register_local_exception_translator(&sheetmorph::translate_errors);
    sheetmorph::bind_surface(module);
    sheetmorph::bind_feature(module);
    sheetmorph::bind_model(module);
    sheetmorph::bind_part(module);
    sheetmorph::bind_readers(module);
    sheetmorph::bind_writer(module);
}
