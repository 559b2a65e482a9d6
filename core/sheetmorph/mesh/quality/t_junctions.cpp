// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/quality/t_junctions.h"

#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/mesh/quality/median.h"
#include "sheetmorph/mesh/search/point_grid.h"

#include <algorithm>
#include <cmath>

namespace sheetmorph::mesh
{

namespace
{

double median_length(const Points& points, const std::vector<BoundaryEdge>& edges)
{
    std::vector<double> lengths;
    for (const BoundaryEdge& edge : edges)
        lengths.push_back((points.row(edge.to) - points.row(edge.from)).norm());
    return median(std::move(lengths));
}

VertexIds used_vertices(const TriangleMesh& mesh)
{
    const Eigen::Map<const Eigen::VectorXi> corners(mesh.triangles().data(),
                                                    mesh.triangles().size());
    VertexIds used(corners.begin(), corners.end());
    make_set(used);
    return used;
}

// The vertices of a grid within `beside` (mm) of an edge's box, ascending. Splits a long edge into
// pieces, so that it only searches cells along the edge.
VertexIds along(const PointGrid& grid, const Vector3& from, const Vector3& way, double beside)
{
    VertexIds found;
    const int steps = std::max(1, static_cast<int>(std::ceil(way.norm() / grid.side())));
    for (int k = 0; k < steps; ++k)
    {
        const Vector3 one = from + way * (double(k) / steps);
        const Vector3 two = from + way * (double(k + 1) / steps);
        grid.for_each_in(one.cwiseMin(two).array() - beside, one.cwiseMax(two).array() + beside,
                         [&](int vertex) { found.push_back(vertex); });
    }
    make_set(found);
    return found;
}

// Whether a vertex lies inside an edge, away from its ends.
bool is_inside(const Vector3& vertex, const Vector3& from, const Vector3& to, double tolerance)
{
    const Vector3 way = to - from;
    const double along = (vertex - from).dot(way) / way.squaredNorm();
    return along > 0.0 && along < 1.0 && (vertex - from).norm() > tolerance
           && (vertex - to).norm() > tolerance && (vertex - from - along * way).norm() <= tolerance;
}

}  // namespace

std::vector<TJunction> t_junctions(const TriangleMesh& mesh, double tolerance)
{
    return junctions_on(mesh, boundary_edges(mesh), tolerance);
}

std::vector<TJunction> junctions_on(const TriangleMesh& mesh,
                                    const std::vector<BoundaryEdge>& edges, double tolerance)
{
    if (edges.empty() || mesh.size() == 0.0)
        return {};
    const Points& points = mesh.points();
    // Chosen: cells two edges wide, at most 256 along the mesh, so that few are empty.
    const double side = std::max(2.0 * median_length(points, edges), mesh.size() / 256.0);
    const PointGrid grid(points, used_vertices(mesh), side);
    std::vector<TJunction> found;
    for (const BoundaryEdge& edge : edges)
    {
        const Vector3 from = points.row(edge.from), to = points.row(edge.to);
        for (const int vertex : along(grid, from, to - from, tolerance))
            if (vertex != edge.from && vertex != edge.to
                && is_inside(points.row(vertex), from, to, tolerance))
                found.push_back({edge.from, edge.to, vertex});
    }
    return found;
}

}  // namespace sheetmorph::mesh
