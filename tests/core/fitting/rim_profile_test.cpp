// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/fitting/rim_profile.h"

#include "sheetmorph/base/rotation.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>

namespace sheetmorph::fitting
{
namespace
{

constexpr double pi = 3.14159265358979323846;

// Points around a slot, its right end first, unevenly spaced.
Points slot(double half_segment, double radius, int points_an_end)
{
    Points rim(2 * points_an_end, 3);
    for (int end = 0; end < 2; ++end)
        for (int k = 0; k < points_an_end; ++k)
        {
            const double share = (k + 0.3 * std::sin(1.7 * k)) / (points_an_end - 1);
            const double angle = pi * (end + std::min(1.0, std::max(0.0, share))) - 0.5 * pi;
            rim.row(end * points_an_end + k)
                << (end == 0 ? 1.0 : -1.0) * half_segment + radius * std::cos(angle),
                radius * std::sin(angle), 0.0;
        }
    return rim;
}

struct Place
{
    Matrix3 turn = rotation_from_log(2.0 * Vector3::Random());
    Vector3 shift = 50.0 * Vector3::Random();

    Points moved(const Points& points) const
    {
        return (points * turn.transpose()).rowwise() + shift.transpose();
    }
};

TEST(RimProfile, ASlotIsFoundExactlyWhereverItLies)
{
    std::srand(11);
    for (int round = 0; round < 30; ++round)
    {
        const Place place;
        const double radius = 1.0 + round % 4, half = radius * (0.4 + 0.3 * (round % 7));
        const auto found = fit_rim(place.moved(slot(half, radius, 5 + round % 6)));
        ASSERT_TRUE(found) << round;
        EXPECT_NEAR(found->half_segment, half, 1e-8 * half) << round;
        EXPECT_NEAR(found->radius, radius, 1e-8 * radius);
        EXPECT_LT((found->centre - place.shift).norm(), 1e-8 * (half + radius));
        EXPECT_NEAR(std::abs(found->frame.col(0).dot(place.turn.col(0))), 1.0, 1e-12);
        EXPECT_LT((found->frame.transpose() * found->frame - Matrix3::Identity()).norm(), 1e-12);
        EXPECT_NEAR(found->frame.determinant(), 1.0, 1e-12);
    }
}

// An oval whose half axes differ by a tenth is neither round nor a slot.
TEST(RimProfile, AnOvalIsNotFound)
{
    for (const double longer : {1.1, 1.25})
    {
        Points oval(40, 3);
        for (int k = 0; k < 40; ++k)
            oval.row(k) << 10.0 * longer * std::cos(0.05 * pi * k), 10.0 * std::sin(0.05 * pi * k),
                0.0;
        const auto found = fit_rim(oval);
        EXPECT_TRUE(!found || !found->is_circle()) << longer;
    }
}

// A square with rounded corners, whose radius differs by a tenth from corner to side.
TEST(RimProfile, ARoundedSquareIsNotACircle)
{
    Points rim(48, 3);
    for (int k = 0; k < 48; ++k)
    {
        const double angle = pi * k / 24.0, radius = 10.0 + 0.7 * std::cos(4.0 * angle);
        rim.row(k) << radius * std::cos(angle), radius * std::sin(angle), 0.0;
    }
    EXPECT_FALSE(fit_rim(rim));
}

}  // namespace
}  // namespace sheetmorph::fitting
