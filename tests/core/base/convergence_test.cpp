// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/convergence.h"

#include <gtest/gtest.h>

namespace sheetmorph
{
namespace
{

TEST(Convergence, SaysWhatDidNotSettleAndHowFarItGot)
{
    EXPECT_EQ(Convergence{}.sentence(), "");
    const Convergence ended{"the rotations of form features", false, 100, 0.0234, "radians"};
    EXPECT_EQ(
        ended.sentence(),
        "the rotations of form features did not converge in 100 iterations (the last one still "
        "changed 0.023 radians)");
}

TEST(Convergence, OfTwoTheOneThatDidNotSettleIsTold)
{
    const Convergence settled{"a", true, 7, 0.0};
    const Convergence ended{"b", false, 3, 1.0};
    for (const auto& [first, second] : {std::pair(settled, ended), std::pair(ended, settled)})
    {
        Convergence both = first;
        both.join(second);
        EXPECT_STREQ(both.what, "b");
        EXPECT_FALSE(both.is_converged);
    }
    Convergence longer{"c", true, 2, 0.0};
    longer.join(settled);
    EXPECT_EQ(longer.rounds, 7);
}

}  // namespace
}  // namespace sheetmorph
