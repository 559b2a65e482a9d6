// SPDX-License-Identifier: LGPL-2.1-or-later
#include "self_intersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

namespace sheetmorph::shapes
{

bool intersects_itself(const Points& points, const Triangles& triangles)
{
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
    Mesh mesh;
    std::vector<Mesh::Vertex_index> vertices;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        vertices.push_back(mesh.add_vertex({points(i, 0), points(i, 1), points(i, 2)}));
    const auto vertex = [&](Eigen::Index t, int k)
    { return vertices[static_cast<std::size_t>(triangles(t, k))]; };
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
        if (mesh.add_face(vertex(t, 0), vertex(t, 1), vertex(t, 2)) == Mesh::null_face())
            return true;  // not manifold
    return CGAL::Polygon_mesh_processing::does_self_intersect(mesh);
}

}  // namespace sheetmorph::shapes
