// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/assembly.h"
#include "sheetmorph/base/errors.h"
#include "arrays.h"
#include "layers.h"

#include <pybind11/stl.h>

namespace py = pybind11;

namespace sheetmorph
{

using namespace assembly;
using namespace surface;

namespace
{

Energy energy_from(const std::string& name)
{
    if (name == "paper")
        return Energy::paper;
    if (name == "neumann")
        return Energy::neumann;
    if (name == "natural")
        return Energy::natural;
    if (name == "steel")
        return Energy::steel;
    throw InvalidInput("energy '" + name + "' does not exist",
                       "use 'natural', 'neumann', 'paper' or 'steel'");
}

Laplacian laplacian_from(const std::string& name)
{
    if (name == "cotangent")
        return Laplacian::cotangent;
    if (name == "intrinsic")
        return Laplacian::intrinsic;
    throw InvalidInput("operator '" + name + "' does not exist", "use 'cotangent' or 'intrinsic'");
}

Mode mode_from(int mode)
{
    if (mode < 0 || mode > 3)
        throw InvalidInput("mode " + std::to_string(mode) + " does not exist",
                           "use 1, 2, 3, or 0 to let the part decide");
    return static_cast<Mode>(mode);
}

Unheld unheld_from(const std::string& name)
{
    if (name == "rest")
        return Unheld::rest;
    if (name == "along")
        return Unheld::along;
    if (name == "refuse")
        return Unheld::refuse;
    throw InvalidInput("unconstrained pieces cannot '" + name + "'",
                       "use 'rest', 'along' or 'refuse'");
}

ContactType contact_type_from(const std::string& name)
{
    if (name == "control mesh")
        return ContactType::control_mesh;
    if (name == "tied")
        return ContactType::tied;
    if (name == "rigid")
        return ContactType::rigid;
    throw InvalidInput("contact type '" + name + "' does not exist",
                       "use 'control mesh', 'tied' or 'rigid'");
}

PropagationType propagation_from(const std::string& name)
{
    if (name == "local")
        return PropagationType::local;
    if (name == "single")
        return PropagationType::single;
    if (name == "whole")
        return PropagationType::whole;
    throw InvalidInput("propagation type '" + name + "' does not exist",
                       "use 'local', 'single' or 'whole'");
}

void bind_part(py::module_& module)
{
    py::class_<Part>(module, "Part", "One mesh of the assembly.")
        .def(py::init(
                 [](std::string name, const mesh::TriangleMesh& mesh, const py::object& ids,
                    int mode)
                 {
                     Part part;
                     part.name = std::move(name);
                     part.mesh = mesh;
                     part.mode = mode_from(mode);
                     if (!ids.is_none())
                         part.ids = ids_from(ids, "ids");
                     return part;
                 }),
             py::arg("name"), py::arg("mesh"), py::arg("ids") = py::none(), py::arg("mode") = 0,
             "ids (n,): the file's own vertex numbers, used in messages. mode 1 to 3 of section "
             "4.1, 0: chosen from the propagation and the features.")
        .def_readonly("name", &Part::name)
        .def_readonly("mesh", &Part::mesh)
        .def(
            "make_thin",
            [](Part& part, bool is_certain, double thickness)
            {
                part.thin = is_certain ? Thin::yes : Thin::automatic;
                part.thickness = thickness;
            },
            py::arg("is_certain"), py::arg("thickness") = 0.0,
            "Solve it on one skin if it is recognised as a thin solid; InvalidInput when the "
            "session is built if it is certain but none. thickness: mm, 0 to find it out.")
        .def_readwrite("sheet_thickness", &Part::sheet_thickness,
                       "mm, of the sheet as 'steel'; 0: that of the thin solid, or a hundredth of "
                       "the size")
        .def_readwrite("poisson", &Part::poisson, "Poisson's ratio, read for 'steel'");
}

void bind_regions(py::module_& module)
{
    const auto region = [](std::string name, int part, const py::object& vertices) {
        return PartRegion{std::move(name), part, ids_from(vertices, "vertices")};
    };
    py::class_<PartRegion>(module, "Region", "A fixed region: vertices (k,) of one part.")
        .def(py::init(region), py::arg("name"), py::arg("part"), py::arg("vertices"));

    const auto handle = [](std::string name, int part, const py::object& vertices,
                           bool is_rotation_free) {
        return PartHandle{std::move(name), part, ids_from(vertices, "vertices"), is_rotation_free};
    };
    py::class_<PartHandle>(module, "Handle", "Vertices (k,) that the pose moves as one body.")
        .def(py::init(handle), py::arg("name"), py::arg("part"), py::arg("vertices"),
             py::arg("is_rotation_free") = false,
             "is_rotation_free: the pose shifts it, the energy turns it.");
}

void bind_points(py::module_& module)
{
    py::class_<PartPoint>(module, "PointConstraint", "A point on a triangle (2.3).")
        .def(py::init(
                 [](std::string name, int part, int triangle, const py::object& barycentric,
                    bool turned, bool is_rotation_free)
                 {
                     const PointConstraint constraint{name, triangle,
                                                      vector_from(barycentric, "barycentric"),
                                                      turned, is_rotation_free};
                     return PartPoint{std::move(name), part, constraint};
                 }),
             py::arg("name"), py::arg("part"), py::arg("triangle"), py::arg("barycentric"),
             py::arg("is_turned") = false, py::arg("is_rotation_free") = false,
             "is_turned: the pose turns the sheet there too; is_rotation_free: the energy does.");
}

void bind_contacts(py::module_& module)
{
    py::class_<Contact>(module, "Contact", "Where two parts are welded or bolted (section 4.2).")
        .def(py::init(
                 [](std::string name, const std::string& type, PartRegion a, PartRegion b) {
                     return Contact{std::move(name), contact_type_from(type), std::move(a),
                                    std::move(b)};
                 }),
             py::arg("name"), py::arg("type"), py::arg("a"), py::arg("b"),
             "type 'control mesh', 'tied' or 'rigid'; a and b: Regions of two parts.");

    py::class_<Propagation>(module, "Propagation", "How the motion reaches the other parts.")
        .def(py::init(
                 [](const std::string& type, int levels, double smoothness) {
                     return Propagation{propagation_from(type), levels, smoothness};
                 }),
             py::arg("type") = "local", py::arg("levels") = 3, py::arg("smoothness") = 0.05,
             "type 'local' along the contacts, 'single' for one control mesh around everything, "
             "'whole' for all parts in one solve; smoothness: c of (3.3).");
}

void bind_whole(py::module_& module)
{
    py::class_<Assembly>(module, "Assembly", "Everything about a morph but its pose.")
        .def(
            py::init(
                [](std::vector<Part> parts, int primary, const std::string& energy,
                   const std::string& laplacian)
                {
                    Assembly assembly;
                    assembly.parts = std::move(parts);
                    assembly.primary = primary;
                    assembly.energy = energy_from(energy);
                    assembly.laplacian = laplacian_from(laplacian);
                    return assembly;
                }),
            py::arg("parts"), py::arg("primary") = 0, py::arg("energy") = "neumann",
            py::arg("operator") = "cotangent",
            "energy 'paper', 'neumann', 'natural' or 'steel'; operator 'cotangent' or 'intrinsic'.")
        .def_readwrite("fixed", &Assembly::fixed)
        .def_readwrite("handles", &Assembly::handles)
        .def_readwrite("features", &Assembly::features)
        .def_readwrite("points", &Assembly::points)
        .def_readwrite("followers", &Assembly::followers)
        .def_readwrite("contacts", &Assembly::contacts)
        .def_readwrite("groups", &Assembly::groups)
        .def_readwrite("pairs", &Assembly::pairs)
        .def_readwrite("symmetry", &Assembly::symmetry)
        .def_readwrite("is_refined", &Assembly::is_refined)
        .def_readwrite("propagation", &Assembly::propagation)
        .def(
            "set_unheld",
            [](Assembly& assembly, const std::string& name)
            { assembly.unheld = unheld_from(name); },
            py::arg("name"),
            "What becomes of pieces that nothing holds: 'rest', 'along' or 'refuse'.");
}

void bind_pose(py::module_& module)
{
    py::class_<Pose>(module, "Pose", "The few numbers that decide every shape.")
        .def(py::init<>())
        .def(
            "move_handle",
            [](Pose& pose, const std::string& name, const RigidMotion& motion)
            { pose.handles[name] = motion; },
            py::arg("name"), py::arg("motion"))
        .def(
            "turn_feature",
            [](Pose& pose, const std::string& name, const py::object& log)
            { pose.feature_logs[name] = vector_from(log, "rotation_log"); },
            py::arg("name"), py::arg("rotation_log"))
        .def(
            "size_feature",
            [](Pose& pose, const std::string& name, double size) { pose.sizes[name] = size; },
            py::arg("name"), py::arg("size"), "size in mm, of a resizable feature")
        .def(
            "place_point",
            [](Pose& pose, const std::string& name, const py::object& target, const py::object& log)
            {
                pose.points[name] = {vector_from(target, "target"),
                                     vector_from(log, "rotation_log")};
            },
            py::arg("name"), py::arg("target"),
            py::arg("rotation_log") = py::make_tuple(0.0, 0.0, 0.0));
}

}  // namespace

void bind_description(py::module_& module)
{
    bind_part(module);
    bind_regions(module);
    bind_points(module);
    bind_contacts(module);
    bind_whole(module);
    bind_pose(module);
}

}  // namespace sheetmorph
