// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/cad_guard.h"

#include <Standard_OutOfRange.hxx>
#include <functional>
#include <gtest/gtest.h>

namespace sheetmorph::cad
{

namespace
{

std::string told_of(const std::function<void()>& work)
{
    try
    {
        guarded("it cannot be read", "repair it", work);
    }
    catch (const InvalidInput& error)
    {
        return error.what();
    }
    return {};
}

}  // namespace

TEST(CadGuard, TellsWhatOpenCascadeThrows)
{
    EXPECT_EQ(told_of([] { throw Standard_OutOfRange("index"); }),
              "it cannot be read (index); repair it");
}

}  // namespace sheetmorph::cad
