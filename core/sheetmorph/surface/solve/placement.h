// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/surface/bodies/body_motions.h"

namespace sheetmorph::surface
{

//! Offset b (n, 3) of u = S y + b: full displacements of prescribed vertices; for bodies with an
//! unknown translation, the rotation about their centre.
Eigen::MatrixXd known_displacements(const PlacementInput& part, const SurfaceTargets& targets,
                                    const BodyMotions& bodies);

//! Reads the translations of bodies from the solved displacements (n, 3), where the sheet
//! determines them.
void complete_bodies(const PlacementInput& part, const Eigen::MatrixXd& displacements,
                     BodyMotions& bodies);

//! (n, 3) positions: free vertices from the displacements, features by (2.4), prescribed vertices
//! exactly at their targets.
Points placed_positions(const PlacementInput& part, const SurfaceTargets& targets,
                        const BodyMotions& bodies, const Eigen::MatrixXd& displacements);

//! Motion of every form feature about its rest centroid.
std::vector<RigidMotion> feature_motions(const PlacementInput& part, const BodyMotions& bodies);

}  // namespace sheetmorph::surface
