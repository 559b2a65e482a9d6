// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/splines/face_spline.h"

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>

namespace sheetmorph::cad
{

//! An edge of a face, in the parameters of the face.
struct FaceBorder
{
    Handle(Geom2d_Curve) curve;
    double low = 0.0, high = 0.0;
    bool is_degenerated = false;  //!< a single point in space
    Handle(Geom_Curve) target;    //!< curve in space that the face must meet; may be null
};

//! The part of a surface between borders, slightly larger if they are curved.
SurfacePatch surface_patch(const Handle(Geom_Surface) & surface,
                           const std::vector<FaceBorder>& borders);

}  // namespace sheetmorph::cad
