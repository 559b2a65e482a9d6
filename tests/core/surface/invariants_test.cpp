// SPDX-License-Identifier: LGPL-2.1-or-later
// The invariants of one part: each for closed and open, coarse and graded shapes, every energy.
#include "surface/all_cases.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace sheetmorph::surface
{
namespace
{

using cases::Case;

double worst_difference(const Points& a, const Points& b)
{
    return (a - b).rowwise().norm().maxCoeff();
}

Points solve(const Case& one)
{
    return SurfaceDeformer(one.mesh, one.constraints).deform(one.targets).positions;
}

RigidMotion general_motion(double degrees)
{
    return cases::motion({30.0, -20.0, 50.0}, {0.3, -0.7, 0.4}, degrees, {5.0, 8.0, -3.0});
}

// The same case seen in other coordinates: p -> R p + t for mesh and motions alike.
Case turned(const Case& one, const RigidMotion& view)
{
    Case seen = one;
    seen.mesh = shapes::moved(one.mesh, view);
    const Matrix3 rotation = view.rotation();
    for (RigidMotion& handle : seen.targets.handles)
    {
        handle.pivot = view.apply(handle.pivot);
        handle.translation = rotation * handle.translation;
        handle.rotation_log = rotation * handle.rotation_log;
    }
    return seen;
}

class Invariants : public testing::TestWithParam<Case>
{
};

//! Shapes whose rotations the pose alone decides.
class GivenRotations : public Invariants
{
};

TEST_P(Invariants, WithoutMotionEveryVertexIsAtRestBitForBit)
{
    Case one = GetParam();
    one.targets.handles = {RigidMotion{}};
    EXPECT_EQ(solve(one), one.mesh.points());
}

TEST_P(Invariants, OneRigidMotionOfEverythingMovesThePartRigidly)
{
    Case one = GetParam();
    const RigidMotion motion = general_motion(170.0);
    one.constraints.handles.push_back(one.constraints.fixed.front());
    one.constraints.handles.back().name = "root as a handle";
    one.constraints.fixed.clear();
    one.targets.handles = {motion, motion};
    EXPECT_LT(worst_difference(solve(one), motion.apply(one.mesh.points())),
              1e-9 * one.mesh.size());
}

TEST_P(Invariants, FeaturesKeepTheirShapeAndTurnByARotation)
{
    const Case& one = GetParam();
    const Deformation shape = SurfaceDeformer(one.mesh, one.constraints).deform(one.targets);
    const double tolerance = mesh::exactness(one.mesh.points(), one.mesh.size());
    for (std::size_t k = 0; k < one.constraints.features.size(); ++k)
    {
        const Matrix3 rotation = shape.features[k].rotation();
        EXPECT_LT((rotation.transpose() * rotation - Matrix3::Identity()).norm(), 1e-12);
        EXPECT_NEAR(rotation.determinant(), 1.0, 1e-12);
        const VertexIds& vertices = one.constraints.features[k].vertices;
        for (const int a : vertices)
        {
            const Vector3 rest =
                (one.mesh.points().row(a) - one.mesh.points().row(vertices[0])).transpose();
            const Vector3 now =
                (shape.positions.row(a) - shape.positions.row(vertices[0])).transpose();
            EXPECT_LT((now - rotation * rest).norm(), tolerance);
        }
    }
}

TEST_P(Invariants, FixedAndHandleVerticesAreMetBitForBit)
{
    const Case& one = GetParam();
    const Points positions = solve(one);
    for (const int vertex : one.constraints.fixed.front().vertices)
        EXPECT_EQ(positions.row(vertex), one.mesh.points().row(vertex));
    for (const int vertex : one.constraints.handles.front().vertices)
        EXPECT_EQ(positions.row(vertex).transpose(),
                  one.targets.handles[0].apply(Vector3(one.mesh.points().row(vertex))));
}

TEST_P(GivenRotations, PositionsAreLinearInHandleTranslations)
{
    Case one = GetParam();
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    const auto displacement = [&](const Vector3& shift)
    {
        one.targets.handles[0] = RigidMotion{shift, Vector3::Zero(), Vector3::Zero()};
        return Points(deformer.deform(one.targets).positions - one.mesh.points());
    };
    const Vector3 a(10.0, 2.0, -5.0);
    const Vector3 b(-3.0, 7.0, 20.0);
    const Points together = displacement(2.0 * a - 3.0 * b);
    const Points apart = 2.0 * displacement(a) - 3.0 * displacement(b);
    EXPECT_LT(worst_difference(together, apart), 1e-10 * one.mesh.size());
}

TEST_P(Invariants, TheAnswerDoesNotDependOnTheCoordinateSystem)
{
    const Case& one = GetParam();
    const RigidMotion view = general_motion(77.0);
    EXPECT_LT(worst_difference(solve(turned(one, view)), view.apply(solve(one))),
              1e-9 * one.mesh.size());
}

TEST_P(Invariants, MillimetresAndMetresGiveTheSameShape)
{
    const Case& one = GetParam();
    Case metres = one;
    metres.mesh = mesh::TriangleMesh(one.mesh.points() / 1000.0, one.mesh.triangles());
    metres.targets.handles[0].translation /= 1000.0;
    metres.targets.handles[0].pivot /= 1000.0;
    EXPECT_LT(worst_difference(1000.0 * solve(metres), solve(one)), 1e-9 * one.mesh.size());
}

TEST_P(Invariants, AMirroredPartGivesTheMirroredAnswer)
{
    const Case& one = GetParam();
    const Vector3 flip(1.0, -1.0, 1.0);
    Case mirrored = one;
    mirrored.mesh = mesh::TriangleMesh(one.mesh.points() * flip.asDiagonal(), one.mesh.triangles());
    RigidMotion& handle = mirrored.targets.handles[0];
    handle.translation = flip.asDiagonal() * handle.translation;
    handle.pivot = flip.asDiagonal() * handle.pivot;
    handle.rotation_log = -(flip.asDiagonal() * handle.rotation_log);
    EXPECT_LT(worst_difference(solve(mirrored), solve(one) * flip.asDiagonal()),
              1e-9 * one.mesh.size());
}

TEST_P(Invariants, RenumberedVerticesGiveTheSameShape)
{
    const Case& one = GetParam();
    const shapes::Renumbered other = shapes::renumbered(one.mesh, 11);
    Case renamed = one;
    renamed.mesh = other.mesh;
    const auto rename = [&](VertexIds& ids)
    {
        for (int& id : ids)
            id = other.new_id[static_cast<std::size_t>(id)];
    };
    rename(renamed.constraints.fixed[0].vertices);
    rename(renamed.constraints.handles[0].vertices);
    for (FormFeature& feature : renamed.constraints.features)
        rename(feature.vertices);
    const Points expected = solve(one);
    const Points positions = solve(renamed);
    for (int i = 0; i < one.mesh.vertex_count(); ++i)
        EXPECT_LT(
            (positions.row(other.new_id[static_cast<std::size_t>(i)]) - expected.row(i)).norm(),
            1e-9 * one.mesh.size());
}

TEST_P(Invariants, TheSameInputGivesTheSameBits)
{
    EXPECT_EQ(solve(GetParam()), solve(GetParam()));
}

TEST_P(Invariants, TheLiveAnswerIsWithinAMillionthOfTheExactOne)
{
    const Case& one = GetParam();
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    const Points live = deformer.deform(one.targets, Exactness::live).positions;
    const Points exact = deformer.deform(one.targets, Exactness::exact).positions;
    EXPECT_LT(worst_difference(live, exact), 1e-6 * one.mesh.size());
}

TEST_P(Invariants, FarFromTheOriginTheShapeIsTheSame)
{
    const Case& one = GetParam();
    const RigidMotion away{Vector3(3.0e3, -1.0e3, 5.0e2), Vector3::Zero(), Vector3::Zero()};
    EXPECT_LT(worst_difference(solve(turned(one, away)), away.apply(solve(one))),
              1e-8 * one.mesh.size());
}

INSTANTIATE_TEST_SUITE_P(Shapes, Invariants, testing::ValuesIn(cases::all_with_every_energy()),
                         [](const testing::TestParamInfo<Case>& each) { return each.param.name; });

INSTANTIATE_TEST_SUITE_P(Shapes, GivenRotations, testing::ValuesIn(cases::all_with_every_energy()),
                         [](const testing::TestParamInfo<Case>& each) { return each.param.name; });

INSTANTIATE_TEST_SUITE_P(
    FreeFeatures, Invariants,
    testing::ValuesIn(cases::with_free_features(cases::all_with_every_energy())),
    [](const testing::TestParamInfo<Case>& each) { return each.param.name; });

}  // namespace
}  // namespace sheetmorph::surface
