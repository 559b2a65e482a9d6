// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::volume
{

//! Contribution of one triangle, near whose plane the point lies, to the point's mean value
//! weights.
struct GrazedTriangle
{
    bool on_surface = false;            //!< whether the point lies on the triangle
    Vector3 weights = Vector3::Zero();  //!< unnormalised; (2.14) if the point lies on it
};

//! The mean value weights of one triangle in extended precision. Uses the limits where the vector
//! form has none: on the triangle, and in its plane outside it.
//! \param corners    rows: the corners of the triangle, mm
//! \param tolerance  points nearer than this lie on the triangle, mm
GrazedTriangle grazed_triangle(const Matrix3& corners, const Vector3& point, double tolerance);

}  // namespace sheetmorph::volume
