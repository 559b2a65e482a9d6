// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/rotation/rotation_series.h"

#include "sheetmorph/base/rotation.h"

#include <gtest/gtest.h>

namespace sheetmorph
{
namespace
{

Vector3 turn(double degrees)
{
    return rotation_log({0.3, 1.0, -0.5}, degrees * M_PI / 180.0);
}

// Weights of two handles all over their triangle; of one: the first column.
Eigen::MatrixXd weights(int handles)
{
    Eigen::MatrixXd all(231, 2);
    int row = 0;
    for (int a = 0; a <= 20; ++a)
        for (int b = 0; a + b <= 20; ++b)
            all.row(row++) << a / 20.0, b / 20.0;
    return all.leftCols(handles);
}

double worst_miss(const RotationSeries& series, const Eigen::MatrixXd& at,
                  const std::vector<Vector3>& logs)
{
    const RotationSeries::Fit fit = series.fit(logs);
    const Eigen::MatrixXd values = series.values(at);
    double worst = 0.0;
    for (Eigen::Index i = 0; i < at.rows(); ++i)
    {
        Vector3 log = Vector3::Zero();
        for (std::size_t s = 0; s < logs.size(); ++s)
            log += at(i, static_cast<Eigen::Index>(s)) * logs[s];
        Matrix3 sum = Matrix3::Identity() - rotation_from_log(log);
        for (int k = 0; k < series.count(); ++k)
            sum += values(i, k) * fit.matrices[static_cast<std::size_t>(k)];
        worst = std::max(worst, sum.cwiseAbs().maxCoeff());
    }
    return worst;
}

TEST(RotationSeries, EightPolynomialsTellTheTurnsOfOneHandleUpTo165Degrees)
{
    const RotationSeries series(weights(1), 8);
    EXPECT_EQ(series.count(), 8);
    EXPECT_LT(worst_miss(series, weights(1), {turn(90.0)}), 2e-9);
    EXPECT_LT(worst_miss(series, weights(1), {turn(165.0)}), 4e-7);
}

TEST(RotationSeries, TellsTwoHandlesThatTurnAboutDifferentAxes)
{
    const RotationSeries series(weights(2), 7);
    EXPECT_EQ(series.count(), 35);
    const std::vector<Vector3> logs = {turn(80.0), rotation_log({1.0, -0.2, 0.1}, 1.2)};
    EXPECT_LT(worst_miss(series, weights(2), logs), 2e-7);
}

TEST(RotationSeries, KnowsItsOwnError)
{
    for (const int handles : {1, 2})
        for (const double degrees : {60.0, 150.0, 250.0})
        {
            const RotationSeries series(weights(handles), 6);
            std::vector<Vector3> logs = {turn(degrees)};
            if (handles == 2)
                logs.push_back(rotation_log({1.0, 0.0, 0.0}, 0.5));
            const double miss = worst_miss(series, weights(handles), logs);
            EXPECT_LT(miss, 1.5 * series.fit(logs).error + 1e-14);
            EXPECT_GT(miss, 0.2 * series.fit(logs).error);
        }
}

TEST(RotationSeries, ReachesWeightsThatOvershoot)
{
    const Eigen::MatrixXd wide = (1.6 * weights(1).array() - 0.3).matrix();
    EXPECT_LT(worst_miss(RotationSeries(wide, 8), wide, {turn(90.0)}), 1e-7);
}

TEST(RotationSeries, TurnsNothingWhereTheWeightIsZero)
{
    const RotationSeries series(weights(1), 8);
    EXPECT_LT(series.values(Eigen::MatrixXd::Zero(1, 1)).cwiseAbs().maxCoeff(), 1e-13);
}

}  // namespace
}  // namespace sheetmorph
