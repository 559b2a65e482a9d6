// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/topology/polygons.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/geometry/operators.h"
#include "shapes.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <set>

namespace sheetmorph::mesh
{

namespace
{

Points corners_of(std::initializer_list<Eigen::RowVector3d> rows)
{
    Points points(rows.size(), 3);
    int i = 0;
    for (const Eigen::RowVector3d& row : rows)
        points.row(i++) = row;
    return points;
}

std::set<int> diagonal(const Triangles& split)
{
    return {split(0, 0), split(0, 2)};
}

Quads one_quad(int a, int b, int c, int d)
{
    Quads quad(1, 4);
    quad << a, b, c, d;
    return quad;
}

Eigen::MatrixXd stiffness(const Points& points, const Triangles& triangles)
{
    const TriangleMesh mesh(points, triangles);
    return cotangent_stiffness(mesh, half_cotangents(mesh));
}

double area_along_z(const Points& points, const Triangles& triangles)
{
    double area = 0.0;
    for (int t = 0; t < triangles.rows(); ++t)
    {
        const Vector3 a = points.row(triangles(t, 1)) - points.row(triangles(t, 0));
        const Vector3 b = points.row(triangles(t, 2)) - points.row(triangles(t, 0));
        EXPECT_GE(a.cross(b).z(), 0.0);
        area += 0.5 * a.cross(b).z();
    }
    return area;
}

}  // namespace

TEST(Polygons, AKiteIsSplitByItsDelaunayDiagonalWhereverItStarts)
{
    const Points kite = corners_of({{-3, 0, 0}, {0, -1, 0}, {3, 0, 0}, {0, 1, 0}});
    for (int first = 0; first < 4; ++first)
    {
        const Quads quad = one_quad(first, (first + 1) % 4, (first + 2) % 4, (first + 3) % 4);
        EXPECT_EQ(diagonal(split_quads(kite, quad)), (std::set<int>{1, 3}));
    }
}

TEST(Polygons, TheDiagonalAtAReentrantCornerIsTaken)
{
    const Points arrow = corners_of({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}});
    EXPECT_EQ(diagonal(split_quads(arrow, one_quad(0, 1, 2, 3))), (std::set<int>{0, 2}));
    EXPECT_EQ(diagonal(split_quads(arrow, one_quad(1, 2, 3, 0))), (std::set<int>{0, 2}));
}

TEST(Polygons, TheStiffnessOfARectangleOrTrapezoidIsTheSameForBothDiagonals)
{
    for (const double top : {4.0, 2.5})
    {
        const Points points =
            corners_of({{-2, 0, 1}, {2, 0, 1}, {top / 2, 3, 1}, {-top / 2, 3, 1}});
        const auto one = stiffness(points, split_quads(points, one_quad(0, 1, 2, 3)));
        const auto other = stiffness(points, split_quads(points, one_quad(1, 2, 3, 0)));
        EXPECT_LT((one - other).cwiseAbs().maxCoeff(), 1e-14);
    }
}

TEST(Polygons, MirroredQuadsGiveTheMirroredStiffness)
{
    std::srand(11);
    for (int round = 0; round < 20; ++round)
    {
        Points points = corners_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
        points += 0.3 * Points::Random(4, 3);
        const Points mirror = points * Eigen::Vector3d(-1, 1, 1).asDiagonal();
        const auto one = stiffness(points, split_quads(points, one_quad(0, 1, 2, 3)));
        const auto other = stiffness(mirror, split_quads(mirror, one_quad(3, 2, 1, 0)));
        EXPECT_LT((one - other).cwiseAbs().maxCoeff(), 1e-12);
    }
}

TEST(Polygons, AQuadThatRepeatsACornerGivesItsTriangle)
{
    const Points points = corners_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    EXPECT_NEAR(area_along_z(points, split_quads(points, one_quad(0, 1, 2, 2))), 0.5, 1e-15);
    EXPECT_NEAR(area_along_z(points, split_quads(points, one_quad(0, 0, 1, 2))), 0.5, 1e-15);
}

TEST(Polygons, ManyCornersKeepAreaAndOrientation)
{
    const Points comb = corners_of({{0, 0, 0},
                                    {5, 0, 0},
                                    {5, 3, 0},
                                    {4, 3, 0},
                                    {4, 1, 0},
                                    {3, 1, 0},
                                    {3, 3, 0},
                                    {2, 3, 0},
                                    {2, 1, 0},
                                    {1, 1, 0},
                                    {1, 3, 0},
                                    {0, 3, 0}});
    const Triangles split = split_polygon(comb, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
    EXPECT_EQ(split.rows(), 10);
    EXPECT_NEAR(area_along_z(comb, split), 11.0, 1e-12);
    EXPECT_EQ(split_polygon(comb, {0, 1, 2}), Triangles(Eigen::RowVector3i(0, 1, 2)));
    EXPECT_EQ(split_polygon(comb, {0, 1, 2, 11}).rows(), 2);
    EXPECT_NEAR(area_along_z(comb, split_polygon(comb, {0, 1, 2, 10, 11})), 15.0, 1e-12);
}

TEST(Polygons, CornersThatDoNotExistAreRefused)
{
    const Points points = corners_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    EXPECT_THROW(split_quads(points, one_quad(0, 1, 2, 3)), InvalidInput);
    EXPECT_THROW(split_polygon(points, {0, 1}), InvalidInput);
    EXPECT_THROW(split_polygon(points, {0, 1, -2}), InvalidInput);
}

}  // namespace sheetmorph::mesh
