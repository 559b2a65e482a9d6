// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/surface/bodies/body_motions.h"

namespace sheetmorph::surface
{

//! Offset b (n, 3) of u = S y + b: known vertices wholly, open bodies their turn about the centre.
Eigen::MatrixXd known_displacements(const PlacementInput& part, const SurfaceTargets& targets,
                                    const BodyMotions& bodies);

//! Reads the translations of open bodies from the solved displacements (n, 3).
void complete_bodies(const PlacementInput& part, const Eigen::MatrixXd& displacements,
                     BodyMotions& bodies);

//! (n, 3) positions: free vertices from the displacements, features as (2.4), the known as told.
Points placed_positions(const PlacementInput& part, const SurfaceTargets& targets,
                        const BodyMotions& bodies, const Eigen::MatrixXd& displacements);

//! Motion of every form feature about its rest centroid.
std::vector<RigidMotion> feature_motions(const PlacementInput& part, const BodyMotions& bodies);

}  // namespace sheetmorph::surface
