// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/quality/diagnosis.h"

#include "shapes.h"

#include <gtest/gtest.h>

namespace sheetmorph::mesh
{
namespace
{

// Every triangle with corners of its own, as an STL file has them.
TriangleMesh unwelded(const TriangleMesh& mesh)
{
    Points points(3 * mesh.triangle_count(), 3);
    Triangles triangles(mesh.triangle_count(), 3);
    for (int k = 0; k < points.rows(); ++k)
    {
        points.row(k) = mesh.points().row(mesh.triangles()(k / 3, k % 3));
        triangles(k / 3, k % 3) = k;
    }
    return TriangleMesh(points, triangles);
}

TEST(Diagnosis, TellsSolidsAndOpenShells)
{
    EXPECT_EQ(diagnose(shapes::sphere(3, 10.0), 1e-6).pieces[0].kind, PieceKind::solid);
    EXPECT_EQ(diagnose(shapes::box(3, Vector3(10, 10, 300)), 1e-6).pieces[0].kind,
              PieceKind::solid);
    const Diagnosis plate = diagnose(shapes::plate_with_holes().mesh, 1e-6);
    EXPECT_EQ(plate.pieces[0].kind, PieceKind::open_shell);
    EXPECT_EQ(plate.rims.count, 3);
    EXPECT_NEAR(plate.rims.smallest_radius, 12.0, 1e-9);
    EXPECT_EQ(plate.rims.fewest_vertices, 32);
}

TEST(Diagnosis, SeesThroughCutsAtNearVertices)
{
    const TriangleMesh box = shapes::box(2, Vector3(40, 40, 2));
    TriangleMesh soup = unwelded(box);
    Points points = soup.points();
    points.row(5).array() += 1e-7;
    soup = TriangleMesh(points, soup.triangles());
    const Diagnosis found = diagnose(soup, 1e-6);
    EXPECT_EQ(found.open_edges, 3 * box.triangle_count());
    EXPECT_EQ(found.open_edges_welded, 0);
    EXPECT_GT(found.duplicate_vertices, 0);
    EXPECT_GT(found.near_duplicate_vertices, 0);
    ASSERT_EQ(found.pieces.size(), 1U);
    EXPECT_NEAR(found.pieces[0].volume, 3200.0, 1e-3);
}

TEST(Diagnosis, CountsWhatIsWrongWithTriangles)
{
    Points points(7, 3);
    points << 0, 0, 0, 100, 0, 0, 50, 1, 0, 50, 40, 0, 50, 0, 0, 9, 9, 9, 50, -40, 0;
    Triangles triangles(5, 3);
    triangles << 0, 1, 2, 1, 0, 2, 0, 4, 1, 0, 2, 3, 0, 1, 6;
    const Diagnosis found = diagnose(TriangleMesh(points, triangles), 1e-6);
    EXPECT_EQ(found.slivers, 2);
    EXPECT_EQ(found.duplicate_triangles, 1);
    EXPECT_EQ(found.degenerate_triangles, 1);
    EXPECT_EQ(found.unused_vertices, 1);
    EXPECT_EQ(found.non_manifold_edges, 1);
    EXPECT_DOUBLE_EQ(found.edges.longest, 100.0);
}

TEST(Diagnosis, KeepsSolidsApartThatOnlyTouch)
{
    const TriangleMesh box = shapes::box(2, Vector3(10, 10, 10));
    Points points(2 * box.vertex_count(), 3);
    points << box.points(), box.points().rowwise() + Eigen::RowVector3d(10, 0, 0);
    Triangles triangles(2 * box.triangle_count(), 3);
    triangles << box.triangles(), box.triangles().array() + box.vertex_count();
    const Diagnosis found = diagnose(TriangleMesh(points, triangles), 1e-6);
    EXPECT_EQ(found.pieces.size(), 2U);
    EXPECT_EQ(found.duplicate_vertices, 0);
    EXPECT_EQ(found.non_manifold_edges_welded, 0);
}

TEST(Diagnosis, NoticesASolidTurnedInsideOut)
{
    const TriangleMesh box = shapes::box(2, Vector3(10, 10, 10));
    const TriangleMesh inverted(box.points(), box.triangles().rowwise().reverse());
    EXPECT_FALSE(diagnose(box, 1e-6).pieces[0].is_inside_out);
    EXPECT_TRUE(diagnose(inverted, 1e-6).pieces[0].is_inside_out);
}

}  // namespace
}  // namespace sheetmorph::mesh
