// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/reading/step_text.h"

#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::cad
{
namespace
{

TEST(StepText, LeavesAStandardTextAlone)
{
    EXPECT_FALSE(standard_step_text("#1=DIRECTION('a e-1',(1.5E-16,0.,1.));/* 1.e-5\n */\n"));
    EXPECT_FALSE(standard_step_text("#1=A_1e5(.T.,#2,'it''s 1.e-5');\n#2=B('',$,1e);\n"));
}

TEST(StepText, WritesExponentsInCapitalsOutsideOfStringsAndComments)
{
    EXPECT_EQ(standard_step_text("#1=D('1e5',(-1.5e-16, 2.e+3,\n1e5));/*1.e-5*/\n").value(),
              "#1=D('1e5',(-1.5E-16, 2.E+3,\n1E5));/*1.e-5*/\n");
}

TEST(StepText, BeginsWithoutAByteOrderMark)
{
    EXPECT_EQ(standard_step_text("\xEF\xBB\xBFISO-10303-21;").value(), "ISO-10303-21;");
}

TEST(StepText, JoinsStringsThatAreBrokenOverLines)
{
    EXPECT_EQ(standard_step_text("#1=P('\\X2\\004B\r\n00FC\\X0\\','a''\nb',\n'');").value(),
              "#1=P('\\X2\\004B00FC\\X0\\','a''b',\n'');");
}

// Random tokens, as the standard has them and spoilt: always the standard text comes back.
TEST(StepText, FindsTheStandardTextOfAnyOther)
{
    std::mt19937 noise(7);
    const auto pick = [&](int count)
    { return static_cast<int>(noise() % static_cast<unsigned>(count)); };
    for (int round = 0; round < 300; ++round)
    {
        std::string standard, spoilt;
        const auto add = [&](const std::string& one, const std::string& other)
        {
            standard += one;
            spoilt += other;
        };
        for (int token = 0; token < 30; ++token)
            switch (pick(5))
            {
                case 0:
                    add(",-1.25E-16", pick(2) ? ",-1.25e-16" : ",-1.25E-16");
                    break;
                case 1:
                    add(",'x'' 1.e-5;'", pick(2) ? ",'x''\n 1.e-5;'" : ",'x'' 1.e-5;'");
                    break;
                case 2:
                    add("/* it's 1.e5 \n*/", "/* it's 1.e5 \n*/");
                    break;
                case 3:
                    add(",\n#12,$,*,.T.", ",\n#12,$,*,.T.");
                    break;
                default:
                    add("/2", "/2");
            }
        const std::optional<std::string> found = standard_step_text(spoilt);
        EXPECT_EQ(found.value_or(spoilt), standard);
    }
}

}  // namespace
}  // namespace sheetmorph::cad
