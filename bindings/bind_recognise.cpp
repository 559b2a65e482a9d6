// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/recognise/contacts/contacts.h"
#include "sheetmorph/recognise/features/features.h"
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

std::vector<std::vector<Feature>> features_of_all(
    const std::vector<const mesh::TriangleMesh*>& meshes, const FeatureTolerances& tolerances,
    const Progress& progress)
{
    const std::string task = "looking for features";
    std::vector<std::vector<Feature>> found(meshes.size());
    std::vector<Task> searches;
    for (std::size_t k = 0; k < meshes.size(); ++k)
        searches.push_back({task, [&, k](const Progress& own)
                            {
                                own.report(0.0, task);
                                found[k] = find_features(*meshes[k], tolerances);
                            }});
    run_tasks(searches, progress);
    return found;
}

py::list to_lists(const std::vector<VertexIds>& loops)
{
    py::list list;
    for (const VertexIds& loop : loops)
        list.append(to_numpy(loop));
    return list;
}

void bind_tolerances(py::module_& module)
{
    using F = FeatureTolerances;
    py::class_<F>(module, "FeatureTolerances", "How features are told from each other; radians.")
        .def(py::init<>())
        .def_readwrite("crease_angle", &F::crease_angle, "a sharper bend is an edge, rad")
        .def_readwrite("smooth_angle", &F::smooth_angle, "where a curved surface goes on, rad")
        .def_readwrite("plane_angle", &F::plane_angle, "largest bend inside a plane, rad")
        .def_readwrite("roundness", &F::roundness, "residual of a rim over its radius")
        .def_readwrite("surface", &F::surface, "residual of a surface over its radius")
        .def_readwrite("smallest_area", &F::smallest_area, "of a surface over its part's area")
        .def_readwrite("scatter", &F::scatter, "of measured vertices, mm; < 0: told from the mesh")
        .def_readwrite("weld", &F::weld, "vertices nearer than this share of the size are one")
        .def_readwrite("fewest_rim_vertices", &F::fewest_rim_vertices, "of a hole")
        .def_readwrite("washer_rings", &F::washer_rings, "rings proposed around a hole")
        .def_readwrite("smallest_radius", &F::smallest_radius, "of holes, mm")
        .def_readwrite("largest_radius", &F::largest_radius, "of holes, mm");
    using C = ContactTolerances;
    py::class_<C>(module, "ContactTolerances", "When two parts are in contact.")
        .def(py::init<>())
        .def_readwrite("gap", &C::gap, "largest gap beyond half of both thicknesses, mm; < 0: auto")
        .def_readwrite("facing_angle", &C::facing_angle, "between surfaces that face, rad")
        .def_readwrite("coaxial", &C::coaxial, "offset of two holes over the smaller radius")
        .def_readwrite("bolt_ratio", &C::bolt_ratio, "largest ratio of two coaxial radii")
        .def_readwrite("smallest", &C::smallest, "vertices of the smaller side, at least")
        .def_readwrite("joins_pairs", &C::joins_pairs, "one contact a pair of parts");
}

void bind_found_features(py::module_& module)
{
    const auto vector = [](auto field)
    { return [field](const Feature& feature) { return to_numpy(feature.*field); }; };
    const auto lists = [](auto field)
    { return [field](const Feature& feature) { return to_lists(feature.*field); }; };
    py::class_<Feature>(module, "Feature", "A feature found on a mesh; mm and radians.")
        .def_property_readonly("kind", [](const Feature& f) { return name_of(f.kind); })
        .def_property_readonly("center", vector(&Feature::center), "(3,) mm")
        .def_property_readonly("axis", vector(&Feature::axis), "(3,) of length 1")
        .def_readonly("radius", &Feature::radius, "mm")
        .def_readonly("length", &Feature::length, "longer extent, mm")
        .def_readonly("width", &Feature::width, "shorter extent, mm")
        .def_readonly("depth", &Feature::depth, "between the rims of a hole; a height, mm")
        .def_readonly("angle", &Feature::angle, "of a cone, rad")
        .def_readonly("residual", &Feature::residual, "largest distance from the form, mm")
        .def_readonly("scatter", &Feature::scatter, "of the vertices as measured, mm")
        .def_readonly("area", &Feature::area, "mm^2")
        .def_property_readonly(
            "unsettled", [](const Feature& f) { return f.convergence.sentence(); },
            "empty, or that growing a surface did not end, and how far it got")
        .def_readonly("is_hollow", &Feature::is_hollow, "seen from inside")
        .def_property_readonly("rims", lists(&Feature::rims), "closed loops, each (k,) int32")
        .def_property_readonly(
            "vertices", [](const Feature& f) { return to_numpy(f.vertices); }, "(k,) int32")
        .def_property_readonly("washer", lists(&Feature::washer), "rings around, each (k,) int32");
}

