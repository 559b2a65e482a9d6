// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <string>

namespace sheetmorph::surface
{

//! How the rotation of a form feature is determined (mathematics.md, section 4).
enum class FeatureRotation
{
    free,          //!< by the energy: a rigid body in an elastic sheet
    interpolated,  //!< by the rotation field alone, as in the paper
    prescribed     //!< by the pose
};

//! The allowed motion of a form feature. All types but `axis` restrict the displacement of the
//! feature's centre (the mean of its vertices).
struct FeatureMotion
{
    enum class Type
    {
        free,
        fixed,        //!< does not move
        translation,  //!< translates but does not rotate
        plane,  //!< translates at right angles to `direction`; a free rotation is about it only
        line,   //!< translates along `direction`
        axis    //!< only rotates about the axis through `point` along `direction`
    };

    Type type = Type::free;
    Vector3 point = Vector3::Zero();       //!< mm, only for `axis`
    Vector3 direction = Vector3::UnitZ();  //!< unit length
};

//! The relation between two form features.
enum class FeatureLinkType
{
    coaxial,  //!< common axis: the follower rotates about it and slides along it
    distance  //!< constant distance of their centres
};

}  // namespace sheetmorph::surface
