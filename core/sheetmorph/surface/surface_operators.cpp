// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/surface_operators.h"

#include "sheetmorph/mesh/operators.h"

#include <numeric>

namespace sheetmorph
{

SurfaceOperators surface_operators(const TriangleMesh& mesh, Energy energy)
{
    SurfaceOperators operators;
    operators.half_cotangents = half_cotangents(mesh);
    operators.vertex_areas = voronoi_areas(mesh);
    operators.harmonic = non_negative_stiffness(mesh, operators.half_cotangents);
    const Eigen::VectorXd per_area = (2.0 * operators.vertex_areas).cwiseInverse();
    operators.rows = rows_scaled(cotangent_stiffness(mesh, operators.half_cotangents), per_area);
    operators.rest_rows =
        per_area.asDiagonal() * apply_stiffness(mesh, operators.half_cotangents, mesh.points());
    operators.row_vertices.resize(static_cast<std::size_t>(mesh.vertex_count()));
    std::iota(operators.row_vertices.begin(), operators.row_vertices.end(), 0);
    operators.weights = energy == Energy::paper
                            ? Eigen::VectorXd(Eigen::VectorXd::Ones(mesh.vertex_count()))
                            : operators.vertex_areas;
    return operators;
}

}  // namespace sheetmorph
