// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/flat/flattening.h"
#include "sheetmorph/base/errors.h"
#include "shapes.h"

#include <gtest/gtest.h>

namespace sheetmorph::surface
{

using namespace mesh;
namespace
{

constexpr double radius = 15.0;

// A plate of 60 x 20 mm rolled up along x.
TriangleMesh rolled()
{
    const TriangleMesh flat = shapes::grid(48, 16, 60.0, 20.0);
    Points points = flat.points();
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
        const double angle = points(i, 0) / radius;
        points.row(i) << radius * std::sin(angle), flat.points()(i, 1),
            radius * (1.0 - std::cos(angle));
    }
    return {points, flat.triangles()};
}

TEST(Flattening, ARolledPlateComesBackToItsRectangle)
{
    const TriangleMesh mesh = rolled();
    const Flattening flat = flatten({mesh, {}});
    EXPECT_TRUE(flat.convergence.is_converged);
    EXPECT_TRUE(flat.flipped.empty());
    const double corners =
        (flat.positions.row(0) - flat.positions.row(flat.positions.rows() - 1)).norm();
    // Chords are shorter than arcs, by (angle of one)^2 / 24.
    EXPECT_NEAR(corners, std::hypot(60.0, 20.0), 0.03);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            const int a = mesh.triangles()(t, k), b = mesh.triangles()(t, (k + 1) % 3);
            const double before = (mesh.points().row(a) - mesh.points().row(b)).norm();
            EXPECT_NEAR((flat.positions.row(a) - flat.positions.row(b)).norm(), before,
                        1e-3 * before);
        }
}

TEST(Flattening, LongerFibresMakeALongerBlank)
{
    const TriangleMesh mesh = rolled();
    FlatInput input{mesh, {}};
    input.factors = Eigen::VectorXd::Constant(mesh.triangle_count(), 1.02);
    input.directions.resize(mesh.triangle_count(), 3);
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        const double angle =
            mesh.points()(mesh.triangles().row(t), Eigen::indexing::all).col(0).mean() / radius;
        const double turn = std::asin(std::clamp(angle, -1.0, 1.0));
        const double z = mesh.points()(mesh.triangles().row(t), Eigen::indexing::all).col(2).mean();
        const double whole = z > radius ? shapes::pi - turn : turn;
        input.directions.row(t) << std::cos(whole), 0.0, std::sin(whole);
    }
    const Flattening plain = flatten({mesh, {}}), longer = flatten(input);
    const TriangleMesh grid = shapes::grid(48, 16, 60.0, 20.0);
    const auto at_edge = [&grid](double x)
    {
        return shapes::vertices_where(
                   grid, [x](const Vector3& p) { return (p - Vector3(x, 0.0, 0.0)).norm() < 1e-6; })
            .front();
    };
    const auto width = [&at_edge](const Flattening& flat)
    { return (flat.positions.row(at_edge(0.0)) - flat.positions.row(at_edge(60.0))).norm(); };
    EXPECT_NEAR(width(longer) / width(plain), 1.02, 1e-4);
}

TEST(Flattening, APlaneRimKeepsItsForm)
{
    // Doubly curved, so that everything else is stretched.
    TriangleMesh dome = shapes::grid(24, 24, 40.0, 40.0);
    Points points = dome.points();
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        points(i, 2) = 0.01 * (std::pow(points(i, 0) - 20.0, 2) + std::pow(points(i, 1) - 20.0, 2));
    const VertexIds rim = {12 * 25 + 12, 12 * 25 + 13, 13 * 25 + 13, 13 * 25 + 12};
    for (const int vertex : rim)
        points(vertex, 2) = 0.0;
    const TriangleMesh mesh(points, dome.triangles());
    const Flattening flat = flatten({mesh, {rim}});
    EXPECT_EQ(flat.is_rigid, std::vector<char>{1});
    for (const int a : rim)
        for (const int b : rim)
            EXPECT_NEAR((flat.positions.row(a) - flat.positions.row(b)).norm(),
                        (points.row(a) - points.row(b)).norm(), 1e-10);
}

TEST(Flattening, RefusesWhatIsNoSheet)
{
    EXPECT_THROW(flatten({shapes::sphere(2, 10.0), {}}), InvalidInput);
    Points points(5, 3);
    points << 0, 0, 0, 9, 0, 0, 0, 9, 0, 0, 0, 9, 0, -9, 0;
    Triangles fins(3, 3);
    fins << 0, 1, 2, 0, 1, 3, 1, 0, 4;
    EXPECT_THROW(flatten({TriangleMesh(points, fins), {}}), InvalidInput);
    const TriangleMesh plate = rolled();
    EXPECT_THROW(flatten({plate, {}}, Progress([](double, const std::string&) { return false; })),
                 Cancelled);
}

}  // namespace
}  // namespace sheetmorph::surface