void bind_feature_search(py::module_& module)
{
    module.def(
        "find_features",
        [](const mesh::TriangleMesh& mesh, const FeatureTolerances& tolerances)
        {
            const auto copy = tolerances;  // another thread may change them
            const LongWork work;
            return find_features(mesh, copy);
        },
        py::arg("mesh"), py::arg("tolerances") = FeatureTolerances(),
        "The holes, surfaces, flanges, beads of a mesh as a list of Feature, holes first.");
    module.def(
        "find_features",
        [](const std::vector<const mesh::TriangleMesh*>& meshes,
           const FeatureTolerances& tolerances, const py::object& progress)
        {
            const auto copy = tolerances;  // another thread may change them
            const LongWork work(progress);
            return features_of_all(meshes, copy, work.progress());
        },
        py::arg("meshes"), py::arg("tolerances"), py::arg("progress") = py::none(),
        "The same of every mesh, on all cores. progress(fraction, task) returns whether to go on.");
}

void bind_contacts(py::module_& module)
{
    py::class_<ContactPart>(module, "ContactPart", "A part among others.")
        .def(py::init(
                 [](const mesh::TriangleMesh& mesh, double thickness, std::vector<Feature> features)
                 {
                     return ContactPart{mesh, thickness, std::move(features)};
                 }),
             py::arg("mesh"), py::arg("thickness") = 0.0,
             py::arg("features") = std::vector<Feature>(),
             "thickness of a sheet whose mesh has none, mm.");
    using Found = FoundContact;
    py::class_<Found>(module, "FoundContact", "A place where two parts touch, mm.")
        .def_property_readonly("kind", [](const Found& c) { return name_of(c.kind); })
        .def_property_readonly("type", [](const Found& c) { return type_of(c); })
        .def_readonly("part_a", &Found::part_a)
        .def_readonly("part_b", &Found::part_b)
        .def_property_readonly(
            "a", [](const Found& c) { return to_numpy(c.a); }, "(k,) int32")
        .def_property_readonly(
            "b", [](const Found& c) { return to_numpy(c.b); }, "(k,) int32")
        .def_property_readonly("center", [](const Found& c) { return to_numpy(c.center); })
        .def_property_readonly("axis", [](const Found& c) { return to_numpy(c.axis); })
        .def_readonly("distance", &Found::distance, "median, mm")
        .def_readonly("size", &Found::size, "diagonal of the box around both sides, mm")
        .def_readonly("connections", &Found::connections, "elements that connect both sides");
}

void bind_contact_search(py::module_& module)
{
    module.def(
        "find_contacts",
        [](const std::vector<ContactPart>& parts,
           const std::vector<std::array<int, 6>>& connections, const ContactTolerances& tolerances,
           const py::object& progress)
        {
            std::vector<Connection> elements;
            for (const auto& [part_a, vertex_a, part_b, vertex_b, joint, rigid] : connections)
                elements.push_back({part_a, vertex_a, part_b, vertex_b, joint, rigid != 0});
            const auto copy = tolerances;  // another thread may change them
            const LongWork work(progress);
            return find_contacts(parts, elements, copy, work.progress());
        },
        py::arg("parts"), py::arg("connections") = std::vector<std::array<int, 6>>(),
        py::arg("tolerances") = ContactTolerances(), py::arg("progress") = py::none(),
        "The contacts between parts as a list of FoundContact; a connection is (part a, vertex a, "
        "part b, vertex b, joint, 1 for a rigid body, else 0): those of one weld or bolt have one "
        "number, -1 stands alone.");
    module.def(
        "proposed_gap",
        [](const std::vector<ContactPart>& parts, const ContactTolerances& tolerances)
        {
            const auto copy = tolerances;  // another thread may change them
            const LongWork work;
            return proposed_gap(parts, copy);
        },
        py::arg("parts"), py::arg("tolerances") = ContactTolerances(),
        "The largest gap at which parts of this assembly lie on each other, mm.");
}

}  // namespace

void bind_recognise(py::module_& module)
{
    bind_tolerances(module);
    bind_found_features(module);
    bind_feature_search(module);
    bind_contacts(module);
    bind_contact_search(module);
}

}  // namespace sheetmorph
