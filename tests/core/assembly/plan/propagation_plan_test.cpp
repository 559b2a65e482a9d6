// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/plan/propagation_plan.h"

#include "assembly/all_frames.h"

#include <gmock/gmock.h>

namespace sheetmorph::assembly
{
namespace
{

using testing::ElementsAre;

TEST(PropagationPlan, RunsBreadthFirstAndUsesContactsThatCloseARing)
{
    const PropagationPlan plan = plan_propagation(frames::ring(ContactType::control_mesh).assembly);
    EXPECT_THAT(plan.order, ElementsAre(0, 3, 1, 2));  // fourth before second, by name
    EXPECT_THAT(plan.level, ElementsAre(0, 1, 2, 1));
    EXPECT_EQ(plan.contacts.size(), 4U);
    EXPECT_EQ(plan.into(frames::ring(ContactType::tied).assembly, 2).size(), 2U);
    EXPECT_TRUE(plan.unreached.empty());
}

TEST(PropagationPlan, AContactGivenBackwardsStillLeadsAwayFromThePrimary)
{
    Assembly assembly = frames::ring(ContactType::control_mesh).assembly;
    std::swap(assembly.contacts[0].a, assembly.contacts[0].b);
    const PropagationPlan plan = plan_propagation(assembly);
    EXPECT_TRUE(plan.contacts[0].is_reversed);
    EXPECT_EQ(plan.contacts[0].source(assembly).part, 0);
}

TEST(PropagationPlan, ListsPartsThatNothingReachesAndStartsAnewAtPartsWithTheirOwnHandle)
{
    Assembly assembly = frames::ring(ContactType::control_mesh).assembly;
    assembly.contacts = {assembly.contacts[1]};  // second - third alone
    PropagationPlan plan = plan_propagation(assembly);
    EXPECT_THAT(plan.unreached, ElementsAre(1, 2, 3));
    assembly.handles.push_back({"other", 1, {0}});
    plan = plan_propagation(assembly);
    EXPECT_THAT(plan.order, ElementsAre(0, 1, 2));
    EXPECT_THAT(plan.unreached, ElementsAre(3));
}

}  // namespace
}  // namespace sheetmorph::assembly
