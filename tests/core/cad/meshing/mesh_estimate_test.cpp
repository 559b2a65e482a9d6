// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/meshing/mesh_estimate.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/cad/reading/cad_reader.h"
#include "cad/cad_files.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

namespace sheetmorph::cad::test
{

namespace
{

int made(const TopoDS_Shape& shape, const CadMeshing& meshing)
{
    std::ostringstream text;
    BRepTools::Write(shape, text);
    return read_brep(text.str(), "part", meshing).parts[0].mesh.triangle_count();
}

}  // namespace

TEST(MeshEstimate, is_near_the_triangles_that_are_made)
{
    const TemporaryFolder silent;
    const std::vector<TopoDS_Shape> shapes{
        BRepPrimAPI_MakeBox(60.0, 40.0, 2.0).Shape(), BRepPrimAPI_MakeCylinder(3.0, 20.0).Shape(),
        BRepPrimAPI_MakeSphere(10.0).Shape(), BRepPrimAPI_MakeTorus(20.0, 3.0).Shape()};
    for (std::size_t s = 0; s < shapes.size(); ++s)
        for (const CadMeshing& meshing : {CadMeshing{1.0, 0.1, 0.35}, CadMeshing{2.0, 0.002, 0.35},
                                          CadMeshing{4.0, 1.0, 0.1}, CadMeshing{0.5, 1.0, 1.0}})
        {
            const double ratio =
                MeshEstimate(shapes[s]).triangles(meshing) / made(shapes[s], meshing);
            EXPECT_GT(ratio, 0.3) << s << ", edge " << meshing.edge;
            EXPECT_LT(ratio, 3.0) << s << ", edge " << meshing.edge;
        }
}

TEST(MeshEstimate, names_what_asks_for_too_many)
{
    const MeshEstimate ball(BRepPrimAPI_MakeSphere(10.0).Shape());
    const auto said = [&](const CadMeshing& meshing) -> std::string
    {
        try
        {
            ball.check(meshing);
            return "";
        }
        catch (const InvalidInput& error)
        {
            return error.what();
        }
    };
    EXPECT_EQ(said({1.0, 0.1, 0.35}), "");
    EXPECT_THAT(said({1e-3, 0.1, 0.35}), testing::HasSubstr("edges of 0.001 mm would need"));
    EXPECT_THAT(said({1.0, 1e-7, 0.35}), testing::HasSubstr("a deflection of 1e-07 mm would"));
    EXPECT_THAT(said({1.0, 1.0, 1e-4}), testing::HasSubstr("an angle of"));
}

}  // namespace sheetmorph::cad::test
