// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/forms/feature_shape.h"

#include "sheetmorph/base/rotation.h"
#include "sheetmorph/fitting/circle.h"
#include "sheetmorph/fitting/rim_profile.h"
#include "shapes.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <numeric>

namespace sheetmorph::forms
{

using namespace fitting;
using namespace mesh;

namespace
{

using testing::SizeIs;

constexpr int around = 24;

// A sheet of rings around the z axis: ring r of `radii` at the height of the same place.
TriangleMesh rings(const std::vector<double>& radii, const std::vector<double>& heights)
{
    const int count = static_cast<int>(radii.size()) - 1;
    return shapes::sheet({around, count, true, false},
                         [&](double u, double v)
                         {
                             const auto ring = static_cast<std::size_t>(std::lround(v * count));
                             const double angle = 2 * shapes::pi * u;
                             return Vector3(radii[ring] * std::cos(angle),
                                            radii[ring] * std::sin(angle), heights[ring]);
                         });
}

VertexIds of_rings(int first, int last)
{
    VertexIds ids(static_cast<std::size_t>(around * (last - first + 1)));
    std::iota(ids.begin(), ids.end(), around * first);
    return ids;
}

// A sheet around a slot of some length and width, `out` mm wide.
TriangleMesh slotted(double length, double width, double out)
{
    const double half = 0.5 * (length - width);
    const auto outline = [=](double u, double radius)
    {
        const double angle = 2 * shapes::pi * u;
        const double end =
            std::abs(std::cos(angle)) < 1e-9 ? 0.0 : std::copysign(half, std::cos(angle));
        return Vector3(end + radius * std::cos(angle), radius * std::sin(angle), 0.0);
    };
    return shapes::sheet({around, 3, true, false},
                         [=](double u, double v) { return outline(u, 0.5 * width + out * v); });
}

TriangleMesh moved(const TriangleMesh& mesh)
{
    const Matrix3 turn = rotation_from_log(Vector3(0.3, -0.5, 0.7));
    Points points = mesh.points() * turn.transpose();
    points.rowwise() += Eigen::RowVector3d(100, -200, 300);
    return TriangleMesh(points, mesh.triangles());
}

TriangleMesh noisy(const TriangleMesh& mesh, double size)
{
    std::srand(5);
    return TriangleMesh(mesh.points() + size * Points::Random(mesh.vertex_count(), 3),
                        mesh.triangles());
}

Points rest_of(const TriangleMesh& mesh, const VertexIds& vertices)
{
    return mesh.points()(vertices, Eigen::indexing::all);
}

// The feature's rim with a new size is a circle of this radius.
void expect_circle(const TriangleMesh& mesh, const VertexIds& vertices, double size, double radius)
{
    const std::optional<FeatureShape> shape = feature_shape(mesh, vertices);
    ASSERT_TRUE(shape);
    const Points all = shape->resized(rest_of(mesh, vertices), size);
    const CircleFit circle = fit_circle(all(shape->rim, Eigen::indexing::all));
    EXPECT_NEAR(circle.radius, radius, 1e-11);
    EXPECT_LT(circle.residual, 1e-11);
}

// The wall of a pipe: its centre is half the way between its rims.
TEST(FeatureShape, AWallHasItsCentreInTheMiddle)
{
    Points points(2 * around, 3);
    Triangles triangles(2 * around, 3);
    for (int k = 0; k < around; ++k)
    {
        const double angle = 2.0 * 3.14159265358979323846 * k / around;
        for (const int end : {0, 1})
            points.row(2 * k + end) << 4.0 * std::cos(angle), 4.0 * std::sin(angle),
                1.0 + 5.0 * end;
        const int next = 2 * ((k + 1) % around);
        triangles.row(2 * k) << 2 * k, next, 2 * k + 1;
        triangles.row(2 * k + 1) << next, next + 1, 2 * k + 1;
    }
    VertexIds all(2 * around);
    for (int k = 0; k < 2 * around; ++k)
        all[static_cast<std::size_t>(k)] = k;
    const auto shape = feature_shape(TriangleMesh(points, triangles), all);
    ASSERT_TRUE(shape);
    EXPECT_LT((shape->centre - Vector3(0.0, 0.0, 3.5)).norm(), 1e-9);
    EXPECT_NEAR(shape->size, shape->kind == FeatureShape::Kind::cylinder ? 4.0 : 8.0, 1e-9);
}

}  // namespace

TEST(FeatureShape, OfARimIsAHoleWithItsDiameterAndAxis)
{
    const TriangleMesh plate = moved(rings({5, 7, 10}, {0, 0, 0}));
    const std::optional<FeatureShape> shape = feature_shape(plate, of_rings(0, 0));
    ASSERT_TRUE(shape);
    EXPECT_EQ(shape->kind, FeatureShape::Kind::hole);
    EXPECT_EQ(shape->measure(), "diameter");
    EXPECT_NEAR(shape->size, 10.0, 1e-11);
    EXPECT_LT((shape->centre - Vector3(100, -200, 300)).norm(), 1e-11);
    EXPECT_THAT(shape->rim, SizeIs(around));
    EXPECT_LT(shape->rounding.cwiseAbs().maxCoeff(), 1e-12);
    expect_circle(plate, of_rings(0, 0), 13.0, 6.5);
}

TEST(FeatureShape, OfARimWithNoiseBecomesAnExactCircle)
{
    const TriangleMesh plate = moved(noisy(rings({5, 7, 10}, {0, 0, 0}), 0.02));
    expect_circle(plate, of_rings(0, 0), 8.0, 4.0);
}

TEST(FeatureShape, OfAWasherKeepsItsWidth)
{
    const TriangleMesh plate = rings({5, 7, 8, 12}, {0, 0, 0, 0});
    const VertexIds washer = of_rings(0, 2);
    const std::optional<FeatureShape> shape = feature_shape(plate, washer);
    ASSERT_TRUE(shape);
    EXPECT_NEAR(shape->size, 10.0, 1e-12);
    EXPECT_THAT(shape->rim, SizeIs(around));
    const Points wide = shape->resized(rest_of(plate, washer), 12.0);
    EXPECT_NEAR(wide.row(0).norm(), 6.0, 1e-12);
    EXPECT_NEAR(wide.row(2 * around).norm(), 9.0, 1e-12);
}

TEST(FeatureShape, OfAClosedRowInsideTheSheetIsAHoleToo)
{
    const TriangleMesh disk = rings({1, 3, 5, 7}, {0, 0, 0, 0});
    expect_circle(disk, of_rings(1, 1), 7.0, 3.5);
    EXPECT_NEAR(feature_shape(disk, of_rings(1, 2))->size, 6.0, 1e-12);  // its inner ring
}

TEST(FeatureShape, OfAFilledCircleGrowsAllOver)
{
    std::vector<TriangleMesh> pieces = {rings({1, 3, 6}, {0, 0, 0})};
    Triangles fan(around, 3);
    Points points(around + 1, 3);
    points << pieces[0].points().topRows(around), Eigen::RowVector3d::Zero();
    for (int i = 0; i < around; ++i)
        fan.row(i) << around, i, (i + 1) % around;
    pieces.emplace_back(points, fan);
    const TriangleMesh plate = shapes::welded(pieces);
    const VertexIds pad =
        shapes::vertices_where(plate, [](const Vector3& p) { return p.norm() < 4; });
    const std::optional<FeatureShape> shape = feature_shape(plate, pad);
    ASSERT_TRUE(shape);
    EXPECT_NEAR(shape->size, 6.0, 1e-12);
    const Points rest = rest_of(plate, pad);
    EXPECT_LT((shape->resized(rest, 9.0) - 1.5 * rest).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(FeatureShape, OfAHoleThroughAThinSolidIsBothRimsAndTheWall)
{
    const TriangleMesh solid = moved(rings({12, 8, 5, 5, 5, 8, 12}, {0, 0, 0, -1, -2, -2, -2}));
    for (const VertexIds& ids : {of_rings(2, 4), of_rings(1, 5)})
    {
        const std::optional<FeatureShape> shape = feature_shape(solid, ids);
        ASSERT_TRUE(shape);
        EXPECT_EQ(shape->kind, FeatureShape::Kind::hole);
        EXPECT_NEAR(shape->size, 10.0, 1e-11);
        EXPECT_THAT(shape->rim, SizeIs(3 * around));
        EXPECT_NEAR(shape->growth.rowwise().norm().minCoeff(), 0.5, 1e-12);
        EXPECT_NEAR(shape->growth.rowwise().norm().maxCoeff(), 0.5, 1e-12);
    }
}

TEST(FeatureShape, OutlinesThatDoNotSettleAreNone)
{
    const Points round = shapes::annulus(24, 2, 5, 8).points().topRows(24);
    RimProfile circle;
    circle.radius = 4.0;
    ASSERT_TRUE(refit(circle, round));
    EXPECT_NEAR(refit(circle, round)->radius, 5.0, 1e-12);
    // Scattered about a line: circles on both sides of it are as good.
    Points scattered(7, 3);
    scattered << -1.0, -0.7, 0, -2.0 / 3.0, -0.8, 0, -1.0 / 3.0, 0.3, 0, 0, -0.2, 0, 1.0 / 3.0, 0.1,
        0, 2.0 / 3.0, 0.8, 0, 1.0, 0.9, 0;
    EXPECT_FALSE(refit(circle, scattered));
    EXPECT_FALSE(fit_rim(scattered));
}

TEST(FeatureShape, OfAPipeOnASheetIsACylinder)
{
    const TriangleMesh pipe = moved(rings({9, 6, 4, 4, 4}, {0, 0, 0, 8, 12}));
    const std::optional<FeatureShape> shape = feature_shape(pipe, of_rings(2, 4));
    ASSERT_TRUE(shape);
    EXPECT_EQ(shape->kind, FeatureShape::Kind::cylinder);
    EXPECT_EQ(shape->measure(), "radius");
    EXPECT_NEAR(shape->size, 4.0, 1e-11);
    EXPECT_NEAR(shape->growth.rowwise().norm().maxCoeff(), 1.0, 1e-12);
}

TEST(FeatureShape, OfAHalfPipeIsACylinder)
{
    const TriangleMesh bend = moved(shapes::sheet(
        {12, 5}, [](double u, double v)
        { return Vector3(3 * std::cos(shapes::pi * u), 3 * std::sin(shapes::pi * u), 20 * v); }));
    VertexIds all(static_cast<std::size_t>(bend.vertex_count()));
    std::iota(all.begin(), all.end(), 0);
    const std::optional<FeatureShape> shape = feature_shape(bend, all);
    ASSERT_TRUE(shape);
    EXPECT_EQ(shape->kind, FeatureShape::Kind::cylinder);
    EXPECT_NEAR(shape->size, 3.0, 1e-11);
    EXPECT_LT(shape->rounding.cwiseAbs().maxCoeff(), 1e-11);
}

TEST(FeatureShape, OfASlotKeepsItsWidthAndChangesItsLength)
{
    const TriangleMesh sheet = moved(slotted(30, 8, 6));
    const VertexIds rim = of_rings(0, 0);
    const std::optional<FeatureShape> shape = feature_shape(sheet, rim);
    ASSERT_TRUE(shape);
    EXPECT_EQ(shape->kind, FeatureShape::Kind::slot);
    EXPECT_EQ(shape->measure(), "length");
    EXPECT_NEAR(shape->size, 30.0, 1e-10);
    EXPECT_NEAR(shape->smallest, 8.0, 1e-10);
    const TriangleMesh longer(shape->resized(rest_of(sheet, rim), 36.0), Triangles(0, 3));
    const TriangleMesh wanted = moved(slotted(36, 8, 6));
    EXPECT_LT((longer.points() - wanted.points().topRows(around)).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(FeatureShape, OfOtherVerticesIsNone)
{
    const TriangleMesh plate = rings({5, 7, 10}, {0, 0, 0});
    EXPECT_FALSE(feature_shape(plate, {0, 1, 2, 3, 4, 5, 6}));  // part of a rim
    const TriangleMesh grid =
        shapes::sheet({6, 6}, [](double u, double v) { return Vector3(u, v, 0); });
    VertexIds all(static_cast<std::size_t>(grid.vertex_count()));
    std::iota(all.begin(), all.end(), 0);
    EXPECT_FALSE(feature_shape(grid, all));
    EXPECT_FALSE(feature_shape(grid, {3}));
    const TriangleMesh cone = rings({5, 8, 11}, {0, 3, 6});
    EXPECT_FALSE(feature_shape(cone, of_rings(1, 2)));
}

}  // namespace sheetmorph::forms
