// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/mean_value_coordinates.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/parallel.h"
#include "sheetmorph/volume/control_mesh.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace sheetmorph
{

namespace
{

struct Errors
{
    double affine, sum;
    bool is_finite;
};

class MeanValueTest : public testing::Test
{
protected:
    Errors errors(const Points& points) const
    {
        const Weights weights = coordinates_.weights(points);
        const Points reached = weights * shape_.vertices();
        return {(reached - points).rowwise().norm().maxCoeff() / size_,
                (weights.rowwise().sum().array() - 1.0).abs().maxCoeff(), weights.allFinite()};
    }

    Vector3 direction()
    {
        std::normal_distribution<double> normal;
        const double x = normal(random_), y = normal(random_), z = normal(random_);
        return Vector3(x, y, z).normalized();
    }

    // Points `distance` sizes from random places of random triangles; `open` corners count.
    Points near_surface(int count, int open, double distance)
    {
        std::uniform_real_distribution<double> share(0.01, 1.0);
        Points points(count, 3);
        for (int i = 0; i < count; ++i)
        {
            const auto row = shape_.triangles().row(random_() % shape_.triangles().rows());
            Vector3 place = Vector3::Zero(), corner_shares = Vector3::Zero();
            for (int k = 0; k < open; ++k)
                corner_shares(k) = share(random_);
            for (int k = 0; k < 3; ++k)
                place += shape_.vertices().row(row(k)).transpose() * corner_shares(k)
                         / corner_shares.sum();
            points.row(i) = (place + distance * size_ * direction()).transpose();
        }
        return points;
    }

    ControlShape shape_;
    MeanValueCoordinates coordinates_{shape_.vertices(), shape_.triangles()};
    double size_ =
        (shape_.vertices().colwise().maxCoeff() - shape_.vertices().colwise().minCoeff()).norm();
    std::mt19937 random_{7};
};

// The scalar textbook weights in extended precision, for points well off every triangle's plane.
Eigen::VectorXd textbook_weights(const Points& vertices, const Triangles& triangles,
                                 const Vector3& point)
{
    using Vector = Eigen::Matrix<long double, 3, 1>;
    Eigen::Matrix<long double, Eigen::Dynamic, 1> weights =
        Eigen::Matrix<long double, Eigen::Dynamic, 1>::Zero(vertices.rows());
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    {
        Vector unit[3], normal[3], mean = Vector::Zero();
        long double distance[3];
        for (int k = 0; k < 3; ++k)
        {
            const Vector arm = vertices.row(triangles(t, k)).transpose().cast<long double>()
                               - point.cast<long double>();
            distance[k] = arm.norm();
            unit[k] = arm / distance[k];
        }
        for (int k = 0; k < 3; ++k)
        {
            const Vector cross = unit[(k + 1) % 3].cross(unit[(k + 2) % 3]);
            const long double cosine = unit[(k + 1) % 3].dot(unit[(k + 2) % 3]);
            normal[k] = cross / cross.norm();
            mean += 0.5L * std::atan2(cross.norm(), cosine) * normal[k];
        }
        for (int k = 0; k < 3; ++k)
            weights(triangles(t, k)) +=
                normal[k].dot(mean) / (distance[k] * normal[k].dot(unit[k]));
    }
    return (weights / weights.sum()).cast<double>();
}

TEST_F(MeanValueTest, WeightsSumToOneAndReproduceAffineMapsWithinTenSizes)
{
    for (double radius : {0.01, 0.1, 0.3, 0.6, 1.0, 3.0, 10.0})
    {
        Points points(4000, 3);
        for (int i = 0; i < points.rows(); ++i)
            points.row(i) = radius * size_ * direction().transpose();
        const Errors found = errors(points);
        EXPECT_LT(found.affine, 1e-12) << radius;
        EXPECT_LT(found.sum, 1e-12) << radius;
        EXPECT_TRUE(found.is_finite) << radius;
    }
}

TEST_F(MeanValueTest, PrecisionHoldsDownToTheSurface)
{
    for (int open : {1, 2, 3})
        for (double distance = 1e-1; distance > 1e-17; distance *= 0.1)
        {
            const Errors found = errors(near_surface(400, open, distance));
            EXPECT_LT(found.affine, 1e-12) << open << " corners, distance " << distance;
            EXPECT_LT(found.sum, 1e-12) << open << " corners, distance " << distance;
            EXPECT_TRUE(found.is_finite) << open << " corners, distance " << distance;
        }
}

TEST_F(MeanValueTest, AgreesWithTheTextbookFormInExtendedPrecision)
{
    std::uniform_real_distribution<double> coordinate(-2.5, 2.5);
    Points points(40, 3);
    for (int i = 0; i < points.rows(); ++i)
        for (int a = 0; a < 3; ++a)
            points(i, a) = coordinate(random_);
    const Weights weights = coordinates_.weights(points);
    for (int i = 0; i < points.rows(); ++i)
    {
        const Eigen::VectorXd expected =
            textbook_weights(shape_.vertices(), shape_.triangles(), points.row(i).transpose());
        EXPECT_LT((weights.row(i).transpose() - expected).cwiseAbs().maxCoeff(), 1e-11) << i;
    }
}

TEST_F(MeanValueTest, LowOverThePlanesOfTrianglesItAgreesWithTheTextbookForm)
{
    for (Eigen::Index t = 0; t < shape_.triangles().rows(); t += 29)
    {
        const Vector3 a = shape_.vertices().row(shape_.triangles()(t, 0));
        const Vector3 b = shape_.vertices().row(shape_.triangles()(t, 1));
        const Vector3 c = shape_.vertices().row(shape_.triangles()(t, 2));
        const Vector3 normal = (b - a).cross(c - a).normalized();
        const Vector3 away = 0.7 * size_ * (a - b).normalized();
        for (double lift : {1.5e-5, 3e-5, 1e-4, 3e-4, 1e-3})
        {
            Points point(1, 3);
            point << (a + away + lift * size_ * normal).transpose();
            const Eigen::VectorXd expected =
                textbook_weights(shape_.vertices(), shape_.triangles(), point.row(0).transpose());
            const Weights found = coordinates_.weights(point);
            EXPECT_LT((found.row(0).transpose() - expected).cwiseAbs().maxCoeff(), 1e-11)
                << t << ", " << lift;
        }
    }
}

TEST_F(MeanValueTest, AtAVertexOnlyThatVertexCounts)
{
    const Weights weights = coordinates_.weights(shape_.vertices());
    EXPECT_LT((weights - Weights::Identity(386, 386)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_F(MeanValueTest, OnATriangleTheWeightsAreLinear)
{
    const auto row = shape_.triangles().row(100);
    const Vector3 shares(0.2, 0.3, 0.5);
    Points point = Points::Zero(1, 3);
    for (int k = 0; k < 3; ++k)
        point += shares(k) * shape_.vertices().row(row(k));
    const Weights weights = coordinates_.weights(point);
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(weights(0, row(k)), shares(k), 1e-12);
    EXPECT_NEAR(weights.cwiseAbs().sum(), 1.0, 1e-12);
}

TEST_F(MeanValueTest, InThePlaneOfATriangleTheWeightsAreThoseOfThePointsBesideIt)
{
    for (int t = 0; t < shape_.triangles().rows(); t += 37)
    {
        const Vector3 a = shape_.vertices().row(shape_.triangles()(t, 0));
        const Vector3 b = shape_.vertices().row(shape_.triangles()(t, 1));
        const Vector3 c = shape_.vertices().row(shape_.triangles()(t, 2));
        const Vector3 normal = (b - a).cross(c - a).normalized();
        Points points(3, 3);
        for (int k = 0; k < 3; ++k)
            points.row(k) = (4.0 * a - 2.0 * b - c + (k - 1) * 1e-7 * normal).transpose();
        for (double lift : {0.0, 1e-16, 1e-13, 1e-10})
        {
            points.row(1) = (4.0 * a - 2.0 * b - c + lift * normal).transpose();
            const Weights weights = coordinates_.weights(points);
            const Eigen::RowVectorXd beside = 0.5 * (weights.row(0) + weights.row(2));
            EXPECT_LT((weights.row(1) - beside).cwiseAbs().maxCoeff(), 1e-7) << t << ", " << lift;
        }
    }
}

TEST_F(MeanValueTest, InsideAConvexCornerOfAnyClosedMeshNoWeightIsNegative)
{
    Points corners(4, 3);
    corners << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    Triangles faces(4, 3);
    faces << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
    const MeanValueCoordinates tetrahedron(corners, faces);
    Points point(1, 3);
    point << 0.2, 0.3, 0.1;
    const Weights weights = tetrahedron.weights(point);
    EXPECT_NEAR(weights(0, 0), 0.4, 1e-14);
    EXPECT_NEAR(weights(0, 1), 0.2, 1e-14);
    EXPECT_NEAR(weights(0, 2), 0.3, 1e-14);
    EXPECT_NEAR(weights(0, 3), 0.1, 1e-14);
}

TEST_F(MeanValueTest, FarPointsAreFinite)
{
    for (double distance : {1e3, 1e6, 1e9, 1e15})
    {
        Points point(1, 3);
        point << distance, 0.3 * distance, -0.2 * distance;
        const Weights weights = coordinates_.weights(point);
        EXPECT_TRUE(weights.allFinite()) << distance;
        EXPECT_LT((weights * shape_.vertices() - point).norm(), 1e-9 * distance) << distance;
    }
}

TEST_F(MeanValueTest, TheSizeOfTheModelDoesNotMatter)
{
    const Points points = near_surface(64, 3, 0.1);
    const Weights weights = coordinates_.weights(points);
    for (double scale : {1e-6, 1e-3, 1e6})
    {
        const MeanValueCoordinates scaled(scale * shape_.vertices(), shape_.triangles());
        EXPECT_LT((scaled.weights(scale * points) - weights).cwiseAbs().maxCoeff(), 1e-11) << scale;
    }
}

TEST_F(MeanValueTest, TheNumberOfThreadsDoesNotChangeABit)
{
    const Points points = near_surface(203, 3, 0.05);
    const auto weights = [&](int threads)
    {
        const ThreadCount some(threads);
        return coordinates_.weights(points);
    };
    const Weights one = weights(1);
    for (const int threads : {2, 3, 8})
        EXPECT_TRUE((weights(threads).array() == one.array()).all()) << threads;
}

TEST(MeanValueCoordinatesTest, AnOpenMeshIsRefusedWithTheEdge)
{
    Points corners(4, 3);
    corners << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    Triangles faces(3, 3);
    faces << 0, 2, 1, 0, 1, 3, 0, 3, 2;
    try
    {
        const MeanValueCoordinates open(corners, faces);
        FAIL() << "an open mesh was accepted";
    }
    catch (const InvalidInput& error)
    {
        EXPECT_NE(std::string(error.what()).find("between its vertices"), std::string::npos);
    }
}

}  // namespace

}  // namespace sheetmorph
