// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/assembly.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/forms/feature_shape.h"
#include "sheetmorph/mesh/quality/noise.h"
#include "arrays.h"
#include "layers.h"

#include <pybind11/stl.h>

#include <array>
#include <map>

namespace py = pybind11;

namespace sheetmorph
{

using namespace assembly;
using namespace forms;
using namespace surface;

namespace
{

using Motion = FeatureMotion::Type;

const std::map<std::string, FeatureRotation> rotations = {
    {"free", FeatureRotation::free},
    {"interpolated", FeatureRotation::interpolated},
    {"prescribed", FeatureRotation::prescribed}};

const std::map<std::string, Motion> motions = {
    {"free", Motion::free},   {"fixed", Motion::fixed}, {"translation", Motion::translation},
    {"plane", Motion::plane}, {"line", Motion::line},   {"axis", Motion::axis}};

const std::map<std::string, FeatureLinkType> pairs = {{"coaxial", FeatureLinkType::coaxial},
                                                      {"distance", FeatureLinkType::distance}};

template <typename Value>
Value value_of(const std::map<std::string, Value>& known, const std::string& what,
               const std::string& name)
{
    const auto found = known.find(name);
    if (found != known.end())
        return found->second;
    std::string names;
    for (const auto& [other, value] : known)
        names += (names.empty() ? "'" : ", '") + other + "'";
    throw InvalidInput(what + " '" + name + "' does not exist", "use one of " + names);
}

template <typename Value>
std::string name_of(const std::map<std::string, Value>& known, const Value& value)
{
    for (const auto& [name, other] : known)
        if (other == value)
            return name;
    return "";
}

Vector3 unit_vector(const py::object& array, const std::string& what)
{
    const Vector3 given = vector_from(array, what);
    if (!given.allFinite() || !(given.norm() > 0.0))
        throw InvalidInput("the " + what + " has no length", "give it a direction");
    return given.normalized();
}

void bind_motion(py::module_& module)
{
    py::class_<FeatureMotion>(module, "FeatureMotion", "What a form feature may do.")
        .def(py::init(
                 [](const std::string& type, const py::object& point, const py::object& direction)
                 {
                     return FeatureMotion{value_of(motions, "the motion", type),
                                          vector_from(point, "point"),
                                          unit_vector(direction, "direction of the motion")};
                 }),
             py::arg("type") = "free", py::arg("point") = py::make_tuple(0.0, 0.0, 0.0),
             py::arg("direction") = py::make_tuple(0.0, 0.0, 1.0),
             "type 'free', 'fixed', 'translation', 'plane', 'line' or 'axis'; direction: normal of "
             "the plane, along the line or the axis; point (mm): on the axis.");
}

void bind_feature(py::module_& module)
{
    py::class_<PartFeature>(module, "FormFeature", "Vertices (k,) that keep their form (2.4).")
        .def(py::init(
                 [](std::string name, int part, const py::object& vertices,
                    const std::string& rotation, const FeatureMotion& motion,
                    std::optional<double> size, bool is_resizable)
                 {
                     return PartFeature{std::move(name),
                                        part,
                                        ids_from(vertices, "vertices"),
                                        value_of(rotations, "the rotation", rotation),
                                        motion,
                                        size,
                                        is_resizable};
                 }),
             py::arg("name"), py::arg("part"), py::arg("vertices"), py::arg("rotation") = "free",
             py::arg("motion") = FeatureMotion{}, py::arg("size") = py::none(),
             py::arg("is_resizable") = false,
             "rotation 'free' (the energy's), 'interpolated' or 'prescribed' (the pose's); size, "
             "mm: diameter of a hole, length of a slot, radius of a cylinder; is_resizable: a pose "
             "may set it too.")
        .def_readonly("name", &PartFeature::name)
        .def_readonly("part", &PartFeature::part)
        .def_property_readonly(
            "vertices", [](const PartFeature& feature) { return to_numpy(feature.vertices); })
        .def_property_readonly("rotation", [](const PartFeature& feature)
                               { return name_of(rotations, feature.rotation); })
        .def_property_readonly("motion", [](const PartFeature& feature)
                               { return name_of(motions, feature.motion.type); });
}

void bind_relations(py::module_& module)
{
    py::class_<FeatureGroup>(module, "FeatureGroup", "Features of one part that move as one body.")
        .def(py::init(
                 [](std::string name, std::vector<int> features) {
                     return FeatureGroup{std::move(name), std::move(features)};
                 }),
             py::arg("name"), py::arg("features"), "features: indices into Assembly.features");

    py::class_<FeaturePair>(module, "FeaturePair", "Two features that keep an axis or a distance.")
        .def(py::init(
                 [](std::string name, const std::string& type, int a, int b) {
                     return FeaturePair{std::move(name), value_of(pairs, "the pair", type), a, b};
                 }),
             py::arg("name"), py::arg("type"), py::arg("a"), py::arg("b"),
             "type 'coaxial' or 'distance'; a and b: indices into Assembly.features");

    py::class_<SymmetryPlane>(module, "SymmetryPlane", "A plane the assembly is symmetric about.")
        .def(py::init(
                 [](const py::object& point, const py::object& normal)
                 {
                     return SymmetryPlane{vector_from(point, "point"),
                                          unit_vector(normal, "normal of the symmetry plane")};
                 }),
             py::arg("point"), py::arg("normal"));
}

std::string kind_of(const FeatureShape& shape)
{
    constexpr std::array<const char*, 3> names = {"hole", "slot", "cylinder"};
    return names[static_cast<std::size_t>(shape.kind)];
}

void bind_shape(py::module_& module)
{
    py::class_<FeatureShape>(module, "FeatureShape", "A form whose size can be set, at rest, mm.")
        .def_property_readonly("kind", &kind_of, "'hole', 'slot' or 'cylinder'")
        .def_property_readonly("measure", &FeatureShape::measure,
                               "'diameter', 'length' or 'radius': what `size` is")
        .def_readonly("size", &FeatureShape::size)
        .def_readonly("smallest", &FeatureShape::smallest, "what a size must exceed")
        .def_property_readonly("centre", [](const FeatureShape& s) { return to_numpy(s.centre); })
        .def_property_readonly("axis", [](const FeatureShape& s) { return to_numpy(s.axis); })
        .def(
            "resized",
            [](const FeatureShape& shape, const py::object& rest, double size)
            { return to_numpy(shape.resized(points_from(rest, "rest"), size)); },
            py::arg("rest"), py::arg("size"),
            "(k, 3): the feature's vertices at rest, given without a size, with one.");

    module.def(
        "feature_shape",
        [](const py::object& points, const py::object& triangles, const py::object& vertices)
        {
            const mesh::TriangleMesh mesh(points_from(points, "points"),
                                          triangles_from(triangles, "triangles"));
            const VertexIds ids = ids_from(vertices, "vertices");
            for (const int vertex : ids)
                if (vertex < 0 || vertex >= mesh.vertex_count())
                    throw InvalidInput("vertex " + std::to_string(vertex) + " does not exist");
            return feature_shape(mesh, ids, mesh::scatter_of(mesh));
        },
        py::arg("points"), py::arg("triangles"), py::arg("vertices"),
        "The hole, slot or cylinder that vertices (k,) are; None if they are neither.");
}

}  // namespace

void bind_features(py::module_& module)
{
    bind_motion(module);
    bind_feature(module);
    bind_relations(module);
    bind_shape(module);
}

}  // namespace sheetmorph
