// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/text.h"

#include <gtest/gtest.h>

namespace sheetmorph
{
namespace
{

TEST(Text, ListsOnlyTheFirstIdsOfMany)
{
    EXPECT_EQ(list_ids({1, 2, 3, 4, 5}, 3), "1, 2, 3 and 2 more");
}

TEST(Text, CountsItsVerticesWhereThereIsNoRoomForNumbers)
{
    const Text text =
        "it moves " + Text::counted({3, 7}) + ", not " + Text::listed("vertices ", {5});
    EXPECT_EQ(text.full(), "it moves 2 vertices (3, 7), not vertices 5");
    EXPECT_EQ(text.full({9, 9, 9, 30, 9, 50, 9, 70}),
              "it moves 2 vertices (30, 70), not vertices 50");
    EXPECT_EQ(text.brief(), "it moves 2 vertices, not 1 vertex");
    EXPECT_EQ(text.vertices(), (std::vector<int>{3, 7, 5}));
}

TEST(Text, KnowsEachSubjectOnceInItsOrder)
{
    Text text = Text::about("handle", "'x'") + " and " + Text::about("part", "x");
    text += text;
    EXPECT_EQ(text.subjects(), (std::vector<Subject>{{"handle", "'x'"}, {"part", "x"}}));
}

TEST(Text, KeepsNumbersThatAreNoVerticesAsTheyAre)
{
    const Text text = Text::shortened("triangles 3, 4", "2 triangles");
    EXPECT_EQ(text.full({7, 7, 7, 7, 7}), "triangles 3, 4");
    EXPECT_EQ(text.brief(), "2 triangles");
    EXPECT_TRUE(text.vertices().empty());
}

}  // namespace
}  // namespace sheetmorph
