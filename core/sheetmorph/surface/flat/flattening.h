// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/base/progress.h"
#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::surface
{

//! (n, 2) places in a plane, mm.
using FlatPoints = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

//! A sheet to be laid flat.
struct FlatInput
{
    const mesh::TriangleMesh& mesh;  //!< of one piece
    std::vector<VertexIds> rims;     //!< keep their form where they are plane; they share no vertex

    //! (m, 3) of length 1, and (m) how much longer the sheet is along them once it is flat (the
    //! neutral fibre of bends); both may be empty.
    Points directions = {};
    Eigen::VectorXd factors = {};
};

//! A sheet laid flat.
struct Flattening
{
    FlatPoints positions;  //!< (n, 2) mm, seen from the side that its normals point to
    Convergence convergence = {};
    std::vector<char> is_rigid;  //!< by rim: it was plane, and kept its form
    std::vector<int> turned;     //!< triangles that most of the sheet faces away from, and which
                                 //!< were turned for it
    std::vector<int> flipped;    //!< triangles that came out upside down
};

//! Lays a sheet flat with as little stretch as it can: from a least squares conformal map (Levy
//! 2002) on, the membrane energy of steel in the plane, by Newton's method. Kinematics alone: no
//! press, no friction.
//! \throws InvalidInput for a sheet that is closed, one-sided, in pieces, or has edges of more than
//! two triangles; for rims that name a vertex it has not, or one twice; for a neutral fibre that
//! has not one finite direction and one factor above 0 for each triangle
//! \throws Cancelled if the progress callback asks for it
Flattening flatten(const FlatInput& input, const Progress& progress = {});

}  // namespace sheetmorph::surface
