// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/assembly.h"

namespace sheetmorph::assembly
{

//! Reflection in a plane of symmetry.
class Mirror
{
public:
    explicit Mirror(const SymmetryPlane& plane) : plane_(plane) {}

    Vector3 point(const Vector3& position) const;
    Vector3 vector(const Vector3& direction) const;
    Vector3 log(const Vector3& rotation_log) const;  //!< a rotation's log is a pseudo-vector
    RigidMotion motion(const RigidMotion& given) const;

    //! The symmetric part of a translation, a rotation's log or a motion.
    Vector3 symmetric_vector(const Vector3& direction) const;
    Vector3 symmetric_log(const Vector3& rotation_log) const;
    RigidMotion symmetric_motion(const RigidMotion& given) const;

private:
    Vector3 across(const Vector3& direction) const;

    SymmetryPlane plane_;
};

}  // namespace sheetmorph::assembly
