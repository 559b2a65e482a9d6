// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/response/response_basis.h"
#include "sheetmorph/surface/bodies/body_motions.h"

namespace sheetmorph
{

//! A pose in the numbers of the fields. What is rigid is known before any vertex is placed.
struct SampledFrame
{
    ResponseBasis::Coefficients coefficients;
    Points logs;                        // of the vertices that are watched
    BodyMotions bodies;                 // all of them
    std::vector<RigidMotion> handles;   // of the pose
    std::vector<RigidMotion> features;  // about their rest centroids
    std::vector<Points> regions;        // positions of the propagated ones
    std::vector<BodyState> free;        // features that the energy turns
};

}  // namespace sheetmorph
