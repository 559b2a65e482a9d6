// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/rigid_motion.h"

#include "sheetmorph/base/rotation.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace sheetmorph
{

namespace
{

// The optimal rotation for a covariance matrix. If the points do not determine it (all on a line,
// or all in one place), the smallest of the optimal rotations.
Matrix3 rotation_of_covariance(const Matrix3& covariance)
{
    const Eigen::JacobiSVD<Matrix3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Vector3 spread = svd.singularValues();
    if (spread(0) <= 0.0)
        return Matrix3::Identity();
    // Squares of lengths: the points lie on a line to 1e-5 of its length.
    if (spread(1) <= 1e-10 * spread(0))
        return Eigen::Quaterniond::FromTwoVectors(svd.matrixU().col(0), svd.matrixV().col(0))
            .toRotationMatrix();
    Vector3 signs = Vector3::Ones();
    if ((svd.matrixV() * svd.matrixU().transpose()).determinant() < 0.0)
        signs(2) = -1.0;
    return svd.matrixV() * signs.asDiagonal() * svd.matrixU().transpose();
}

}  // namespace

Matrix3 RigidMotion::rotation() const
{
    return rotation_from_log(rotation_log);
}

Vector3 RigidMotion::apply(const Vector3& point) const
{
    if (rotation_log.isZero(0.0))
        return point + translation;
    return pivot + translation + rotation() * (point - pivot);
}

Points RigidMotion::apply(const Points& points) const
{
    if (rotation_log.isZero(0.0))
        return points.rowwise() + translation.transpose();
    const Matrix3 transposed = rotation().transpose();
    const Eigen::RowVector3d start = pivot.transpose();
    const Eigen::RowVector3d goal = (pivot + translation).transpose();
    return ((points.rowwise() - start) * transposed).rowwise() + goal;
}

RigidMotion best_rigid_motion(const Points& from, const Points& to, const Eigen::VectorXd& weights)
{
    const Eigen::Index count = from.rows();
    Eigen::VectorXd share =
        weights.size() == count ? weights : Eigen::VectorXd(Eigen::VectorXd::Ones(count));
    share /= share.sum();
    const Eigen::RowVector3d centre_from = share.transpose() * from;
    const Eigen::RowVector3d centre_to = share.transpose() * to;
    const Matrix3 covariance = (from.rowwise() - centre_from).transpose() * share.asDiagonal()
                               * (to.rowwise() - centre_to);
    RigidMotion motion;
    motion.pivot = centre_from.transpose();
    motion.translation = (centre_to - centre_from).transpose();
    motion.rotation_log = log_from_rotation(rotation_of_covariance(covariance));
    return motion;
}

RigidMotion best_rigid_motion_near(const Points& from, const Points& to,
                                   const Vector3& rotation_log)
{
    RigidMotion motion;
    motion.pivot = from.colwise().mean().transpose();
    motion.translation = to.colwise().mean().transpose() - motion.pivot;
    const Matrix3 known = rotation_from_log(rotation_log);
    const Points start = (from.rowwise() - motion.pivot.transpose()) * known.transpose();
    const Points goal = to.rowwise() - to.colwise().mean();
    const double extent = start.norm() * goal.norm();
    const Matrix3 covariance =
        start.transpose() * goal + stiffness_of_known_rotation * extent * Matrix3::Identity();
    const Matrix3 rest = rotation_of_covariance(covariance);
    motion.rotation_log = nearest_branch(log_from_rotation(rest * known), rotation_log);
    return motion;
}

}  // namespace sheetmorph
