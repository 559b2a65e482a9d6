// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/carry/rigid_fit.h"
#include "sheetmorph/base/rigid_motion.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gp_Quaternion.hxx>

namespace sheetmorph
{

namespace
{

bool is_plane_spanned(const Points& points)
{
    const Points about = points.rowwise() - points.colwise().mean();
    const Matrix3 moments = about.transpose() * about;
    const Vector3 values = Eigen::SelfAdjointEigenSolver<Matrix3>(moments).eigenvalues();
    constexpr double straight = 1e-8;  // a thousandth of a percent of its length wide
    return values(1) > straight * values(2);
}

}  // namespace

std::optional<gp_Trsf> rigid_fit(const Points& from, const Points& to, double tolerance,
                                 bool is_straight)
{
    if (from.rows() < (is_straight ? 2 : 3) || (!is_straight && !is_plane_spanned(from)))
        return {};
    const Vector3 centre = from.colwise().mean(), there = to.colwise().mean();
    // Far from the origin a turn and a shift would cancel.
    const Points one = from.rowwise() - centre.transpose(),
                 other = to.rowwise() - there.transpose();
    const RigidMotion best = best_rigid_motion(one, other);
    const Points moved = best.apply(one);
    if ((moved - other).rowwise().norm().maxCoeff() > tolerance)
        return {};
    const Eigen::Quaterniond turn(best.rotation());
    gp_Trsf motion;
    motion.SetRotation(gp_Quaternion(turn.x(), turn.y(), turn.z(), turn.w()));
    const Vector3 zero = best.apply(Vector3(-centre)) + there;
    motion.SetTranslationPart(gp_Vec(zero(0), zero(1), zero(2)));
    return motion;
}

Vector3 moved(const Vector3& point, const gp_Trsf& motion)
{
    const gp_Pnt there = gp_Pnt(point(0), point(1), point(2)).Transformed(motion);
    return {there.X(), there.Y(), there.Z()};
}

}  // namespace sheetmorph
