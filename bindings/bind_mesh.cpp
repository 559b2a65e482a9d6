// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/mesh/geometry/components.h"
#include "sheetmorph/mesh/geometry/normals.h"
#include "sheetmorph/mesh/quality/quality.h"
#include "sheetmorph/mesh/regions/growing.h"
#include "sheetmorph/mesh/regions/round_holes.h"
#include "sheetmorph/mesh/search/picking.h"
#include "sheetmorph/mesh/topology/boundary.h"
#include "sheetmorph/mesh/topology/polygons.h"
#include "arrays.h"
#include "layers.h"
#include "progress.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <limits>
#include <optional>
#include <utility>

namespace py = pybind11;

namespace sheetmorph
{

using namespace fitting;
using namespace mesh;

namespace
{

// Runs kernel work while other Python threads go on.
template <typename Work>
auto without_gil(Work&& work)
{
    const LongWork long_work;
    return work();
}

TriangleMesh mesh_from(const py::handle& points, const py::handle& triangles)
{
    return TriangleMesh(points_from(points, "points"), triangles_from(triangles, "triangles"));
}

Quads quads_from(const py::array& array)
{
    if (array.ndim() != 2 || array.shape(1) != 4)
        throw py::value_error("quads must have the shape (q, 4)");
    const VertexIds corners = ids_from(array.attr("ravel")(), "quads");
    return Eigen::Map<const Quads>(corners.data(), array.shape(0), 4);
}

void bind_boundary(py::module_& module)
{
    module.def(
        "components",
        [](const TriangleMesh& mesh)
        { return to_numpy(without_gil([&] { return connected_components(mesh).label; })); },
        py::arg("mesh"),
        "Connected component of every vertex, (n,) int32 from 0; -1 for vertices in no triangle.");
    module.def(
        "boundary_loops",
        [](const TriangleMesh& mesh)
        { return to_lists(without_gil([&] { return boundary_loops(mesh); })); },
        py::arg("mesh"),
        "The closed loops of edges that one triangle uses: list of (k,) int32, each in order along "
        "the rim from its smallest vertex, the sheet on its left; by rising first vertex.");
    module.def(
        "boundary_loop_at",
        [](const TriangleMesh& mesh, int vertex)
        { return to_numpy(without_gil([&] { return boundary_loop_at(mesh, vertex); })); },
        py::arg("mesh"), py::arg("vertex"),
        "The boundary loop through a vertex, (k,) int32; of several the one with the fewest "
        "vertices. Raises InvalidInput if there is none.");
}

void bind_rings(py::module_& module)
{
    module.def(
        "grow_rings",
        [](const TriangleMesh& mesh, const py::object& vertices, int rings)
        { return to_numpy(grow_rings(mesh, ids_from(vertices, "vertices"), rings)); },
        py::arg("mesh"), py::arg("vertices"), py::arg("rings"),
        "The vertices and those around them, `rings` triangles far: (k,) int32, ascending.");
    module.def(
        "shrink_rings",
        [](const TriangleMesh& mesh, const py::object& vertices, int rings)
        { return to_numpy(shrink_rings(mesh, ids_from(vertices, "vertices"), rings)); },
        py::arg("mesh"), py::arg("vertices"), py::arg("rings"),
        "The vertices without those nearer than `rings` triangles to a vertex outside: (k,) "
        "int32, ascending. The border of the mesh does not shrink by itself.");
}

void bind_growing(py::module_& module)
{
    bind_rings(module);
    module.def(
        "grow_to_creases",
        [](const TriangleMesh& mesh, int triangle, double max_angle) {
            return to_numpy(
                without_gil([&] { return grow_to_creases(mesh, triangle, max_angle); }));
        },
        py::arg("mesh"), py::arg("triangle"), py::arg("max_angle"),
        "The triangles reached from one across edges that bend by less than `max_angle` radians "
        "(0 flat), whatever their orientation: (k,) int32, ascending.");
    module.def(
        "connected_triangles",
        [](const TriangleMesh& mesh, int triangle)
        { return to_numpy(without_gil([&] { return connected_triangles(mesh, triangle); })); },
        py::arg("mesh"), py::arg("triangle"),
        "The triangles of the same connected component: (k,) int32, ascending.");
    module.def(
        "triangles_with_all_vertices",
        [](const TriangleMesh& mesh, const py::object& vertices)
        { return to_numpy(triangles_with_all_vertices(mesh, ids_from(vertices, "vertices"))); },
        py::arg("mesh"), py::arg("vertices"),
        "The triangles whose three corners are among the vertices: (k,) int32, ascending.");
    module.def(
        "vertices_of_triangles",
        [](const TriangleMesh& mesh, const py::object& triangles)
        { return to_numpy(vertices_of_triangles(mesh, ids_from(triangles, "triangles"))); },
        py::arg("mesh"), py::arg("triangles"),
        "The corners of the triangles: (k,) int32, ascending.");
}

void bind_circle(py::module_& module)
{
    py::class_<CircleFit>(module, "CircleFit", "A circle in space, mm.")
        .def_property_readonly(
            "centre", [](const CircleFit& c) { return to_numpy(c.centre); }, "(3,) mm")
        .def_property_readonly(
            "axis", [](const CircleFit& c) { return to_numpy(c.axis); },
            "(3,) of length 1; the points run around it counter-clockwise")
        .def_readonly("radius", &CircleFit::radius, "mm")
        .def_readonly("residual", &CircleFit::residual, "largest distance of a point from it, mm")
        .def_property_readonly(
            "unsettled", [](const CircleFit& c) { return c.convergence.sentence(); },
            "empty, or how far the fit got: nearly straight rows of points have no best circle");
    py::class_<RoundHole>(module, "RoundHole", "A boundary loop that is a circle.")
        .def_property_readonly(
            "rim", [](const RoundHole& hole) { return to_numpy(hole.rim); }, "(k,) int32, in order")
        .def_readonly("circle", &RoundHole::circle, "the CircleFit of the rim");
    module.def(
        "fit_circle",
        [](const py::object& points) { return fit_circle(points_from(points, "points")); },
        py::arg("points"),
        "The least-squares circle in the best plane of (k, 3) float64 points, mm, as a CircleFit. "
        "Raises InvalidInput for fewer than 3 points or points on one line.");
    module.def(
        "round_holes",
        [](const TriangleMesh& mesh, double tolerance)
        { return without_gil([&] { return round_holes(mesh, tolerance); }); },
        py::arg("mesh"), py::arg("tolerance") = 0.01,
        "The boundary loops of at least 6 vertices within tolerance * radius of a circle, as a "
        "list of RoundHole; a round outer border is one of them.");
}

void bind_quality_types(py::module_& module)
{
    py::class_<MeshQuality>(module, "MeshQuality", "How well shaped the triangles are.")
        .def_readonly("worst_angle_degrees", &MeshQuality::worst_angle_degrees,
                      "smallest corner of any triangle")
        .def_readonly("worst_aspect", &MeshQuality::worst_aspect,
                      "largest (longest edge / height), 1 if equilateral")
        .def_readonly("degenerate", &MeshQuality::degenerate,
                      "number of triangles thinner than 1e-5; they are left out of the others");
    const auto deformed = [](auto field)
    { return [field](const QualityChange& change) { return change.deformed.*field; }; };
    py::class_<QualityChange>(module, "QualityChange", "What a deformation did to the triangles.")
        .def_property_readonly("worst_angle_degrees", deformed(&MeshQuality::worst_angle_degrees))
        .def_property_readonly("worst_aspect", deformed(&MeshQuality::worst_aspect))
        .def_property_readonly("degenerate", deformed(&MeshQuality::degenerate))
        .def_readonly("largest_stretch", &QualityChange::largest_stretch, "edge length over rest")
        .def_readonly("smallest_stretch", &QualityChange::smallest_stretch, "edge length over rest")
        .def_property_readonly(
            "flipped", [](const QualityChange& c) { return c.flipped.size(); },
            "number of triangles folded over onto a neighbour")
        .def_property_readonly(
            "flipped_triangles", [](const QualityChange& c) { return to_numpy(c.flipped); },
            "(k,) int32, ascending");
}

void bind_quality(py::module_& module)
{
    bind_quality_types(module);
    module.def(
        "quality",
        [](const py::object& points, const py::object& triangles)
        {
            const TriangleMesh mesh = mesh_from(points, triangles);
            return without_gil([&] { return quality(mesh); });
        },
        py::arg("points"), py::arg("triangles"),
        "MeshQuality of (n, 3) float64 points, mm, and (m, 3) int32 triangles.");
    module.def(
        "vertex_quality",
        [](const py::object& points, const py::object& triangles)
        {
            const TriangleMesh mesh = mesh_from(points, triangles);
            const Eigen::VectorXd found = without_gil([&] { return vertex_quality(mesh); });
            return py::array_t<double>(found.size(), found.data());
        },
        py::arg("points"), py::arg("triangles"),
        "(n,) smallest corner of any triangle at each vertex, degrees; 60 without triangles.");
    module.def(
        "compare_quality",
        [](const py::object& rest_points, const py::object& points, const py::object& triangles)
        {
            const TriangleMesh rest(points_from(rest_points, "rest_points"),
                                    triangles_from(triangles, "triangles"));
            const Points deformed = points_from(points, "points");
            return without_gil([&] { return compare_quality(rest, deformed); });
        },
        py::arg("rest_points"), py::arg("points"), py::arg("triangles"),
        "QualityChange from rest to deformed points, both (n, 3) float64, mm. A triangle is "
        "flipped if the sheet bends by more than 150 degrees at one of its edges and at least 30 "
        "more than at rest; a mesh turned as a whole has none.");
}

void bind_shape(py::module_& module)
{
    module.def(
        "vertex_normals",
        [](const py::object& points, const py::object& triangles)
        {
            const TriangleMesh mesh = mesh_from(points, triangles);
            return to_numpy(
                without_gil([&] { return vertex_normals(mesh.points(), mesh.triangles()); }));
        },
        py::arg("points"), py::arg("triangles"),
        "Area-weighted normals, (n, 3) float64, each of length 1, for display.");
    module.def(
        "split_quads",
        [](const py::object& points, const py::array& quads)
        { return to_numpy(split_quads(points_from(points, "points"), quads_from(quads))); },
        py::arg("points"), py::arg("quads"),
        "(q, 4) quads as (2q, 3) int32 triangles, by the Delaunay diagonal; quad k is rows 2k "
        "and 2k + 1.");
    module.def(
        "split_polygon",
        [](const py::object& points, const py::object& corners) {
            return to_numpy(
                split_polygon(points_from(points, "points"), ids_from(corners, "corners")));
        },
        py::arg("points"), py::arg("corners"),
        "One polygon of k corners as (k - 2, 3) int32 triangles oriented like it.");
}

Eigen::VectorXd distances_of(const PickingTree& tree, const Points& points)
{
    Eigen::VectorXd found(points.rows());
    const auto measure = [&](Eigen::Index begin, Eigen::Index end)
    {
        for (Eigen::Index k = begin; k < end; ++k)
        {
            const std::optional<Hit> hit = tree.nearest_point(points.row(k).transpose());
            found(k) = hit ? hit->distance : std::numeric_limits<double>::infinity();
        }
    };
    parallel_ranges(points.rows(), microsecond_items, measure);
    return found;
}

void bind_distances(py::class_<PickingTree>& on)
{
    on.def(
        "distances",
        [](const PickingTree& tree, const py::object& points)
        {
            const Points places = points_from(points, "points");
            return without_gil([&] { return distances_of(tree, places); });
        },
        py::arg("points"),
        "(k,) mm from points (k, 3) to the nearest place; infinite if the mesh has no "
        "triangle.");
}

void bind_picking(py::module_& module)
{
    py::class_<Hit>(module, "Hit", "A place on a mesh.")
        .def_readonly("triangle", &Hit::triangle)
        .def_property_readonly(
            "barycentric", [](const Hit& h) { return to_numpy(h.barycentric); },
            "(3,) >= 0, of the triangle's corners; their sum is 1")
        .def_readonly("distance", &Hit::distance, "mm")
        .def_property_readonly(
            "point", [](const Hit& h) { return to_numpy(h.point); }, "(3,) mm");
    py::class_<PickingTree> on(module, "PickingTree",
                               "What a ray hits, and what is nearest to a point, on a mesh.");
    on.def(py::init(
               [](const py::object& points, const py::object& triangles)
               {
                   const TriangleMesh mesh = mesh_from(points, triangles);
                   return without_gil([&] { return PickingTree(mesh); });
               }),
           py::arg("points"), py::arg("triangles"), "(n, 3) float64 mm and (m, 3) int32.")
        .def(
            "refit",
            [](PickingTree& tree, const py::object& points)
            { tree.refit(points_from(points, "points")); },
            py::arg("points"), "Takes new positions (n, 3), mm, of the same triangles.")
        .def(
            "nearest_hit",
            [](const PickingTree& tree, const py::object& origin, const py::object& direction) {
                return tree.nearest_hit(vector_from(origin, "origin"),
                                        vector_from(direction, "direction"));
            },
            py::arg("origin"), py::arg("direction"),
            "The first Hit of a ray from either side, or None. Raises InvalidInput for a direction "
            "of length zero.")
        .def(
            "nearest_point",
            [](const PickingTree& tree, const py::object& point)
            { return tree.nearest_point(vector_from(point, "point")); },
            py::arg("point"), "The Hit nearest to a point; None if the mesh has no triangle.");
    bind_distances(on);
}

}  // namespace

void bind_mesh(py::module_& module)
{
    bind_boundary(module);
    bind_growing(module);
    bind_circle(module);
    bind_quality(module);
    bind_shape(module);
    bind_picking(module);
}

}  // namespace sheetmorph
