// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/operators/followers.h"

#include "surface/free_strip.h"

#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::surface
{

using namespace mesh;
namespace
{

using cases::Case;

// A strip with vertices that only triangles of no area have: in the middle of some edges, and one
// more on such a triangle. Those are the last in the file.
Case strip_with_seams()
{
    Case one = cases::strip();
    const int count = one.mesh.vertex_count(), triangles = one.mesh.triangle_count();
    constexpr int seams = 5;
    Points points(count + seams + 1, 3);
    points.topRows(count) = one.mesh.points();
    Triangles all(triangles + seams + 1, 3);
    all.topRows(triangles) = one.mesh.triangles();
    for (int k = 0; k < seams; ++k)
    {
        const int a = all(17 * k + 3, 0), b = all(17 * k + 3, 1);
        points.row(count + k) = 0.5 * (points.row(a) + points.row(b));
        all.row(triangles + k) << a, b, count + k;
    }
    points.row(count + seams) = 0.5 * (points.row(count) + points.row(all(triangles, 0)));
    all.row(triangles + seams) << all(triangles, 0), count, count + seams;
    one.mesh = TriangleMesh(points, all);
    one.targets.handles = {
        cases::motion({0.0, 0.0, 30.0}, {0.0, 1.0, 0.0}, -20.0, {100.0, 0.0, 0.0})};
    return one;
}

// The same with triangles and vertices in another order.
Case shuffled(const Case& one, unsigned seed, VertexIds& new_id)
{
    const shapes::Renumbered other = shapes::renumbered(one.mesh, seed);
    new_id = other.new_id;
    std::vector<int> order(static_cast<std::size_t>(one.mesh.triangle_count()));
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    Case same = one;
    same.mesh =
        TriangleMesh(other.mesh.points(), other.mesh.triangles()(order, Eigen::indexing::all));
    for (KnownRegion* region : {&same.constraints.fixed[0], &same.constraints.handles[0]})
        for (int& id : region->vertices)
            id = new_id[static_cast<std::size_t>(id)];
    return same;
}

TEST(Followers, VerticesOfTrianglesWithoutAreaStayOnTheSheet)
{
    const Case one = strip_with_seams();
    const Points shape = cases::solve(one).positions;
    for (int t = one.mesh.triangle_count() - 6; t < one.mesh.triangle_count() - 1; ++t)
    {
        const auto corners = one.mesh.triangles().row(t);
        const Eigen::RowVector3d middle = 0.5 * (shape.row(corners(0)) + shape.row(corners(1)));
        EXPECT_LT((shape.row(corners(2)) - middle).norm(), 0.1);
        EXPECT_GT((shape.row(corners(2)) - one.mesh.points().row(corners(2))).norm(), 0.1);
    }
}

TEST(Followers, TheOrderOfTrianglesAndVerticesInTheFileDoesNotChangeTheShape)
{
    Case one = strip_with_seams();
    for (const Energy energy : {Energy::paper, Energy::neumann, Energy::natural})
    {
        one.constraints.energy = energy;
        const Points expected = cases::solve(one).positions;
        for (unsigned seed = 1; seed < 6; ++seed)
        {
            VertexIds new_id;
            const Case other = shuffled(one, seed, new_id);
            const Points found =
                Points(cases::solve(other).positions(new_id, Eigen::indexing::all));
            EXPECT_LT((found - expected).rowwise().norm().maxCoeff(), 1e-9 * one.mesh.size())
                << seed;
        }
    }
}

TEST(Followers, TrianglesWithoutAreaMayComeFirst)
{
    Case one = strip_with_seams();
    const Points expected = cases::solve(one).positions;
    one.mesh = TriangleMesh(one.mesh.points(), one.mesh.triangles().colwise().reverse());
    EXPECT_LT((cases::solve(one).positions - expected).rowwise().norm().maxCoeff(),
              1e-9 * one.mesh.size());
}

// What stands on a sheet moves with it as one body, at any distance and over any turn.
TEST(Followers, ATiedVertexKeepsItsPlaceOnASheetThatMovesRigidly)
{
    const TriangleMesh sheet = shapes::grid(4, 4, 40.0, 40.0);
    const int count = sheet.vertex_count();
    Points points(count + 2, 3);
    points << sheet.points(), Eigen::RowVector3d(11.0, 12.0, 7.0),
        Eigen::RowVector3d(25.0, 3.0, -4.0);
    const TriangleMesh mesh(points, sheet.triangles());
    const auto corner = [&](int k, int c) { return sheet.triangles()(k, c); };
    VertexRoles roles;
    roles.role.assign(static_cast<std::size_t>(count + 2), Role::free);
    for (const int k : {0, 1})
    {
        const int triangle = 9 * k + 3;
        roles.role[static_cast<std::size_t>(count + k)] = Role::tied;
        roles.ties.push_back(
            {count + k,
             {{corner(triangle, 0), corner(triangle, 1), corner(triangle, 2)}, {0.2, 0.3, 0.5}}});
    }
    const Followers followers(mesh, roles);
    for (const double degrees : {20.0, 120.0, 300.0})
    {
        const RigidMotion motion =
            cases::motion({5.0, -3.0, 8.0}, {0.2, 1.0, 0.4}, degrees, {10.0, 0.0, 0.0});
        Points positions = motion.apply(points);
        Points logs = motion.rotation_log.transpose().replicate(count + 2, 1);
        const Points expected = positions;
        positions.bottomRows(2).setZero();
        logs.bottomRows(2).setZero();
        followers.place(mesh, positions, logs);
        EXPECT_LT((positions - expected).cwiseAbs().maxCoeff(), 1e-11) << degrees;
        EXPECT_LT((logs.bottomRows(2).rowwise() - motion.rotation_log.transpose()).norm(), 1e-12);
    }
}

}  // namespace
}  // namespace sheetmorph::surface
