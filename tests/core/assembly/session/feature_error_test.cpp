// SPDX-License-Identifier: LGPL-2.1-or-later
// The figures of a certificate must be right themselves.
#include "sheetmorph/assembly/session/feature_error.h"

#include "sheetmorph/base/rotation.h"
#include "shapes/plates.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace sheetmorph::assembly
{
namespace
{

const RigidMotion motion{{3.0, -8.0, 5.0}, {0.3, -0.4, 0.8}, {60.0, 30.0, 0.0}};

struct Hole
{
    shapes::PlateWithHoles plate = shapes::plate_with_holes();
    VertexIds rim = plate.rims[1];
    forms::FeatureShape shape = *forms::feature_shape(plate.mesh, rim);
    Points rest = plate.mesh.points()(rim, Eigen::indexing::all);
};

TEST(FeatureError, TheEdgesOfAFeatureAreThoseBetweenItsVertices)
{
    const mesh::TriangleMesh sheet = shapes::grid(4, 4, 40.0, 40.0);
    // A cell of the sheet and a row of three vertices that no edges join.
    const std::vector<FeatureEdges> edges = edges_of_features(sheet, {{6, 7, 11, 12}, {0, 22, 14}});
    std::set<std::pair<int, int>> of_cell, of_row;
    for (const auto& [a, b] : edges[0])
        of_cell.insert(std::minmax(a, b));
    for (const auto& [a, b] : edges[1])
        of_row.insert(std::minmax(a, b));
    for (const std::pair<int, int>& side :
         {std::pair(6, 7), std::pair(6, 11), std::pair(7, 12), std::pair(11, 12)})
        EXPECT_EQ(of_cell.count(side), 1u);
    EXPECT_EQ(of_row, (std::set<std::pair<int, int>>{{0, 22}, {14, 22}}));
}

TEST(FeatureError, IsHowFarAVertexLeftTheRigidMotion)
{
    const Hole hole;
    const mesh::TriangleMesh& mesh = hole.plate.mesh;
    const FeatureEdges edges = edges_of_features(mesh, {hole.rim})[0];
    Points positions = motion.apply(mesh.points());
    EXPECT_LT(edge_error(mesh.points(), edges, positions, motion), 1e-12 * mesh.size());
    const Vector3 push(0.01, -0.02, 0.02);
    positions.row(hole.rim[5]) += push.transpose();
    EXPECT_NEAR(edge_error(mesh.points(), edges, positions, motion), push.norm(), 1e-10);
    // Another rotation than that of the vertices.
    RigidMotion other = motion;
    other.rotation_log += Vector3(0.0, 0.0, 0.1);
    EXPECT_GT(edge_error(mesh.points(), edges, positions, other), 0.1);
}

TEST(FeatureError, OfAnOutlineIsTheDistanceFromItsCircle)
{
    const Hole hole;  // 24 mm
    for (const double size : {20.0, 24.0, 30.0})
    {
        const SizedForm form{hole.shape, size, hole.shape.resized(hole.rest, size)};
        const Points exact = motion.apply(form.rest);
        EXPECT_LT(outline_error(form, exact, motion.rotation()), 1e-10);
        for (const double off : {0.05, -0.03})
        {
            const Points wide = motion.apply(hole.shape.resized(hole.rest, size + 2.0 * off));
            EXPECT_NEAR(outline_error(form, wide, motion.rotation()), std::abs(off), 1e-10);
        }
        // An oval, half a percent longer along x and shorter along y.
        Points oval = form.rest;
        const Eigen::RowVector3d centre = oval.colwise().mean();
        oval.rowwise() -= centre;
        oval.col(0) *= 1.005;
        oval.col(1) *= 0.995;
        oval.rowwise() += centre;
        EXPECT_NEAR(outline_error(form, motion.apply(oval), motion.rotation()), 0.0025 * size,
                    1e-6);
    }
}

}  // namespace
}  // namespace sheetmorph::assembly
