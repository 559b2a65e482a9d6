// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/regions/round_holes.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/topology/boundary.h"

namespace sheetmorph::mesh
{

std::vector<RoundHole> round_holes(const TriangleMesh& mesh, double tolerance)
{
    if (!(tolerance > 0.0))
        throw InvalidInput("the tolerance of round holes must be greater than 0");
    std::vector<RoundHole> holes;
    for (const VertexIds& loop : boundary_loops(mesh))
        if (const auto circle =
                fitting::round_rim(mesh.points()(loop, Eigen::indexing::all), tolerance))
            holes.push_back({loop, *circle});
    return holes;
}

}  // namespace sheetmorph::mesh
