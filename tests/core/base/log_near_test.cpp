// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/log_near.h"

#include "sheetmorph/base/angles.h"
#include "sheetmorph/base/rotation.h"

#include <gtest/gtest.h>

namespace sheetmorph
{

// Damping shortens the change near a whole turn. It must not turn it to another side.
TEST(LogNear, FollowsASmallTiltInItsOwnDirection)
{
    const Vector3 reference = 0.82 * pi * Vector3(2.0, -1.0, 2.0) / 3.0;
    const Vector3 tilt = 1e-4 * Vector3(1.0, 2.0, 0.0).normalized();
    const Vector3 found = log_near(rotation_from_log(reference + tilt), reference) - reference;
    EXPECT_GT(found.norm(), 0.3 * tilt.norm());
    EXPECT_LT(found.norm(), tilt.norm());
    EXPECT_GT(found.normalized().dot(tilt.normalized()), 0.999);
}

}  // namespace sheetmorph
