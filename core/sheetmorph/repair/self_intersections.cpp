// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/self_intersections.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/repair/soup.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>

namespace sheetmorph
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

SurfaceMesh surface_of(const TriangleMesh& mesh, const OrientedSoup& soup)
{
    SurfaceMesh surface;
    for (const int vertex : soup.original)
    {
        const Vector3 place = mesh.points().row(vertex);
        surface.add_vertex({place.x(), place.y(), place.z()});
    }
    for (Eigen::Index t = 0; t < soup.manifold_triangles.rows(); ++t)
    {
        const auto corner = [&](int k) {
            return SurfaceMesh::Vertex_index(
                static_cast<std::uint32_t>(soup.manifold_triangles(t, k)));
        };
        if (surface.add_face(corner(0), corner(1), corner(2)) == SurfaceMesh::null_face())
            throw SolverError("triangle " + std::to_string(t) + " fits in no manifold mesh");
    }
    return surface;
}

bool share_a_vertex(const Triangles& triangles, int one, int other)
{
    for (int k = 0; k < 3; ++k)
        if ((triangles.row(other).array() == triangles(one, k)).any())
            return true;
    return false;
}

}  // namespace

std::vector<std::pair<int, int>> self_intersections(const TriangleMesh& mesh)
{
    const OrientedSoup soup = oriented(mesh);
    const SurfaceMesh surface = surface_of(mesh, soup);
    std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> crossing;
    CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(crossing));
    std::vector<std::pair<int, int>> found;
    for (const auto& [a, b] : crossing)
    {
        const auto [one, other] = std::minmax({static_cast<int>(a), static_cast<int>(b)});
        // Copies of one vertex are no neighbours to CGAL.
        const bool is_copied = share_a_vertex(mesh.triangles(), one, other)
                               && !share_a_vertex(soup.manifold_triangles, one, other);
        if (!is_copied)
            found.emplace_back(one, other);
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace sheetmorph
