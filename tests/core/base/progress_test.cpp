// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/progress.h"

#include "sheetmorph/base/errors.h"

#include <gtest/gtest.h>

namespace sheetmorph
{
namespace
{

TEST(Progress, AStretchOfAStretchReportsItsPlaceInTheWhole)
{
    double seen = -1.0;
    const Progress whole(
        [&](double fraction, const std::string&)
        {
            seen = fraction;
            return true;
        });
    whole.part(0.5, 1.0).part(0.0, 0.5).report(1.0, "half of the second half");
    EXPECT_DOUBLE_EQ(seen, 0.75);
}

TEST(Progress, AnAnswerOfFalseCancelsAndNobodyListeningNever)
{
    const Progress stop([](double, const std::string&) { return false; });
    EXPECT_THROW(stop.report(0.1, "anything"), Cancelled);
    EXPECT_NO_THROW(Progress().report(0.1, "anything"));
}

}  // namespace
}  // namespace sheetmorph
