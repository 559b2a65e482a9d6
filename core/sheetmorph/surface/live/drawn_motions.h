// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/surface/constraints/constraints.h"
#include "sheetmorph/surface/constraints/targets.h"

#include <random>

namespace sheetmorph::surface
{

//! Random motions of a handle over its range of drags; the sequence is reproducible.
class DrawnMotions
{
public:
    //! \param handle    its vertices; the motion is about their mean
    //! \param start     its initial motion
    //! \param farthest  largest additional rotation, radians; translations reach 0.35 of the part's
    //!                  size
    RigidMotion next(const mesh::TriangleMesh& mesh, const VertexIds& handle,
                     const RigidMotion& start, double farthest);

private:
    Vector3 within(double radius);
    double share();

    std::mt19937 bits_{1};
};

//! Training poses of a response, in which some handles move and rotate independently. The rotations
//! reach 165 degrees for one handle, 100 degrees for two and 75 degrees for more. The first pose is
//! `start`.
std::vector<SurfaceTargets> own_poses(const mesh::TriangleMesh& mesh,
                                      const SurfaceConstraints& constraints,
                                      const SurfaceTargets& start, const std::vector<int>& turning);

}  // namespace sheetmorph::surface
