// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/features/feature_responses.h"

namespace sheetmorph::surface
{

//! How far the field turns, at most, between each turner and where the sheet still turns with it.
//! \param logs  (n, 3) of the rotation field
//! \returns     (turners) lengths of differences of logs
std::vector<double> farthest_turns(const FeatureResponses& responses, const Points& logs);

//! Holds features at the field's rotation where the field turns by more than a right angle around
//! them: there the energy of a flat sheet, which sees cosines, has no minimum of its own.
//! \param farthest  farthest_turns()
//! \param start     turners with the rotation of the field
//! \returns         whether any is held
bool hold_far_turned(const FeatureResponses& responses, const std::vector<double>& farthest,
                     const Joints& start, ReducedEnergy& energy);

//! What the sheet turns like at every vertex, as far as logs can tell.
//! \param states  of the turners
//! \param logs    (n, 3) of the rotation field; changed where turners turn the sheet
void blend_logs(const FeatureResponses& responses, const std::vector<BodyState>& states,
                Points& logs);

}  // namespace sheetmorph::surface
