// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/base/progress.h"
#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::surface
{

//! (n, 2) positions in a plane, mm.
using FlatPoints = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

//! Input of flatten().
struct FlatInput
{
    const mesh::TriangleMesh& mesh;  //!< connected
    std::vector<VertexIds> rims;     //!< rims that keep their shape if they are plane; disjoint

    //! (m, 3) of length 1, and (m) the stretch of the sheet along them in the flat shape (neutral
    //! fibre of bends). Both may be empty.
    Points directions = {};
    Eigen::VectorXd factors = {};
};

//! A flattened sheet.
struct Flattening
{
    FlatPoints positions;  //!< (n, 2) mm, seen from the side to which its normals point
    Convergence convergence = {};
    std::vector<char> is_rigid;  //!< by rim: whether it was plane and kept its shape
    std::vector<int> turned;     //!< triangles flipped to agree with the majority
    std::vector<int> flipped;    //!< triangles with a negative area in the result
};

//! Flattens a sheet with as little stretch as possible. It starts from a least squares conformal
//! map (Levy 2002) and minimises the membrane energy of steel in the plane by Newton's method. The
//! method is purely geometric; it does not simulate forming tools or friction.
//! \throws InvalidInput for a sheet that is closed, one-sided, disconnected, or has edges of more
//!                      than two triangles; for rims with missing or repeated vertices; for a
//!                      neutral fibre without a finite direction and a factor > 0 for each triangle
//! \throws Cancelled    on request of the progress callback
Flattening flatten(const FlatInput& input, const Progress& progress = {});

}  // namespace sheetmorph::surface
