// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts that are refined for large rotations.
#include "sheetmorph/surface/steel/steel_answer.h"
#include "surface/all_cases.h"
#include "surface/free_strip.h"

#include <gtest/gtest.h>

namespace sheetmorph::surface
{
namespace
{

using namespace cases;

Case twisted(bool is_refined)
{
    Case one = strip_with_holes();
    one.constraints.is_refined = is_refined;
    one.targets.handles = {motion({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 120.0, {300.0, 50.0, 0.0})};
    return one;
}

// Root mean square change of the edges' length, relative.
double stretch(const Case& one, const Points& shape)
{
    double sum = 0.0;
    const Triangles& triangles = one.mesh.triangles();
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            const int a = triangles(t, k), b = triangles(t, (k + 1) % 3);
            const double rest = (one.mesh.points().row(a) - one.mesh.points().row(b)).norm();
            sum += std::pow((shape.row(a) - shape.row(b)).norm() / rest - 1.0, 2);
        }
    return std::sqrt(sum / static_cast<double>(3 * triangles.rows()));
}

TEST(Refined, ATwistedStripIsStretchedFarLess)
{
    const Case plain = twisted(false);
    const Case refined = twisted(true);
    const double before = stretch(plain, solve(plain).positions);
    EXPECT_LT(stretch(refined, solve(refined).positions), 0.6 * before);
}

TEST(Refined, FeaturesStayExactAndHandlesAreMet)
{
    const Case one = twisted(true);
    const Deformation shape = solve(one);
    for (std::size_t k = 0; k < one.constraints.features.size(); ++k)
        for (const int vertex : one.constraints.features[k].vertices)
            EXPECT_LT((shape.positions.row(vertex).transpose()
                       - shape.features[k].apply(Vector3(one.mesh.points().row(vertex))))
                          .norm(),
                      1e-10);
    for (const int vertex : one.constraints.handles[0].vertices)
        EXPECT_EQ(Vector3(shape.positions.row(vertex)),
                  one.targets.handles[0].apply(Vector3(one.mesh.points().row(vertex))));
}

TEST(Refined, LeavesRestAndRigidMotionsAlone)
{
    for (Case one : with_free_features(all_with_every_energy()))
    {
        one.constraints.is_refined = true;
        one.targets.handles = {RigidMotion{}};
        EXPECT_LT((solve(one).positions - one.mesh.points()).cwiseAbs().maxCoeff(),
                  1e-10 * one.mesh.size())
            << one;
        const RigidMotion all =
            motion({30.0, -20.0, 50.0}, {0.3, -0.7, 0.4}, 170.0, {5.0, 8.0, 1.0});
        one.constraints.handles.push_back(one.constraints.fixed.front());
        one.constraints.fixed.clear();
        one.targets.handles = {all, all};
        EXPECT_LT((solve(one).positions - all.apply(one.mesh.points())).cwiseAbs().maxCoeff(),
                  1e-9 * one.mesh.size())
            << one;
    }
}

TEST(Refined, ConvergesToTheSameShapeFromPosesNearby)
{
    Case one = twisted(true);
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    const Deformation found = deformer.deform(one.targets);
    EXPECT_TRUE(found.convergence.is_converged);
    one.targets.handles[0].rotation_log *= 1.0001;
    EXPECT_LT((deformer.deform(one.targets).positions - found.positions).cwiseAbs().maxCoeff(),
              0.1);
}

TEST(Refined, AnswersOfAllEnergiesAreOne)
{
    Case one = twisted(true);
    const Points shape = solve(one).positions;
    for (const Energy energy : {Energy::paper, Energy::natural})
    {
        one.constraints.energy = energy;
        EXPECT_LT((solve(one).positions - shape).cwiseAbs().maxCoeff(), 1e-4 * one.mesh.size());
    }
}

TEST(Refined, AFreeFeatureOfOneVertexOrOfALineIsSolved)
{
    for (const std::size_t count : {1U, 2U})
    {
        Case one = strip_with_holes(true);
        one.constraints.is_refined = true;
        one.constraints.features[0].vertices.resize(count);
        const Deformation found = solve(one);
        EXPECT_TRUE(found.convergence.is_converged) << count;
        EXPECT_TRUE(found.positions.allFinite()) << count;
    }
}

TEST(Refined, NodesOfNoTriangleDoNotChangeHowThickASheetIs)
{
    const Case one = twisted(true);
    Points points(one.mesh.vertex_count() + 1, 3);
    points << one.mesh.points(), 1e4, 1e4, 1e4;
    const mesh::TriangleMesh with(points, one.mesh.triangles());
    EXPECT_EQ(sheet_thickness(0.0, with), sheet_thickness(0.0, one.mesh));
    const SurfaceDeformer deformer(with, one.constraints);
    EXPECT_LT((deformer.deform(one.targets).positions.topRows(one.mesh.vertex_count())
               - solve(one).positions)
                  .cwiseAbs()
                  .maxCoeff(),
              1e-6 * one.mesh.size());
}

}  // namespace
}  // namespace sheetmorph::surface
