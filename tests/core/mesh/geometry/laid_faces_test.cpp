// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/geometry/laid_faces.h"

#include "sheetmorph/mesh/geometry/fans.h"
#include "shapes.h"
#include "shapes/ugly.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace sheetmorph::mesh
{
namespace
{

double total_area(const LaidFaces& faces)
{
    double area = 0.0;
    for (const LaidFaces::Corners& corners : faces.corners)
        area += faces.share * face_area(corners);
    return area;
}

int open_sides(const LaidFaces& faces)
{
    return static_cast<int>(std::count(faces.glued.begin(), faces.glued.end(), LaidFaces::open));
}

TEST(LaidFaces, AreTheTrianglesGluedWhereTwoMeet)
{
    const TriangleMesh mesh = shapes::grid(6, 4, 60.0, 40.0);
    const LaidFaces faces = laid_faces(mesh);
    EXPECT_EQ(faces.triangles, mesh.triangles());
    EXPECT_EQ(open_sides(faces), 2 * (6 + 4));
    EXPECT_NEAR(total_area(faces), 2400.0, 1e-9);
    for (int side = 0; side < 3 * faces.count(); ++side)
        if (const int other = faces.glued[static_cast<std::size_t>(side)]; other >= 0)
        {
            EXPECT_EQ(faces.glued[static_cast<std::size_t>(other)], side);
            EXPECT_EQ(faces.from(side), faces.to(other));
            EXPECT_EQ(faces.to(side), faces.from(other));
        }
}

TEST(LaidFaces, DropDoubledAndRepeatingTriangles)
{
    const TriangleMesh clean = shapes::grid(3, 2, 30.0, 20.0);
    Triangles triangles(clean.triangle_count() + 2, 3);
    triangles << clean.triangles(), clean.triangles().row(4).reverse(), Eigen::RowVector3i(1, 1, 2);
    const LaidFaces faces = laid_faces(TriangleMesh(clean.points(), triangles));
    EXPECT_EQ(faces.triangles, clean.triangles());
    EXPECT_EQ(open_sides(faces), 2 * (3 + 2));
}

TEST(LaidFaces, LayTrianglesOfNoAreaBesideTheirNeighbour)
{
    const TriangleMesh mesh = shapes::with_slivers(shapes::grid(4, 4, 40.0, 40.0), 3, 0.0);
    for (const LaidFaces::Corners& corners : laid_faces(mesh).corners)
    {
        EXPECT_GT(face_area(corners), 0.0);
        for (const Vector3& corner : corners)
            EXPECT_NEAR(corner.z(), 0.0, 1e-12);  // in the plane of the sheet
    }
}

TEST(LaidFaces, LeaveSeamsOfThreeSheetsOpenUnderOneNumber)
{
    const LaidFaces faces = laid_faces(shapes::t_joint(4, 40.0));
    const auto seams = seams_of(faces);
    ASSERT_EQ(seams.size(), 4U);
    for (const std::vector<int>& seam : seams)
        EXPECT_EQ(seam.size(), 3U);
}

TEST(LaidFaces, AManifoldMeshIsItsOwnCover)
{
    const TriangleMesh mesh = shapes::cylinder(12, 4, 30.0, 40.0);
    EXPECT_EQ(covered_faces(mesh).count(), mesh.triangle_count());
    EXPECT_EQ(covered_faces(mesh).share, 1.0);
}

TEST(LaidFaces, TheCoverGluesEverySideButFreeEdges)
{
    const TriangleMesh mesh = shapes::t_joint(4, 40.0);
    const LaidFaces cover = covered_faces(mesh);
    EXPECT_EQ(cover.count(), 2 * mesh.triangle_count());
    EXPECT_NEAR(total_area(cover), 3.0 * 1600.0, 1e-9);
    EXPECT_EQ(open_sides(cover), 2 * 3 * 3 * 4);
    for (int side = 0; side < 3 * cover.count(); ++side)
        if (const int other = cover.glued[static_cast<std::size_t>(side)]; other >= 0)
        {
            EXPECT_EQ(cover.glued[static_cast<std::size_t>(other)], side);
            EXPECT_NE(side / 3 % mesh.triangle_count(), other / 3 % mesh.triangle_count());
        }
}

TEST(Fans, TellInteriorVerticesFromBoundariesAndBallJoints)
{
    const TriangleMesh mesh = shapes::grid(4, 3, 40.0, 30.0);
    const Fans fans = fans_of(laid_faces(mesh), mesh.vertex_count());
    EXPECT_EQ(std::count(fans.is_interior.begin(), fans.is_interior.end(), 1), 3 * 2);
    EXPECT_TRUE(std::all_of(fans.around.begin(), fans.around.end(), [](int n) { return n == 1; }));

    const TriangleMesh joint = shapes::t_joint(4, 40.0);
    const Fans around = fans_of(laid_faces(joint), joint.vertex_count());
    EXPECT_EQ(around.around[2], 1);
    EXPECT_EQ(around.is_interior[2], 0);
}

}  // namespace
}  // namespace sheetmorph::mesh
