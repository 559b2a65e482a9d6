// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/search/picking.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/search/triangle_queries.h"
#include "shapes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <atomic>

namespace sheetmorph::mesh
{

namespace
{

TriangleCorners corners_of(const TriangleMesh& mesh, int t)
{
    TriangleCorners corners;
    for (int k = 0; k < 3; ++k)
        corners[k] = mesh.points().row(mesh.triangles()(t, k)).transpose();
    return corners;
}

// Numbers in [-1, 1], the same everywhere.
class Random
{
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double number() { return 2.0 * (engine_() / 4294967296.0) - 1.0; }
    Vector3 vector() { return {number(), number(), number()}; }

private:
    std::mt19937 engine_;
};

TriangleMesh turned(const TriangleMesh& mesh)
{
    RigidMotion motion;
    motion.translation = Vector3(3000.1, -800.7, 1234.5);
    motion.rotation_log = Vector3(0.3, 0.2, -0.4);
    return shapes::moved(mesh, motion);
}

}  // namespace

TEST(Picking, FindsWhatEveryTriangleTestedInTurnFinds)
{
    const TriangleMesh mesh = shapes::torus(40, 20, 10, 4);
    const PickingTree tree(mesh);
    Random random(1);
    int hits = 0;
    for (int round = 0; round < 500; ++round)
    {
        const Vector3 origin = 20.0 * random.vector();
        const Vector3 direction = (10.0 * random.vector() - origin).normalized();
        const TriangleRay ray(origin, direction, 20.0);
        Hit expected;
        expected.distance = 1e9;
        for (int t = 0; t < mesh.triangle_count(); ++t)
            if (Hit hit; ray.meets(corners_of(mesh, t), hit) && hit.distance < expected.distance)
            {
                expected = hit;
                expected.triangle = t;
            }
        const auto found = tree.nearest_hit(origin, direction);
        ASSERT_EQ(found.has_value(), expected.distance < 1e9);
        hits += found.has_value();
        if (found)
        {
            EXPECT_EQ(found->triangle, expected.triangle);
            EXPECT_NEAR(found->distance, expected.distance, 1e-12 * expected.distance);
        }
    }
    EXPECT_GT(hits, 100);
}

TEST(Picking, AHitIsOnTheRayAndOnTheTriangle)
{
    const TriangleMesh mesh = turned(shapes::box(5, {3, 4, 5}));
    const Vector3 centre = mesh.points().colwise().mean();
    const PickingTree tree(mesh);
    Random random(2);
    for (int round = 0; round < 100; ++round)
    {
        const Vector3 direction = random.vector();
        const auto hit = tree.nearest_hit(centre, direction);
        ASSERT_TRUE(hit.has_value());
        EXPECT_LT((centre + hit->distance * direction.normalized() - hit->point).norm(), 1e-11);
        const TriangleCorners corners = corners_of(mesh, hit->triangle);
        Vector3 place = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
            place += hit->barycentric(k) * corners[k];
        EXPECT_LT((place - hit->point).norm(), 1e-11);
        EXPECT_GE(hit->barycentric.minCoeff(), 0.0);
        EXPECT_NEAR(hit->barycentric.sum(), 1.0, 1e-14);
    }
}

TEST(Picking, RaysThroughVerticesAndEdgesNeverSlipThrough)
{
    for (const TriangleMesh& mesh :
         {turned(shapes::sphere(3, 10)), turned(shapes::box(7, {11, 5, 3}))})
    {
        const PickingTree tree(mesh);
        const Vector3 centre = mesh.points().colwise().mean();
        Random random(3);
        for (int t = 0; t < mesh.triangle_count(); ++t)
        {
            const TriangleCorners corners = corners_of(mesh, t);
            const Vector3 origin = centre + random.vector();
            EXPECT_TRUE(tree.nearest_hit(origin, corners[0] - origin).has_value());
            for (const double along : {0.5, 0.1234567})
            {
                const Vector3 place = corners[0] + along * (corners[1] - corners[0]);
                EXPECT_TRUE(tree.nearest_hit(origin, place - origin).has_value());
            }
        }
    }
}

TEST(Picking, RaysAlongTheAxesOntoTheVerticesOfAGridMeet)
{
    const TriangleMesh grid = shapes::grid(9, 7, 0.9, 0.7);
    const PickingTree tree(grid);
    for (int i = 0; i < grid.vertex_count(); ++i)
    {
        const Vector3 above = grid.points().row(i).transpose() + Vector3(0, 0, 5);
        const auto hit = tree.nearest_hit(above, {0, 0, -3});
        ASSERT_TRUE(hit.has_value());
        EXPECT_DOUBLE_EQ(hit->distance, 5.0);
    }
}

TEST(Picking, IsTwoSidedAndLooksForwardOnly)
{
    const PickingTree tree(shapes::grid(4, 4, 4, 4));
    EXPECT_TRUE(tree.nearest_hit({1.2, 1.3, 2}, {0, 0, -1}).has_value());
    EXPECT_TRUE(tree.nearest_hit({1.2, 1.3, -2}, {0, 0, 1}).has_value());
    EXPECT_FALSE(tree.nearest_hit({1.2, 1.3, 2}, {0, 0, 1}).has_value());
    EXPECT_FALSE(tree.nearest_hit({7, 1.3, 2}, {0, 0, -1}).has_value());
}

TEST(Picking, OfTrianglesAtTheSameDistanceTheFirstIsTaken)
{
    const TriangleMesh grid = shapes::grid(2, 2, 2, 2);
    Triangles twice(16, 3);
    twice << grid.triangles(), grid.triangles();
    const PickingTree tree(TriangleMesh(grid.points(), twice));
    EXPECT_EQ(tree.nearest_hit({1, 1, 5}, {0, 0, -1})->triangle, 0);
    EXPECT_EQ(tree.nearest_hit({0.9, 0.1, 5}, {0, 0, -1})->triangle, 0);
    EXPECT_EQ(tree.nearest_point({0.9, 0.1, 5})->triangle, 0);
}

TEST(Picking, FollowsTheShapeAfterARefit)
{
    const TriangleMesh mesh = shapes::grid(10, 10, 10, 10);
    PickingTree tree(mesh);
    const TriangleMesh bent = shapes::mapped(
        mesh, [](const Vector3& p) { return Vector3(p.x(), p.y(), 0.1 * p.x() * p.x()); });
    tree.refit(bent.points());
    EXPECT_NEAR(tree.nearest_hit({8, 5, 50}, {0, 0, -1})->point.z(), 6.4, 1e-12);
    EXPECT_THROW(tree.refit(Points::Zero(3, 3)), InvalidInput);
    EXPECT_THROW(tree.refit(Points::Constant(121, 3, std::nan(""))), InvalidInput);
    EXPECT_NEAR(tree.nearest_hit({8, 5, 50}, {0, 0, -1})->point.z(), 6.4, 1e-12);
}

TEST(Picking, TheNearestPlaceIsNearerThanAllSamplesOfTheMesh)
{
    const TriangleMesh mesh = shapes::torus(20, 10, 10, 4);
    const PickingTree tree(mesh);
    Random random(5);
    for (int round = 0; round < 100; ++round)
    {
        const Vector3 point = 15.0 * random.vector();
        const Hit found = *tree.nearest_point(point);
        EXPECT_NEAR((found.point - point).norm(), found.distance, 1e-12);
        double nearest = 1e9;
        for (int t = 0; t < mesh.triangle_count(); ++t)
        {
            const Hit one = nearest_on_triangle(point, corners_of(mesh, t));
            nearest = std::min(nearest, one.distance);
            const TriangleCorners corners = corners_of(mesh, t);
            for (int i = 0; i <= 4; ++i)
                for (int j = 0; i + j <= 4; ++j)
                {
                    const Vector3 sample = corners[0] * (4 - i - j) / 4.0 + corners[1] * i / 4.0
                                           + corners[2] * j / 4.0;
                    EXPECT_GE((sample - point).norm(), found.distance - 1e-12);
                }
        }
        EXPECT_EQ(found.distance, nearest);
    }
}

TEST(Picking, TheNearestPlaceOfAPointOnTheMeshIsThePoint)
{
    const TriangleMesh mesh = turned(shapes::half_pipe(12, 20, 10, 50));
    const PickingTree tree(mesh);
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        const TriangleCorners corners = corners_of(mesh, t);
        const Vector3 place = 0.2 * corners[0] + 0.3 * corners[1] + 0.5 * corners[2];
        const auto found = tree.nearest_point(place);
        EXPECT_EQ(found->triangle, t);
        EXPECT_LT((found->barycentric - Vector3(0.2, 0.3, 0.5)).norm(), 1e-9);
        EXPECT_LT(found->distance, 1e-11);
    }
}

