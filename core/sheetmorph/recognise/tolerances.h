// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/limits.h"
#include "sheetmorph/fitting/circle.h"
#include "sheetmorph/fitting/outline.h"

namespace sheetmorph::recognise
{

//! Tolerances of feature recognition. Angles in radians; shares have no unit.
struct FeatureTolerances
{
    double crease_angle = 0.6;     //!< a sharper bend is an edge of the shape (34 degrees)
    double smooth_angle = 0.9;     //!< the same where a curved surface may continue (52 degrees)
    double plane_angle = 0.1;      //!< largest bend inside a plane (6 degrees)
    //! largest deviation of a rim, relative to half its width; from fit_outline()
    double roundness = fitting::default_roundness;
    double surface = 0.01;         //!< residual of a curved surface, relative to its radius
    double smallest_area = 0.004;  //!< area of a plane, flange or bead, relative to its part
    //! standard deviation of measured vertices about their surface, mm; < 0: estimated
    double scatter = -1.0;
    double weld = 1e-7;            //!< vertices nearer than this share of the mesh size merge
    int fewest_rim_vertices = fitting::fewest_rim_points;  //!< of a hole
    int washer_rings = 1;          //!< rings of triangles proposed as a washer around a hole
    double smallest_radius = 0.0;  //!< mm, of holes
    double largest_radius = largest_number;  //!< mm, of holes

    //! \throws InvalidInput naming the tolerance that is out of range
    void check() const;
};

//! Tolerances of contact recognition. Lengths in mm, angles in radians.
struct ContactTolerances
{
    double gap = -1.0;  //!< largest gap beyond half of both thicknesses; < 0: proposed_gap()
    double facing_angle = 0.6;  //!< largest angle between surfaces that face each other
    double coaxial = 0.35;      //!< offset of two holes, relative to the smaller radius
    double bolt_ratio = 2.5;    //!< largest ratio of the radii of two coaxial holes
    int smallest = 3;           //!< fewest vertices on the smaller side
    bool joins_pairs = false;   //!< one contact per pair of parts instead of one per patch

    //! \throws InvalidInput naming the tolerance that is out of range
    void check() const;
};

}  // namespace sheetmorph::recognise
