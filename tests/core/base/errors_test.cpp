// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/errors.h"

#include <gtest/gtest.h>

namespace sheetmorph
{
namespace
{

TEST(InvalidInput, NamesThePartAndItsOwnVertexNumbers)
{
    const InvalidInput fault(Text::listed("vertices ", {0, 2}) + " are wrong", "pick others");
    EXPECT_STREQ(fault.what(), "vertices 0, 2 are wrong; pick others");
    EXPECT_STREQ(fault.in_part("rail", {100, 101, 102}).what(),
                 "part 'rail': vertices 100, 102 are wrong; pick others");
}

TEST(InvalidInput, KeepsItsSubjectsCodeAndRemedyInAPart)
{
    const InvalidInput fault(Text::about("handle", "a; 'b'") + " is wrong", "move it",
                             FaultCode::overlap);
    const Fault found = fault.in_part("p", {}).fault();
    EXPECT_EQ(found.what.subjects(), (std::vector<Subject>{{"handle", "a; 'b'"}}));
    EXPECT_EQ(found.on, (std::vector<Subject>{{"part", "p"}}));
    EXPECT_EQ(found.todo, "move it");
    EXPECT_EQ(found.code, FaultCode::overlap);
}

}  // namespace
}  // namespace sheetmorph
