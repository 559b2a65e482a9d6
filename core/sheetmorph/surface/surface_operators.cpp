// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/surface_operators.h"

#include "sheetmorph/mesh/operators.h"

namespace sheetmorph
{

SurfaceOperators surface_operators(const TriangleMesh& mesh, Energy energy)
{
    SurfaceOperators operators;
    operators.half_cotangents = half_cotangents(mesh);
    operators.vertex_areas = voronoi_areas(mesh);
    const Eigen::VectorXd per_area = (2.0 * operators.vertex_areas).cwiseInverse();
    operators.laplacian =
        rows_scaled(cotangent_stiffness(mesh, operators.half_cotangents), per_area);
    operators.curvature_normals =
        per_area.asDiagonal() * apply_stiffness(mesh, operators.half_cotangents, mesh.points());
    operators.weights = energy == Energy::paper
                            ? Eigen::VectorXd(Eigen::VectorXd::Ones(mesh.vertex_count()))
                            : operators.vertex_areas;
    return operators;
}

}  // namespace sheetmorph
