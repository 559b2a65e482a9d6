// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/geometry/normals.h"

#include "shapes.h"

#include <gtest/gtest.h>

namespace sheetmorph::mesh
{

TEST(Normals, OfAFlatPlateAreItsNormal)
{
    const TriangleMesh mesh = shapes::plate_with_holes().mesh;
    const Points normals = vertex_normals(mesh.points(), mesh.triangles());
    EXPECT_LT((normals.rowwise() - Eigen::RowVector3d(0, 0, 1)).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(Normals, OfASpherePointOutwards)
{
    const TriangleMesh ball = shapes::sphere(4, 7.0);
    const Points normals = vertex_normals(ball.points(), ball.triangles());
    EXPECT_LT((normals - ball.points() / 7.0).rowwise().norm().maxCoeff(), 0.03);
}

TEST(Normals, LargeTrianglesCountMore)
{
    Points points(5, 3);
    points << 0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0.1, 0, 0, 0, 0.1;
    Triangles triangles(2, 3);
    triangles << 0, 1, 2, 0, 3, 4;
    EXPECT_GT(vertex_normals(points, triangles)(0, 2), 0.999);
}

TEST(Normals, AreOfLengthOneEvenWhereNothingTellsThem)
{
    Points points(6, 3);
    points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 5, 5, 6, 6, 6, 7, 7, 7;
    Triangles triangles(4, 3);
    triangles << 0, 1, 2, 0, 2, 1, 3, 4, 5, 3, 3, 3;
    const Points normals = vertex_normals(points, triangles);
    EXPECT_LT((normals.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-15);
    EXPECT_EQ(normals(1, 2), 1.0);
    EXPECT_EQ(normals(4, 2), 1.0);
}

TEST(Normals, OfTinyTrianglesAreNotLost)
{
    const TriangleMesh mesh = shapes::grid(2, 2, 1e-9, 1e-9);
    const Points normals = vertex_normals(mesh.points(), mesh.triangles());
    EXPECT_EQ(normals.col(2).minCoeff(), 1.0);
}

}  // namespace sheetmorph::mesh
