// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/rotations/rotation_batch.h"

#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotation.h"

#include <gtest/gtest.h>
#include <random>

namespace sheetmorph
{
namespace
{

// Logs of up to some radians, zeros among them; as many as no register holds.
Points drawn_logs(double farthest, unsigned seed)
{
    std::mt19937 bits(seed);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    Points logs(77, 3);
    for (double& entry : logs.reshaped())
        entry = farthest * share(bits);
    logs.row(5).setZero();
    return logs;
}

class RotationBatch : public testing::TestWithParam<double>
{
};

TEST_P(RotationBatch, TurnsAsEachLogAlone)
{
    const Points logs = drawn_logs(GetParam(), 1);
    const std::vector<Matrix3> rotations = rotations_from_logs(logs);
    ASSERT_EQ(rotations.size(), 77U);
    for (std::size_t k = 0; k < rotations.size(); ++k)
    {
        const auto row = static_cast<Eigen::Index>(k);
        const Matrix3 alone = rotation_from_log(logs.row(row).transpose());
        EXPECT_LT((rotations[k] - alone).norm(), 1e-14 * (1.0 + GetParam())) << k;
    }
    EXPECT_EQ(rotations[5], Matrix3::Identity());
}

TEST_P(RotationBatch, TellsLogsAndTiltsAsEachRotationAlone)
{
    const Points logs = drawn_logs(GetParam(), 1);
    const Points references = logs + drawn_logs(0.5, 2);
    const std::vector<Matrix3> rotations = rotations_from_logs(logs);
    const NearLogs found = logs_near(rotations, references);
    const Points tilts = found.tilts.rows() == 0 ? Points(Points::Zero(77, 3)) : found.tilts;
    for (std::size_t k = 0; k < rotations.size(); ++k)
    {
        const auto row = static_cast<Eigen::Index>(k);
        const Vector3 log = log_near(rotations[k], references.row(row).transpose());
        EXPECT_LT((found.logs.row(row).transpose() - log).norm(), 1e-12) << k;
        EXPECT_LT((tilts.row(row).transpose() - tilt_beyond(rotations[k], log)).norm(), 1e-12) << k;
    }
}

TEST_P(RotationBatch, WhatStandsBesideARotationDecidesNothing)
{
    const Points logs = drawn_logs(GetParam(), 1);
    const std::vector<Matrix3> rotations = rotations_from_logs(logs);
    const NearLogs found = logs_near(rotations, logs);
    for (Eigen::Index first = 0; first < logs.rows(); first += 7)
    {
        const Points some = logs.middleRows(first, 7);
        const std::vector<Matrix3> again = rotations_from_logs(some);
        const NearLogs alone = logs_near(again, some);
        for (Eigen::Index k = 0; k < 7; ++k)
        {
            EXPECT_EQ(again[static_cast<std::size_t>(k)],
                      rotations[static_cast<std::size_t>(first + k)]);
            EXPECT_EQ(alone.logs.row(k), found.logs.row(first + k));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Radians, RotationBatch, testing::Values(1e-170, 1e-9, 0.3, 1.0, 2.0, 9.0));

}  // namespace
}  // namespace sheetmorph
