// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/surface/constraints/constraints.h"
#include "sheetmorph/surface/constraints/targets.h"

#include <random>

namespace sheetmorph::surface
{

//! Motions of a handle drawn all over where it may be dragged, the same ones every time.
class DrawnMotions
{
public:
    //! \param handle    its vertices: the motion is about their middle
    //! \param start     where it stands
    //! \param farthest  radians that it turns from there, moved by up to a third of the part
    RigidMotion next(const mesh::TriangleMesh& mesh, const VertexIds& handle,
                     const RigidMotion& start, double farthest);

private:
    Vector3 within(double radius);
    double share();

    std::mt19937 bits_{1};
};

//! Poses of a part in which some handles turn and move on their own, from which a response learns:
//! one by up to 165 degrees, two by up to 100, more by up to 75. The first is `start`.
std::vector<SurfaceTargets> own_poses(const mesh::TriangleMesh& mesh,
                                      const SurfaceConstraints& constraints,
                                      const SurfaceTargets& start, const std::vector<int>& turning);

}  // namespace sheetmorph::surface
