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
    //! A sharper bend is an edge of the shape, 34 degrees. From geometry: above the bend between 12
    //! facets of a round wall (30 degrees), below a chamfer (45 degrees).
    double crease_angle = 0.6;
    //! The same where a curved surface may continue, 52 degrees. From geometry: the bend between
    //! seven facets of a round wall is 51 degrees.
    double smooth_angle = 0.9;
    //! Largest bend inside a plane, 6 degrees. Chosen: a dent or the bend between two of 60 facets.
    double plane_angle = 0.1;
    //! Largest deviation of a rim, relative to half its width; from fit_outline().
    double roundness = fitting::default_roundness;
    //! Residual of a curved surface, relative to its radius. Chosen: tolerances of bends and tubes
    //! are about 1 % of the radius.
    double surface = 0.01;
    //! Area of a plane, flange or bead, relative to its part. Chosen: a square with a sixteenth of
    //! the side of a square part.
    double smallest_area = 0.004;
    //! Standard deviation of measured vertices about their surface, mm; < 0: estimated.
    double scatter = -1.0;
    //! Vertices nearer than this share of the mesh size merge. From STL, whose single precision
    //! rounds to 6e-8.
    double weld = 1e-7;
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
    //! Largest angle between surfaces that face each other.
    double facing_angle = FeatureTolerances{}.crease_angle;
    //! Offset of two holes, relative to the smaller radius. Chosen: holes of one bolt may be as far
    //! off as its play and a coarse rim; with more, the bolt would not pass.
    double coaxial = 0.35;
    //! Largest ratio of the radii of two coaxial holes. Chosen: the head of a screw is 1.7 times as
    //! wide as its shank (ISO 4762, M6: 10 mm), a washer twice (ISO 7089: 12 mm), so that one hole
    //! may let them pass.
    double bolt_ratio = 2.5;
    int smallest = 3;          //!< fewest vertices on the smaller side
    bool joins_pairs = false;  //!< one contact per pair of parts instead of one per patch

    //! \throws InvalidInput naming the tolerance that is out of range
    void check() const;
};

}  // namespace sheetmorph::recognise
