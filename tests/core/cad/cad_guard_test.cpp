// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/cad_guard.h"

#include <Standard_OutOfRange.hxx>
#include <csignal>
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

// Nobody knows whose fault it is.
TEST(CadGuard, BlamesNobodyForMemoryThatIsReachedForInVain)
{
    const std::string told = told_of([] { std::raise(SIGSEGV); });
    EXPECT_NE(told.find(": a fault of OpenCASCADE or of SheetMorph); repair it"), std::string::npos)
        << told;
}

}  // namespace sheetmorph::cad
