// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <string>

namespace sheetmorph::surface
{

//! What decides how a form feature turns (mathematics.md, section 4).
enum class FeatureRotation
{
    free,          //!< the energy: a rigid body in an elastic sheet
    interpolated,  //!< the rotation field alone, as in the paper
    prescribed     //!< the pose
};

//! What a form feature may do. All but `axis` bind the displacement of the feature's centre (the
//! mean of its vertices).
struct FeatureMotion
{
    enum class Type
    {
        free,
        fixed,        //!< stays where it is
        translation,  //!< shifts, never turns
        plane,        //!< shifts at right angles to `direction`; a free rotation is about it only
        line,         //!< shifts along `direction`
        axis          //!< turns about the axis through `point` along `direction`, nothing else
    };

    Type type = Type::free;
    Vector3 point = Vector3::Zero();       //!< mm, read for `axis`
    Vector3 direction = Vector3::UnitZ();  //!< unit length
};

//! What two form features keep between them.
enum class FeatureLinkType
{
    coaxial,  //!< their common axis: the follower turns about it and slides along it
    distance  //!< the distance of their centres
};

}  // namespace sheetmorph::surface
