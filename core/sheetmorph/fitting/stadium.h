// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"

#include <Eigen/Core>

namespace sheetmorph::fitting
{

//! (k, 2) points of a plane.
using PlanePoints = Eigen::Matrix<double, Eigen::Dynamic, 2>;

//! The outline of a slot: all points of a plane at a fixed distance from a segment. A segment of
//! length 0 gives a circle.
struct Stadium
{
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double angle = 0.0;  //!< of the segment, radians
    double half_segment = 0.0;
    double radius = 1.0;

    Eigen::Vector2d along() const;
    Eigen::Vector2d across() const;

    //! The vector from the nearest point of the segment to a point.
    Eigen::Vector2d arm(const Eigen::Vector2d& point) const;

    //! Signed distances (k) of points from the outline, negative inside.
    Eigen::VectorXd misses(const PlanePoints& points) const;
};

//! Options of fit_stadium().
struct StadiumFit
{
    const char* what;                  //!< as Convergence::what
    bool is_slot = false;              //!< fit the angle and length of the segment as well
    bool leaves_undetermined = false;  //!< keep parameters that the points do not determine
};

//! Fits a circle or slot to points by least squares of their distances (Gauss-Newton).
//! \param shape  the initial guess, of a size of about 1; replaced by the result
[[nodiscard]] Convergence fit_stadium(const PlanePoints& points, const StadiumFit& how,
                                      Stadium& shape);

}  // namespace sheetmorph::fitting
