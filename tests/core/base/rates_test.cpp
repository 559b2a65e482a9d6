// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/rates.h"

#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotation.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace sheetmorph
{

namespace
{

constexpr double step = 1e-5;

// The spin of a rotation that depends on a number, by a central difference.
template <typename Rotation>
Vector3 spin_by_difference(Rotation rotation)
{
    return log_from_rotation(rotation(step) * rotation(-step).transpose()) / step;
}

TEST(Rates, TheSpinOfALogIsThatOfItsRotation)
{
    const Vector3 rate(0.3, -0.2, 0.5);
    for (const double size : {0.0, 1e-7, 0.2, 1.0, 2.0})
    {
        const Vector3 log = size * Vector3(0.6, 0.0, -0.8);
        const Vector3 spin = spin_of_log(log, rate);
        const Vector3 wanted = spin_by_difference(
            [&](double t) { return rotation_from_log(Vector3(log + t * rate)); });
        EXPECT_LT((spin - wanted).norm(), 1e-8) << size;
        EXPECT_LT((log_rate_of_spin(log, spin) - rate).norm(), 1e-12) << size;
    }
}

TEST(Rates, AWholeTurnHasNone)
{
    const Vector3 log = 3.1 * Vector3::UnitX();
    EXPECT_THROW(log_rate_of_spin(log, Vector3::UnitY()), NoDerivative);
    EXPECT_THROW(require_whole_log(rotation_from_log(log), log), NoDerivative);
}

TEST(Rates, ThePolarFactorTurnsWithItsMatrix)
{
    Matrix3 matrix, rate;
    matrix << 1.0, 0.2, -0.1, 0.1, 1.3, 0.3, 0.4, -0.2, 0.9;
    rate << 0.3, -0.5, 0.2, 0.7, 0.1, -0.4, 0.2, 0.6, -0.3;
    const Vector3 wanted =
        spin_by_difference([&](double t) { return polar_rotation(Matrix3(matrix + t * rate)); });
    EXPECT_LT((spin_of_polar(polar_rotation(matrix), matrix, rate) - wanted).norm(), 1e-8);
}

TEST(Rates, APointMovesWithItsMotion)
{
    const RigidMotion motion{{1, 2, 3}, {0.2, -0.4, 0.3}, {4, 0, -1}};
    MotionRate rate{{0.5, -1, 2}, {0.1, 0.2, -0.3}, {0.7, 0.1, 0.4}};
    rate.spin = spin_of_log(motion.rotation_log, rate.log);
    const Vector3 point(2, 7, -5);
    const auto moved = [&](double t)
    {
        const RigidMotion then{motion.translation + t * rate.shift,
                               motion.rotation_log + t * rate.log, motion.pivot + t * rate.pivot};
        return then.apply(point);
    };
    const Vector3 wanted = (moved(step) - moved(-step)) / (2.0 * step);
    EXPECT_LT((rate.at(motion, point) - wanted).norm(), 1e-8);
    const RigidMotion there{motion.apply(point) - point, motion.rotation_log, point};
    EXPECT_LT((rate.about(motion, point).at(there, point) - wanted).norm(), 1e-8);
}

TEST(Rates, TheBestMotionTurnsWithItsPointsAndWhatIsKnown)
{
    Points from(5, 3), to(5, 3), rates(5, 3);
    from << 0, 0, 0, 4, 0, 0, 4, 1, 0, 0, 1, 0, 2, 0.5, 0.1;
    to << 0, 0, 0.1, 3.9, 0.5, 1, 3.8, 1.4, 1.2, 0.1, 1, 0, 2, 1, 0.6;
    rates << 1, 0, 0, 0, 1, 0, 0, 0.5, 1, -1, 0, 0.3, 0.2, 0.2, 0;
    const Vector3 log(0.1, -0.1, 0.05), log_rate(0.2, 0.1, 0.3);
    const auto best = [&](double t) {
        return best_rigid_motion_near(from, to + t * rates, Vector3(log + t * log_rate)).rotation();
    };
    const Vector3 spin =
        best_motion_spin(from, to, rates, {rotation_from_log(log), spin_of_log(log, log_rate)});
    EXPECT_LT((spin - spin_by_difference(best)).norm(), 1e-8);
}

}  // namespace

}  // namespace sheetmorph
