// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/text.h"
#include "sheetmorph/surface/constraints/feature_motion.h"

#include <vector>

namespace sheetmorph::assembly
{

//! Form features of one part that move as one rigid body.
struct FeatureGroup
{
    std::string name;
    std::vector<int> features;  //!< indices into Assembly::features
};

//! Two form features, of one or two parts, that keep their common axis or their distance.
struct FeaturePair
{
    std::string name;
    surface::FeatureLinkType type = surface::FeatureLinkType::coaxial;
    int a = 0;  //!< index into Assembly::features
    int b = 0;
    std::vector<Subject> of = {};  //!< the pair that it mirrors; empty for itself
};

//! A plane of symmetry of the assembly: one side follows the other, mirrored.
struct SymmetryPlane
{
    Vector3 point = Vector3::Zero();    //!< mm
    Vector3 normal = Vector3::UnitX();  //!< unit length
};

}  // namespace sheetmorph::assembly
