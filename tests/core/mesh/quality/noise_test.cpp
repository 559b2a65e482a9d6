// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/quality/noise.h"

#include "shapes/plates.h"
#include "shapes/solids.h"
#include "shapes/variations.h"

#include <gtest/gtest.h>

namespace sheetmorph::mesh
{

namespace
{

TEST(Noise, DrawnMeshesHaveNoScatterHoweverTheyBend)
{
    EXPECT_EQ(scatter_of(shapes::grid(20, 20, 100.0, 100.0)), 0.0);
    EXPECT_EQ(scatter_of(shapes::cylinder(24, 12, 10.0, 50.0)), 0.0);
    EXPECT_EQ(scatter_of(shapes::sphere(4, 30.0)), 0.0);
    EXPECT_EQ(scatter_of(shapes::box(4, Vector3(10.0, 20.0, 30.0))), 0.0);
    EXPECT_EQ(scatter_of(shapes::plate_with_holes().mesh), 0.0);
    EXPECT_EQ(scatter_of(TriangleMesh()), 0.0);
}

TEST(Noise, ScatterOfMeasuredMeshesIsToldToAHalf)
{
    const TriangleMesh meshes[] = {shapes::grid(30, 30, 150.0, 150.0),
                                   shapes::cylinder(48, 24, 40.0, 120.0), shapes::sphere(4, 60.0),
                                   shapes::box(12, Vector3(60.0, 60.0, 60.0))};
    for (const double deviation : {0.1, 0.3})
        for (const TriangleMesh& mesh : meshes)
            for (unsigned seed = 0; seed < 3; ++seed)
            {
                const double told = scatter_of(shapes::scattered(mesh, deviation, seed));
                EXPECT_GT(told, 0.5 * deviation) << mesh.vertex_count();
                EXPECT_LT(told, 1.5 * deviation) << mesh.vertex_count();
            }
}

}  // namespace

}  // namespace sheetmorph::mesh
