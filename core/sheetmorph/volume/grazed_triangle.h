// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::volume
{

//! What a triangle near whose plane the point lies adds to the point's mean value weights.
struct GrazedTriangle
{
    bool on_surface = false;            //!< the point lies on the triangle, to `tolerance`
    Vector3 weights = Vector3::Zero();  //!< unnormalised, or (2.14) if it lies on it
};

//! The mean value weights of one triangle in extended precision, with the limits where the vector
//! form has none: on the triangle, and in its plane outside it.
//! \param corners    rows: the triangle's corners, mm
//! \param tolerance  distance that counts as on the surface, mm
GrazedTriangle grazed_triangle(const Matrix3& corners, const Vector3& point, double tolerance);

}  // namespace sheetmorph::volume
