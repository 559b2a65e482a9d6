// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/geometry/delaunay_flips.h"

#include "sheetmorph/mesh/geometry/operators.h"
#include "shapes.h"
#include "shapes/ugly.h"

#include <gtest/gtest.h>
#include <limits>

namespace sheetmorph::mesh
{
namespace
{

constexpr double delaunay = -1e-8;

double total_area(const LaidFaces& faces)
{
    double area = 0.0;
    for (const LaidFaces::Corners& corners : faces.corners)
        area += faces.share * face_area(corners);
    return area;
}

// A sheet whose cells are sheared until diagonals are far from Delaunay.
TriangleMesh sheared_sheet()
{
    return shapes::mapped(shapes::grid(12, 8, 60.0, 40.0), [](const Vector3& p)
                          { return Vector3(p.x() + 3.0 * p.y(), p.y(), 0.0); });
}

Points half_cotangents_of(const LaidFaces& faces)
{
    Points weights(faces.count(), 3);
    for (int f = 0; f < faces.count(); ++f)
        for (int k = 0; k < 3; ++k)
            weights(f, k) =
                0.5 * faces.share * corner_cotangent(faces.corners[static_cast<std::size_t>(f)], k);
    return weights;
}

TEST(DelaunayFlips, LeaveAGoodMeshAsItIs)
{
    LaidFaces faces = laid_faces(shapes::grid(6, 4, 60.0, 40.0));
    EXPECT_EQ(flip_to_delaunay(faces).rounds, 0);
    EXPECT_EQ(faces.triangles, shapes::grid(6, 4, 60.0, 40.0).triangles());
}

TEST(DelaunayFlips, MakeEveryCotangentSumNonNegativeAndKeepTheArea)
{
    for (const TriangleMesh& mesh :
         {sheared_sheet(), shapes::with_slivers(shapes::grid(12, 8, 60.0, 40.0), 3, 1e-6),
          shapes::with_slivers(shapes::cylinder(24, 8, 30.0, 60.0), 3, 1e-3),
          shapes::with_slivers(shapes::sphere(3, 50.0), 5, 1e-5)})
    {
        LaidFaces faces = laid_faces(mesh);
        const double area = total_area(faces);
        EXPECT_LT(worst_cotangent_sum(faces), -0.5);
        const Convergence flips = flip_to_delaunay(faces);
        EXPECT_GT(flips.rounds, 0);
        EXPECT_TRUE(flips.is_converged);
        EXPECT_GT(worst_cotangent_sum(faces), delaunay);
        EXPECT_NEAR(total_area(faces), area, 1e-4 * area);
        for (std::size_t side = 0; side < faces.glued.size(); ++side)
            EXPECT_NE(faces.glued[side] == LaidFaces::open, faces.rim[side] == LaidFaces::open);
    }
}

TEST(DelaunayFlips, TellWhenTheyEndBefore)
{
    LaidFaces faces = laid_faces(sheared_sheet());
    const Convergence flips = flip_to_delaunay(faces, 0);
    EXPECT_FALSE(flips.is_converged);
    EXPECT_EQ(flips.rounds, 0);
    EXPECT_DOUBLE_EQ(flips.miss, -worst_cotangent_sum(faces));
    EXPECT_NE(flips.sentence().find("the triangles laid over the sheet have not settled"),
              std::string::npos);
}

// As the usual limit has for some million vertices.
TEST(DelaunayFlips, SettleWhereTheirLimitExceedsAnInt)
{
    LaidFaces faces = laid_faces(sheared_sheet());
    const Convergence flips = flip_to_delaunay(faces, std::numeric_limits<int>::max());
    EXPECT_TRUE(flips.is_converged);
    EXPECT_GT(flips.rounds, 0);
}

TEST(DelaunayFlips, KeepAFlatSheetFlatAndItsLinearFunctionsHarmonic)
{
    const TriangleMesh mesh = sheared_sheet();
    LaidFaces faces = laid_faces(mesh);
    flip_to_delaunay(faces);
    const Points flow = apply_stiffness(TriangleMesh(mesh.points(), faces.triangles),
                                        half_cotangents_of(faces), mesh.points());
    for (int i = 0; i < mesh.vertex_count(); ++i)
    {
        const double x = mesh.points()(i, 0) - 3.0 * mesh.points()(i, 1), y = mesh.points()(i, 1);
        if (x > 1.0 && x < 59.0 && y > 1.0 && y < 39.0)
        {
            EXPECT_LT(flow.row(i).norm(), 1e-9);
        }
    }
    for (int f = 0; f < faces.count(); ++f)
        for (int k = 0; k < 3; ++k)
        {
            const LaidFaces::Corners& corners = faces.corners[static_cast<std::size_t>(f)];
            const Vector3 laid = corners[static_cast<std::size_t>((k + 1) % 3)]
                                 - corners[static_cast<std::size_t>(k)];
            const Vector3 real =
                (mesh.points().row(faces.to(3 * f + k)) - mesh.points().row(faces.from(3 * f + k)))
                    .transpose();
            EXPECT_LT((laid - real).norm(), 1e-9);
        }
}

TEST(DelaunayFlips, TakeSlantedSeamsOfThreeSheetsThroughTheCover)
{
    // Slivers along the seam itself: only the cover can flip its sides.
    const TriangleMesh joint = shapes::t_joint(6, 60.0);
    const TriangleMesh mesh = shapes::with_slivers(joint, 5, 1e-4);
    LaidFaces open = laid_faces(mesh);
    LaidFaces cover = covered_faces(mesh);
    flip_to_delaunay(open);
    flip_to_delaunay(cover);
    EXPECT_GT(worst_cotangent_sum(cover), delaunay);
    EXPECT_NEAR(total_area(cover), 3.0 * 3600.0, 0.1);
}

}  // namespace
}  // namespace sheetmorph::mesh
