// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/rates/target_rates.h"
#include "sheetmorph/surface/solve/deformation.h"
#include "sheetmorph/volume/local_rotations.h"

namespace sheetmorph::assembly
{

//! A part with how it changes.
struct PartInMotion
{
    const surface::Deformation& shape;
    const surface::DeformationRate& rate;
};

//! How the surface of a part turns at some vertices, and how that changes.
struct TurnedRates
{
    volume::LocalRotations measured;
    Points spins;  //!< (k, 3) of the rotations
    Points logs;   //!< (k, 3) of the logs
};

//! \param meter  of these vertices
//! \throws NoDerivative near whole turns
TurnedRates turned_rates(const volume::LocalRotationMeter& meter, const VertexIds& vertices,
                         const PartInMotion& part);

}  // namespace sheetmorph::assembly
