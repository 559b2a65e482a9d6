// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/geometry/operators.h"

#include "shapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace sheetmorph::mesh
{
namespace
{

double total_area(const TriangleMesh& mesh)
{
    double area = 0.0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        const Vector3 a = mesh.points().row(mesh.triangles()(t, 0)).transpose();
        const Vector3 b = mesh.points().row(mesh.triangles()(t, 1)).transpose();
        const Vector3 c = mesh.points().row(mesh.triangles()(t, 2)).transpose();
        area += 0.5 * (b - a).cross(c - a).norm();
    }
    return area;
}

TEST(Operators, VoronoiAreasShareOutTheWholeSurface)
{
    for (const TriangleMesh& mesh : {shapes::sphere(3, 10.0), shapes::jittered_grid(12, 9, 5.0, 3),
                                     shapes::graded_grid(20, 5, 100.0, 2.0)})
    {
        const Eigen::VectorXd areas = voronoi_areas(mesh);
        EXPECT_GT(areas.minCoeff(), 0.0);
        EXPECT_NEAR(areas.sum(), total_area(mesh), 1e-10 * total_area(mesh));
    }
}

TEST(Operators, LinearFunctionsAreHarmonicInsideAFlatSheet)
{
    const TriangleMesh mesh = shapes::jittered_grid(12, 9, 5.0, 3);
    const Points curvature = apply_stiffness(mesh, half_cotangents(mesh), mesh.points());
    for (int i = 0; i < mesh.vertex_count(); ++i)
    {
        const Vector3 p = mesh.points().row(i).transpose();
        const bool inside = p.x() > 0.1 && p.x() < 59.9 && p.y() > 0.1 && p.y() < 44.9;
        if (inside)
        {
            EXPECT_LT(curvature.row(i).norm(), 1e-12);
        }
    }
}

TEST(Operators, TheLaplacianOfASphereIsItsMeanCurvatureNormal)
{
    const double radius = 10.0;
    const TriangleMesh mesh = shapes::sphere(4, radius);
    const Points flow = apply_stiffness(mesh, half_cotangents(mesh), mesh.points());
    const Eigen::VectorXd areas = voronoi_areas(mesh);
    for (int i = 0; i < mesh.vertex_count(); ++i)
    {
        const Vector3 normal = flow.row(i).transpose() / (2.0 * areas(i));
        EXPECT_NEAR(normal.norm(), 1.0 / radius, 0.02 / radius);
        EXPECT_GT(normal.dot(mesh.points().row(i).transpose()), 0.0);
    }
}

TEST(Operators, TheStiffnessMatrixIsSymmetricAndAppliesLikeItsEdges)
{
    const TriangleMesh mesh = shapes::torus(20, 10, 30.0, 10.0);
    const Points weights = half_cotangents(mesh);
    const Eigen::SparseMatrix<double> stiffness = cotangent_stiffness(mesh, weights);
    EXPECT_LT((stiffness - Eigen::SparseMatrix<double>(stiffness.transpose())).norm(), 1e-12);
    EXPECT_LT((stiffness * Eigen::VectorXd::Ones(mesh.vertex_count())).norm(), 1e-11);
    const Points applied = apply_stiffness(mesh, weights, mesh.points());
    EXPECT_LT((Points(stiffness * mesh.points()) - applied).norm(), 1e-10);
}

TEST(Operators, NonNegativeWeightsStayPositiveWhereCotangentsAreNot)
{
    const TriangleMesh mesh = shapes::jittered_grid(12, 9, 5.0, 3);
    const Eigen::SparseMatrix<double> stiffness =
        non_negative_stiffness(mesh, half_cotangents(mesh));
    for (int column = 0; column < stiffness.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(stiffness, column); entry; ++entry)
        {
            if (entry.row() != column)
            {
                EXPECT_LT(entry.value(), 0.0);
            }
        }
    EXPECT_LT((stiffness * Eigen::VectorXd::Ones(mesh.vertex_count())).norm(), 1e-11);
}

// A square of two triangles, its middle vertex 2 on the lower edge closing a T-joint by a triangle
// without area, a triangle that repeats a vertex, and vertex 5 on a needle of its own.
TriangleMesh square_with_degenerate_triangles()
{
    Points points(6, 3);
    points << 0, 0, 0, 10, 0, 0, 5, 0, 0, 0, 10, 0, 10, 10, 0, 20, 0, 0;
    Triangles triangles(6, 3);
    triangles << 0, 2, 1, 0, 0, 1, 0, 1, 3, 1, 4, 3, 2, 1, 4, 0, 1, 5;
    return TriangleMesh(points, triangles);
}

TEST(Operators, DegenerateTrianglesGiveNothingInfinite)
{
    const TriangleMesh mesh = square_with_degenerate_triangles();
    const Points weights = half_cotangents(mesh);
    EXPECT_TRUE(weights.allFinite());
    EXPECT_TRUE(weights.row(1).isZero(0.0));
    EXPECT_FALSE(weights.row(0).isZero(0.0));
    EXPECT_GT(voronoi_areas(mesh).minCoeff(), 0.0);
}

TEST(Operators, AVertexOnDegenerateTrianglesAloneIsTiedToNothing)
{
    const TriangleMesh mesh = square_with_degenerate_triangles();
    EXPECT_TRUE(half_cotangents(mesh).row(5).isZero(0.0));
}

}  // namespace
}  // namespace sheetmorph::mesh
