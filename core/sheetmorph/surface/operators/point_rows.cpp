// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/operators/point_rows.h"

namespace sheetmorph::surface
{

numerics::SparseMatrix point_rows(const mesh::TriangleMesh& mesh,
                                  const std::vector<PointConstraint>& points,
                                  const std::vector<int>& chosen)
{
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t row = 0; row < chosen.size(); ++row)
    {
        const PointConstraint& point = points[static_cast<std::size_t>(chosen[row])];
        for (int k = 0; k < 3; ++k)
            entries.emplace_back(static_cast<int>(row), mesh.triangles()(point.triangle, k),
                                 point.barycentric(k));
    }
    numerics::SparseMatrix rows(static_cast<Eigen::Index>(chosen.size()), mesh.vertex_count());
    rows.setFromTriplets(entries.begin(), entries.end());
    return rows;
}

Eigen::MatrixXd point_displacements(const mesh::TriangleMesh& mesh,
                                    const std::vector<PointConstraint>& points,
                                    const std::vector<PointTarget>& targets)
{
    Eigen::MatrixXd wanted(static_cast<Eigen::Index>(targets.size()), 3);
    for (std::size_t k = 0; k < targets.size(); ++k)
    {
        Vector3 start = Vector3::Zero();
        for (int corner = 0; corner < 3; ++corner)
            start += points[k].barycentric(corner)
                     * mesh.points().row(mesh.triangles()(points[k].triangle, corner)).transpose();
        wanted.row(static_cast<Eigen::Index>(k)) = (targets[k].position - start).transpose();
    }
    return wanted;
}

}  // namespace sheetmorph::surface
