// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/geometry/facets.h"

#include "sheetmorph/mesh/geometry/areas.h"

#include <Eigen/Geometry>

namespace sheetmorph::mesh
{

fitting::FacetSample facets_of(const TriangleMesh& mesh)
{
    const int count = mesh.triangle_count();
    fitting::FacetSample facets{mesh.points(), Points(count, 3), Points(count, 3),
                                Eigen::VectorXd(count)};
    for (int t = 0; t < count; ++t)
    {
        const Vector3 doubled = doubled_area(mesh, t);
        facets.areas(t) = 0.5 * doubled.norm();
        facets.normals.row(t) = doubled.normalized().transpose();
        facets.centroids.row(t) =
            mesh.points()(mesh.triangles().row(t), Eigen::indexing::all).colwise().mean();
    }
    return facets;
}

}  // namespace sheetmorph::mesh