TEST(Picking, DegenerateTrianglesAreNotHitAndDoNoHarm)
{
    Points points(4, 3);
    points << 0, 0, 0, 1, 0, 0, 2, 0, 0, 5, 5, 5;
    Triangles triangles(3, 3);
    triangles << 0, 1, 2, 3, 3, 3, 0, 0, 1;
    const PickingTree tree(TriangleMesh(points, triangles));
    EXPECT_FALSE(tree.nearest_hit({0.5, 0, 1}, {0, 0, -1}).has_value());
    EXPECT_FALSE(tree.nearest_hit({5, 5, 9}, {0, 0, -1}).has_value());
    EXPECT_DOUBLE_EQ(tree.nearest_point({1.5, 2, 0})->distance, 2.0);
    EXPECT_DOUBLE_EQ(tree.nearest_point({5, 5, 6})->distance, 1.0);
}

TEST(Picking, PairsWhoseBoxesMeetAreThoseOfEveryPairTestedInTurn)
{
    Random random(7);
    for (const int count : {1, 2, 5, 40, 1500})
    {
        Points points(3 * count, 3);
        Triangles triangles(count, 3);
        for (int t = 0; t < count; ++t)
        {
            const Vector3 place = 10.0 * random.vector();
            for (int k = 0; k < 3; ++k)
            {
                triangles(t, k) = 3 * t + k;
                points.row(3 * t + k) = (place + random.vector()).transpose();
            }
        }
        const auto low = [&](int t) { return points.middleRows(3 * t, 3).colwise().minCoeff(); };
        const auto high = [&](int t) { return points.middleRows(3 * t, 3).colwise().maxCoeff(); };
        const auto is_wanted = [](int one, int other) { return (one + other) % 3 != 0; };
        std::vector<std::pair<int, int>> expected;
        for (int one = 0; one < count; ++one)
            for (int other = one + 1; other < count; ++other)
                if (is_wanted(one, other) && (low(one).array() <= high(other).array()).all()
                    && (low(other).array() <= high(one).array()).all())
                    expected.emplace_back(one, other);
        std::atomic<int> asked = 0;
        const auto found = PickingTree(TriangleMesh(points, triangles))
                               .pairs_where(
                                   [&](int one, int other)
                                   {
                                       ++asked;
                                       return is_wanted(one, other);
                                   });
        EXPECT_EQ(found, expected) << count;
        EXPECT_GE(asked, static_cast<int>(found.size()));
        EXPECT_LE(asked, 2 * static_cast<int>(found.size()) + 9) << "asked more than once";
    }
}

TEST(Picking, AnEmptyMeshHasNothing)
{
    const PickingTree tree{TriangleMesh()};
    EXPECT_FALSE(tree.nearest_hit({0, 0, 0}, {0, 0, 1}).has_value());
    EXPECT_FALSE(tree.nearest_point({0, 0, 0}).has_value());
}

TEST(Picking, ARayWithoutDirectionOrWithNanIsRefused)
{
    const PickingTree tree(shapes::grid(4, 4, 4, 4));
    EXPECT_THROW(tree.nearest_hit({0, 0, 0}, {0, 0, 0}), InvalidInput);
    EXPECT_THROW(tree.nearest_hit({0, std::nan(""), 0}, {0, 0, 1}), InvalidInput);
    EXPECT_THROW(tree.nearest_point({0, std::nan(""), 0}), InvalidInput);
}

}  // namespace sheetmorph::mesh
