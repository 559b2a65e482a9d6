// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/flat/flat_system.h"

#include "sheetmorph/base/rotation.h"
#include "shapes.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::surface
{

using namespace mesh;
namespace
{

// Every triangle as it is at rest, in a plane of its own.
std::vector<FlatTriangle> own_triangles(const TriangleMesh& mesh)
{
    std::vector<FlatTriangle> found;
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        const auto ids = mesh.triangles().row(t);
        const Vector3 first = mesh.points().row(ids(0)).transpose();
        const Vector3 one = mesh.points().row(ids(1)).transpose() - first;
        const Vector3 other = mesh.points().row(ids(2)).transpose() - first;
        const Vector3 x = one.normalized(), y = one.cross(other).normalized().cross(x);
        Eigen::Matrix2d sides;
        sides << x.dot(one), x.dot(other), y.dot(one), y.dot(other);
        const Eigen::Matrix2d inverse = sides.inverse();
        FlatTriangle triangle{t, {ids(0), ids(1), ids(2)}, {}, 0.5 * sides.determinant()};
        triangle.gradients << -inverse.colwise().sum(), inverse;
        found.push_back(triangle);
    }
    return found;
}

// A dome, which no plane takes without stretch, roughly flat: the model of a step is that of
// differences, its slope and its curvature.
TEST(FlatSystem, AStepHasTheSlopeAndTheCurvatureOfDifferences)
{
    const TriangleMesh dome =
        shapes::mapped(shapes::grid(6, 5, 60.0, 50.0), [](const Vector3& p)
                       { return Vector3(p.x(), p.y(), 0.01 * p.x() * p.y() - 0.008 * p.x()); });
    std::mt19937 bits(3);
    std::uniform_real_distribution<double> nudge(-0.2, 0.2);
    // Pulled, so that the tangent is positive definite.
    FlatPoints start = 1.08 * dome.points().leftCols<2>();
    for (double& place : start.reshaped())
        place += nudge(bits);
    for (const std::vector<VertexIds>& rims :
         {std::vector<VertexIds>{}, std::vector<VertexIds>{{8, 9, 16, 15}}})
    {
        FlatSystem system({dome, rims}, own_triangles(dome), start);
        system.remember();
        const auto step = system.step(0);
        ASSERT_TRUE(step);
        const auto energy_at = [&](double share)
        {
            system.move(*step, share);
            return system.energy();
        };
        const double nudged = 1e-4, here = energy_at(0.0);
        const double above = energy_at(nudged), below = energy_at(-nudged);
        EXPECT_NEAR((above - below) / (2.0 * nudged) / step->slope, 1.0, 1e-5);
        if (!rims.empty())
            continue;  // they turn along arcs
        EXPECT_NEAR((above + below - 2.0 * here) / (nudged * nudged) / -step->slope, 1.0, 1e-3);
    }
}

// A rim that the start has in its own form already stays there, however the sheet stands and
// whichever side is up.
TEST(FlatSystem, ARimIsPutWhereItFits)
{
    const TriangleMesh ring = shapes::annulus(12, 2, 10.0, 20.0);
    VertexIds rim(12);
    for (int k = 0; k < 12; ++k)
        rim[static_cast<std::size_t>(k)] = k;
    TriangleMesh uneven =
        shapes::mapped(ring, [](const Vector3& p)
                       { return Vector3(p.x() + 0.02 * p.y() * p.y(), p.y() + 0.1 * p.x(), 0.0); });
    for (const double angle : {0.0, 0.7, 2.0, -2.5})
        for (const double tilt : {0.0, 0.4, 1.1})
        {
            const Matrix3 turn = rotation_from_log(Vector3(tilt, 0.3 - tilt, 0.6));
            const TriangleMesh mesh(uneven.points() * turn.transpose(), uneven.triangles());
            const FlatPoints start = uneven.points().leftCols<2>()
                                     * Eigen::Rotation2Dd(angle).toRotationMatrix().transpose();
            const FlatSystem system({mesh, {rim}}, own_triangles(mesh), start);
            ASSERT_EQ(system.rigid_rims(), std::vector<char>{1});
            EXPECT_LT((system.positions() - start).cwiseAbs().maxCoeff(), 1e-10)
                << angle << ' ' << tilt;
        }
}

}  // namespace
}  // namespace sheetmorph::surface
