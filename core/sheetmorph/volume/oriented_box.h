// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::volume
{

//! A box around points, in its own frame.
struct OrientedBox
{
    Matrix3 axes = Matrix3::Identity();      //!< columns: unit, right-handed
    Vector3 centre = Vector3::Zero();        //!< mm
    Vector3 half_extents = Vector3::Zero();  //!< mm, all > 0
    Vector3 widened_by = Vector3::Zero();    //!< mm: added by margin and thickness
};

//! How a box gets room for a control mesh.
struct BoxOptions
{
    double margin = 0.1;              //!< added on every side, relative to the largest half extent
    double minimum_thickness = 0.25;  //!< smallest half extent, relative to the largest
    double single_point_size = 1.0;   //!< half extents of the box around a single point, mm
};

//! Principal axes, longest first. If principal values agree to 1e-6 (a washer, a straight row, a
//! single point), the points do not determine all axes. The others come from `fallback`, so that a
//! rotated model with a rotated fallback gives rotated axes. Pass the part's axes for a region, and
//! the assembly's axes for a part.
//! \param points    (n, 3) mm, n >= 1
//! \param weights   (n), >= 0, such as vertex areas; empty for equal ones
//! \param fallback  columns: unit, orthogonal
//! \returns          columns: unit, right-handed
//! \throws InvalidInput if there are no points, or one is not finite
Matrix3 principal_axes(const Points& points, const Eigen::VectorXd& weights,
                       const Matrix3& fallback);

//! The smallest box along `axes` around the points, widened by the options.
//! \throws InvalidInput if there are no points, or the options are negative or not finite
OrientedBox oriented_box(const Points& points, const Matrix3& axes, const BoxOptions& options = {});

}  // namespace sheetmorph::volume
