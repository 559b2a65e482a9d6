// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/remeshing/working_mesh.h"

#include "sheetmorph/mesh/topology/orientation.h"
#include "sheetmorph/repair/remeshing/sizes.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace sheetmorph::repair
{

WorkingMesh::WorkingMesh(const WorkingInput& input)
    : mesh::EditableTriangles(
        mesh::oriented(input.mesh,
                       mesh::consistent_orientation(input.mesh, mesh::EdgeTable(input.mesh))),
        input.ridges),
      most_triangles(input.most_triangles),
      is_frozen(static_cast<std::size_t>(vertex_count()), 0),
      size(input.sizes),
      patch(input.patch),
      is_flat_(input.is_flat),
      largest_(input.largest)
{
    for (int v = 0; v < vertex_count(); ++v)
    {
        point.emplace_back(input.mesh.points().row(v));
        origin.push_back(v);
    }
    freeze_vertices();
}

void WorkingMesh::freeze_vertices()
{
    std::vector<std::size_t> triangles(is_frozen.size(), 0);
    for (int t = 0; t < count(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            ++triangles[corner(t, k)];
            if (!is_free_side(t, k))
                is_frozen[corner(t, k)] = is_frozen[corner(t, k + 1)] = 1;
        }
    for (int v = 0; v < vertex_count(); ++v)
        if (is_movable(v))
            is_frozen[v] = around(v).size() != triangles[v];
}

Vector3 WorkingMesh::area_vector(const Vector3& a, const Vector3& b, const Vector3& c)
{
    return (b - a).cross(c - a);
}

Vector3 WorkingMesh::area_vector(int t) const
{
    return area_vector(at(t, 0), at(t, 1), at(t, 2));
}

bool WorkingMesh::raise_least_size(double factor)
{
    const auto least = std::min_element(size.begin(), size.end());
    if (least == size.end() || *least >= largest_)
        return false;
    least_size = std::min(largest_, factor * std::max(*least, least_size));
    for (double& wanted : size)
        wanted = std::max(wanted, least_size);
    return true;
}

void WorkingMesh::split(int t, int k)
{
    const int a = corner(t, k), b = corner(t, k + 1);
    const double grown = size_growth * 0.5 * length(t, k);
    // On a bend, the middle of an edge is as curved as its ends.
    const double largest = is_flat_[patch[t]] ? largest_ : std::max(size[a], size[b]);
    size.push_back(std::min({size[a] + grown, size[b] + grown, largest}));
    point.push_back(0.5 * (point[a] + point[b]));
    origin.push_back(-1);
    is_frozen.push_back(0);
    patch.insert(patch.end(), 2, patch[t]);
    EditableTriangles::split(t, k);
}

}  // namespace sheetmorph::repair
