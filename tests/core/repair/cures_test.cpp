// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/cures.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/quality/diagnosis.h"
#include "shapes.h"

#include "sheetmorph/mesh/topology/orientation.h"

#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace sheetmorph::repair
{

using namespace mesh;
namespace
{

// Every triangle with corners of its own, moved a little, every seventh turned over.
TriangleMesh shattered(const TriangleMesh& mesh, double amplitude)
{
    Points points(3 * mesh.triangle_count(), 3);
    Triangles triangles(mesh.triangle_count(), 3);
    const Points noise = amplitude * Points::Random(points.rows(), 3);
    for (int k = 0; k < points.rows(); ++k)
    {
        points.row(k) = mesh.points().row(mesh.triangles()(k / 3, k % 3)) + noise.row(k);
        triangles(k / 3, k % 3) = k;
    }
    for (int t = 0; t < mesh.triangle_count(); t += 7)
        std::swap(triangles(t, 1), triangles(t, 2));
    return TriangleMesh(points, triangles);
}

TEST(Cures, MakeASolidOfAShatteredOne)
{
    const TriangleMesh box = shapes::box(3, Vector3(30, 20, 2));
    const CuredMesh found = cured(shattered(box, 1e-6), 1e-5);
    const Diagnosis diagnosis = diagnose(found.mesh, 1e-5);
    EXPECT_EQ(found.mesh.vertex_count(), box.vertex_count());
    EXPECT_EQ(diagnosis.open_edges, 0);
    EXPECT_EQ(diagnosis.flipped_triangles, 0);
    EXPECT_EQ(found.welded, 3 * box.triangle_count() - box.vertex_count());
    EXPECT_GT(found.turned, 0);
    EXPECT_EQ(diagnosis.pieces[0].kind, PieceKind::solid);
}

TEST(Cures, CutEdgesAtTJunctionsAndFollowEveryTriangle)
{
    const TriangleMesh left = shapes::grid(4, 2, 4.0, 6.0);
    const TriangleMesh right = shapes::mapped(
        shapes::grid(4, 3, 4.0, 6.0), [](Vector3 p) { return Vector3(p.x() + 4.0, p.y(), 0.0); });
    const TriangleMesh misfit = shapes::welded({left, right});
    const CuredMesh found = cured(misfit, 1e-6);
    const Diagnosis diagnosis = diagnose(found.mesh, 1e-6);
    EXPECT_EQ(diagnosis.t_junctions, 0);
    EXPECT_EQ(diagnosis.open_edges, 2 * (4 + 4) + 2 + 3);
    ASSERT_EQ(static_cast<int>(found.triangle_of.size()), found.mesh.triangle_count());
    EXPECT_NEAR(diagnosis.pieces[0].area, 48.0, 1e-9);
}

TEST(Cures, TellWhenCutsWereLeft)
{
    const TriangleMesh left = shapes::grid(4, 2, 4.0, 6.0);
    const TriangleMesh right = shapes::mapped(
        shapes::grid(4, 3, 4.0, 6.0), [](Vector3 p) { return Vector3(p.x() + 4.0, p.y(), 0.0); });
    const TriangleMesh misfit = shapes::welded({left, right});
    EXPECT_TRUE(cured(misfit, 1e-6).convergence.is_converged);
    const CuredMesh ended = cured(misfit, 1e-6, 1);
    EXPECT_FALSE(ended.convergence.is_converged);
    EXPECT_EQ(ended.convergence.miss, ended.split);
    EXPECT_EQ(ended.convergence.sentence(),
              "the cuts at T-junctions did not converge in 1 iteration (the last one still changed "
                  + std::to_string(ended.split) + " triangles)");
}

TEST(Cures, RemoveWhatHasNoHeightAndCloseTheGap)
{
    Points points(5, 3);
    points << 0, 0, 0, 10, 0, 0, 5, 8, 0, 5, 0, 0, 5, -8, 0;
    Triangles triangles(5, 3);  // 0 3 1 has no height, 1 0 4 stands twice
    triangles << 0, 3, 2, 3, 1, 2, 0, 1, 3, 1, 0, 4, 4, 1, 0;
    const CuredMesh found = cured(TriangleMesh(points, triangles), 1e-9);
    EXPECT_EQ(found.removed, 2);
    EXPECT_EQ(found.split, 1);
    EXPECT_EQ(found.mesh.triangle_count(), 4);
    EXPECT_EQ(diagnose(found.mesh, 1e-9).open_edges, 4);
}

TEST(Cures, KeepEdgesOfThreeTriangles)
{
    Points points(5, 3);
    points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1;
    Triangles triangles(3, 3);
    triangles << 0, 1, 2, 1, 0, 3, 0, 1, 4;
    const CuredMesh found = cured(TriangleMesh(points, triangles), 0.0);
    EXPECT_EQ(found.mesh.vertex_count(), 5);
    EXPECT_EQ(diagnose(found.mesh, 0.0).non_manifold_edges, 1);
}

TEST(Cures, MakeOneSolidOfTwoThatShareAWall)
{
    const TriangleMesh left = shapes::box(6, Vector3(30, 20, 2));
    const TriangleMesh right = shapes::mapped(shapes::box(4, Vector3(30, 20, 2)), [](Vector3 p)
                                              { return Vector3(p.x() + 30.0, p.y(), p.z()); });
    const TriangleMesh both = shapes::welded({left, right});
    const CuredMesh found = cured(both, 1e-6);
    const Diagnosis diagnosis = diagnose(found.mesh, 1e-6);
    EXPECT_EQ(diagnosis.non_manifold_edges + diagnosis.open_edges + diagnosis.unused_vertices, 0);
    ASSERT_EQ(diagnosis.pieces.size(), 1u);
    EXPECT_NEAR(diagnosis.pieces[0].area, 2.0 * (60.0 * 20.0 + 60.0 * 2.0 + 20.0 * 2.0), 1e-6);
    EXPECT_NEAR(diagnosis.pieces[0].volume, 60.0 * 20.0 * 2.0, 1e-6);
}

TEST(Cures, LeaveSolidsThatShareAnEdgeAlone)
{
    const TriangleMesh box = shapes::box(2, Vector3(4, 4, 4));
    const TriangleMesh both = shapes::welded(
        {box, shapes::mapped(box, [](Vector3 p) { return Vector3(p + Vector3(4, 4, 0)); })});
    const CuredMesh found = cured(both, 1e-6);
    EXPECT_EQ(found.mesh.triangle_count(), both.triangle_count());
    EXPECT_EQ(found.split + found.removed, 0);
}

double volume_of(const TriangleMesh& mesh)
{
    std::vector<int> all(static_cast<std::size_t>(mesh.triangle_count()));
    std::iota(all.begin(), all.end(), 0);
    return signed_volume(mesh, all, std::vector<int>(all.size(), 1));
}

TriangleMesh turned_over(const TriangleMesh& mesh, unsigned seed, double share)
{
    std::mt19937 random(seed);
    Triangles triangles = mesh.triangles();
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (std::uniform_real_distribution<double>()(random) < share)
            std::swap(triangles(t, 1), triangles(t, 2));
    return TriangleMesh(mesh.points(), triangles);
}

TEST(Cures, TurnAClosedPieceOutwardsHoweverManyOfItsTrianglesFaceInwards)
{
    const TriangleMesh box = shapes::box(4, Vector3(30, 20, 2));
    for (const double share : {0.0, 0.2, 0.5, 0.8, 1.0})
        for (unsigned seed = 0; seed < 4; ++seed)
        {
            const CuredMesh found = cured(turned_over(box, seed, share), 1e-6);
            EXPECT_NEAR(volume_of(found.mesh), 30.0 * 20.0 * 2.0, 1e-6) << share;
            EXPECT_EQ(found.turned > 0, share > 0.0);
        }
}

TEST(Cures, LeaveTheSurfaceOfAVoidFacingIntoIt)
{
    const TriangleMesh outer = shapes::sphere(2, 10.0);
    const TriangleMesh hollow = turned_over(shapes::sphere(2, 5.0), 0, 1.0);
    const TriangleMesh beside = turned_over(
        shapes::mapped(outer, [](Vector3 p) { return Vector3(p + Vector3(40, 0, 0)); }), 0, 1.0);
    const double ball = volume_of(outer);
    EXPECT_NEAR(volume_of(cured(shapes::welded({outer, hollow, beside}), 1e-6).mesh),
                2.0 * ball - ball / 8.0, 1e-6);
}

TEST(Cures, RefuseATolerancesThatLeavesNothing)
{
    EXPECT_THROW(cured(shapes::box(1, Vector3(1, 1, 1)), 10.0), InvalidInput);
    EXPECT_THROW(cured(shapes::box(1, Vector3(1, 1, 1)), -1.0), InvalidInput);
}

// Cuts at T-junctions may make the triangle that is there already.
TEST(Cures, LeaveNoTriangleTwiceWhereCutsMakeTheSame)
{
    Points points(4, 3);
    points << 0, 0, 0, 2, 0, 0, 1, 0, 0, 1, 1, 0;
    Triangles triangles(3, 3);
    triangles << 0, 1, 3, 0, 2, 3, 0, 2, 3;
    const CuredMesh found = cured(TriangleMesh(points, triangles), 1e-6);
    EXPECT_EQ(found.split, 1);
    EXPECT_EQ(found.mesh.triangle_count(), 2);
    EXPECT_EQ(diagnose(found.mesh, 1e-6).duplicate_triangles, 0);
    EXPECT_EQ(found.removed, 2);
}

}  // namespace
}  // namespace sheetmorph::repair
