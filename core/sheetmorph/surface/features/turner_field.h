// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/features/feature_responses.h"

namespace sheetmorph::surface
{

//! The largest angle of the field between each rotating body and the sheet that it rotates.
//! \param logs  (n, 3) of the rotation field
//! \returns     by rotating body: norm of the difference of logs, half the angle in radians
std::vector<double> farthest_turns(const FeatureResponses& responses, const Points& logs);

//! Constrains features towards the field's rotation if the field turns strongly around them:
//! gradually from 75 degrees on, fully from 150 degrees on. The energy of a flat sheet only depends
//! on cosines and has no minimum of its own there.
//! \param farthest  farthest_turns()
//! \param start     rotating bodies with the rotation of the field
//! \returns         whether any feature is constrained
bool hold_far_turned(const FeatureResponses& responses, const std::vector<double>& farthest,
                     const Joints& start, ReducedEnergy& energy);

//! The rotation of the sheet at every vertex, as logs.
//! \param states  of the rotating bodies
//! \param logs    (n, 3) of the rotation field; changed where bodies rotate the sheet
void blend_logs(const FeatureResponses& responses, const std::vector<BodyState>& states,
                Points& logs);

}  // namespace sheetmorph::surface
