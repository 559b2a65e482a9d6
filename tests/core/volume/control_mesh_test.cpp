// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/control_mesh.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/rotation.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>

namespace sheetmorph::volume
{

namespace
{

// Van Oosterom and Strackee: the share of the sphere that the mesh covers; 1 inside, 0 outside.
double winding(const Points& vertices, const Triangles& triangles, const Vector3& point)
{
    double angle = 0.0;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    {
        const Vector3 a = vertices.row(triangles(t, 0)).transpose() - point;
        const Vector3 b = vertices.row(triangles(t, 1)).transpose() - point;
        const Vector3 c = vertices.row(triangles(t, 2)).transpose() - point;
        const double na = a.norm(), nb = b.norm(), nc = c.norm();
        angle += 2.0
                 * std::atan2(a.dot(b.cross(c)),
                              na * nb * nc + a.dot(b) * nc + b.dot(c) * na + c.dot(a) * nb);
    }
    return angle / (16.0 * std::atan(1.0));
}

TEST(ControlMeshTest, ThreeLevelsHaveTheFaceCountOfTheDesign)
{
    const ControlShape shape;
    EXPECT_EQ(shape.vertex_count(), 386);
    EXPECT_EQ(shape.triangles().rows(), 768);
    EXPECT_EQ(ControlShape(1).vertex_count(), 26);
    EXPECT_EQ(ControlShape(2).vertex_count(), 98);
    EXPECT_THROW(ControlShape(0), InvalidInput);
    EXPECT_THROW(ControlShape(6), InvalidInput);
}

TEST(ControlMeshTest, TheShapeThatIsSharedIsMadeOnce)
{
    const ControlShape& shape = ControlShape::shared(2);
    EXPECT_EQ(&ControlShape::shared(2), &shape);
    EXPECT_EQ(shape.vertices(), ControlShape(2).vertices());
    EXPECT_THROW(ControlShape::shared(6), InvalidInput);
}

TEST(ControlMeshTest, TheCornersOfTheBoxAreOnIt)
{
    const OrientedBox box{rotation_from_log(Vector3(0.1, 0.2, -0.3)), Vector3(1, 2, 3),
                          Vector3(30, 10, 2), Vector3::Zero()};
    const ControlMesh mesh{ControlShape(), box};
    for (int k = 0; k < 8; ++k)
    {
        const Vector3 sign(k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0);
        const Vector3 corner = box.centre + box.axes * sign.cwiseProduct(box.half_extents);
        EXPECT_LT((mesh.vertices.row(k).transpose() - corner).norm(), 1e-12);
    }
}

TEST(ControlMeshTest, EnclosesTheBoxAtEveryLevel)
{
    for (int levels : {1, 2, 3, 4})
    {
        const ControlShape shape(levels);
        const int steps = 12;
        for (int i = 0; i <= steps; ++i)
            for (int j = 0; j <= steps; ++j)
                for (double height : {-1.0, 1.0})
                {
                    const Vector3 at(2.0 * i / steps - 1.0, 2.0 * j / steps - 1.0, height);
                    // A share inside, so that the corners, which are on the mesh, are decided too.
                    EXPECT_NEAR(winding(shape.vertices(), shape.triangles(), (1.0 - 1e-9) * at),
                                1.0, 1e-6)
                        << levels << " levels at " << at.transpose();
                }
        EXPECT_NEAR(winding(shape.vertices(), shape.triangles(), Vector3(1.2, 1.2, 1.2)), 0.0,
                    1e-6);
    }
}

TEST(ControlMeshTest, HasTheMirrorSymmetriesOfTheCube)
{
    const ControlShape shape;
    for (int axis = 0; axis < 3; ++axis)
    {
        Points mirrored = shape.vertices();
        mirrored.col(axis) *= -1.0;
        for (Eigen::Index t = 0; t < shape.triangles().rows(); t += 5)
        {
            Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
            for (int k = 0; k < 3; ++k)
                middle += mirrored.row(shape.triangles()(t, k)) / 3.0;
            double nearest = 1.0;
            for (Eigen::Index s = 0; s < shape.triangles().rows(); ++s)
            {
                Eigen::RowVector3d other = Eigen::RowVector3d::Zero();
                for (int k = 0; k < 3; ++k)
                    other += shape.vertices().row(shape.triangles()(s, k)) / 3.0;
                nearest = std::min(nearest, (middle - other).norm());
            }
            EXPECT_LT(nearest, 1e-12) << "axis " << axis << ", triangle " << t;
        }
    }
}

TEST(ControlMeshTest, TheLaplacianOfAConstantIsZero)
{
    const ControlShape shape(2);
    EXPECT_LT((shape.laplacian() * Eigen::VectorXd::Ones(shape.vertex_count())).norm(), 1e-13);
}

}  // namespace

}  // namespace sheetmorph::volume
