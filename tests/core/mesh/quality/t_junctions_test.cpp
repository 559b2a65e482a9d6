// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/quality/t_junctions.h"

#include "shapes.h"

#include <gtest/gtest.h>

namespace sheetmorph::mesh
{
namespace
{

// Two grids side by side along x = 4, of 2 and of 3 cells along y.
TriangleMesh misfit()
{
    const TriangleMesh left = shapes::grid(4, 2, 4.0, 6.0);
    const TriangleMesh right = shapes::mapped(
        shapes::grid(4, 3, 4.0, 6.0), [](Vector3 p) { return Vector3(p.x() + 4.0, p.y(), 0.0); });
    return shapes::welded({left, right});
}

TEST(TJunctions, AreVerticesInsideOpenEdges)
{
    const TriangleMesh mesh = misfit();
    const std::vector<TJunction> found = t_junctions(mesh, 1e-6);
    ASSERT_EQ(found.size(), 3U);  // y = 3 inside (2, 4), y = 2 inside (0, 3), y = 4 inside (3, 6)
    for (const TJunction& junction : found)
    {
        const Vector3 vertex = mesh.points().row(junction.vertex);
        EXPECT_DOUBLE_EQ(vertex.x(), 4.0);
        const double low = mesh.points()(junction.from, 1), high = mesh.points()(junction.to, 1);
        EXPECT_LT((vertex.y() - low) * (vertex.y() - high), 0.0);
    }
}

TEST(TJunctions, AreNoneWhereTheMeshFits)
{
    EXPECT_TRUE(t_junctions(shapes::plate_with_holes().mesh, 1e-6).empty());
    EXPECT_TRUE(t_junctions(shapes::box(3, Vector3(1, 2, 3)), 1e-6).empty());
    EXPECT_TRUE(t_junctions(TriangleMesh(), 1e-6).empty());
}

}  // namespace
}  // namespace sheetmorph::mesh
