// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/healing/healing.h"
#include "sheetmorph/cad/healing/shape_faults.h"
#include "sheetmorph/cad/reading/cad_reader.h"
#include "cad/cad_files.h"

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

namespace sheetmorph::cad::test
{

namespace
{

// The plate as BREP text, its vertex at the origin so far away from its edges, mm.
std::string plate_with_a_vertex_off(double off)
{
    const TemporaryFolder folder;
    write_plate_brep(folder.file("plate.brep"));
    std::ostringstream text;
    text << std::ifstream(folder.file("plate.brep")).rdbuf();
    const std::string where = "Ve\n1e-07\n0 0 0\n";
    std::string found = text.str();
    const std::size_t at = found.find(where);
    EXPECT_NE(at, std::string::npos);
    return found.replace(at, where.size(), "Ve\n1e-07\n0 0 -" + std::to_string(off) + "\n");
}

}  // namespace

TEST(Healing, AValidShapeHasNoFaultsAndStaysAsItIs)
{
    const TemporaryFolder folder;
    write_plate_brep(folder.file("plate.brep"));
    const CadModel model = read_cad(folder.file("plate.brep"), {}, Progress());
    EXPECT_TRUE(model.parts.front().faults.empty());
    EXPECT_TRUE(model.parts.front().healed.empty());
}

TEST(Healing, WhatIsOffByLittleIsHealedAndTold)
{
    const CadModel model = read_brep(plate_with_a_vertex_off(0.004), "plate", {});
    const CadPart& part = model.parts.front();
    EXPECT_TRUE(part.faults.empty());
    ASSERT_FALSE(part.healed.empty());
    EXPECT_THAT(part.healed.front(), testing::MatchesRegex("face [0-9]+: .*a vertex is off.*"));
    EXPECT_NEAR(part.healed_within, 0.004, 0.001);
    EXPECT_EQ(part.surfaces.size(), 8U);
    EXPECT_TRUE(part.is_closed);
}

TEST(Healing, WhatIsOffByMuchIsToldAndStays)
{
    const CadModel model = read_brep(plate_with_a_vertex_off(0.5), "plate", {});
    const CadPart& part = model.parts.front();
    EXPECT_TRUE(part.healed.empty());
    ASSERT_FALSE(part.faults.empty());
    EXPECT_THAT(part.faults.front(), testing::MatchesRegex("face [0-9]+: .*a vertex is off.*"));
}

}  // namespace sheetmorph::cad::test
