// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"

#include <Eigen/Core>

namespace sheetmorph
{

//! (k, 2) points of a plane.
using PlanePoints = Eigen::Matrix<double, Eigen::Dynamic, 2>;

//! All points of a plane at one distance from a segment: the outline of a slot, or a circle where
//! the segment has no length.
struct Stadium
{
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double angle = 0.0;  //!< of the segment, radians
    double half_segment = 0.0;
    double radius = 1.0;

    Eigen::Vector2d along() const;
    Eigen::Vector2d across() const;

    //! From the nearest point of the segment to a point.
    Eigen::Vector2d arm(const Eigen::Vector2d& point) const;

    //! (k) distances of points from it, negative inside.
    Eigen::VectorXd misses(const PlanePoints& points) const;
};

//! How a stadium is fitted.
struct StadiumFit
{
    const char* what;                  //!< as Convergence::what
    bool is_slot = false;              //!< the segment may turn and change its length, too
    bool leaves_undetermined = false;  //!< what the points do not determine stays as it was
};

//! Moves a circle or slot to the least sum of squared distances of the points, by Gauss-Newton
//! steps.
//! \param shape  where it starts, of about the size 1
[[nodiscard]] Convergence fit_stadium(const PlanePoints& points, const StadiumFit& how,
                                      Stadium& shape);

}  // namespace sheetmorph
