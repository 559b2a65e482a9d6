// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/mean_value_coordinates.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/volume/control_mesh.h"
#include "volume/textbook_weights.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::volume
{

using namespace numerics;

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

// f at a point: the mean over all directions of f / r, by Gauss points on ever smaller triangles.
struct DirectionMean
{
    double above = 0.0, below = 0.0;

    void add(const Matrix3& corners, const Vector3& values, const Vector3& point, int splits)
    {
        if (splits > 0)
        {
            Matrix3 middles;
            Vector3 between;
            for (int k = 0; k < 3; ++k)
            {
                middles.row(k) = 0.5 * (corners.row(k) + corners.row((k + 1) % 3));
                between(k) = 0.5 * (values(k) + values((k + 1) % 3));
            }
            for (int k = 0; k < 3; ++k)
            {
                Matrix3 part;
                part << corners.row(k), middles.row(k), middles.row((k + 2) % 3);
                add(part, {values(k), between(k), between((k + 2) % 3)}, point, splits - 1);
            }
            add(middles, between, point, splits - 1);
            return;
        }
        const Vector3 a = corners.row(0), b = corners.row(1), c = corners.row(2);
        const Vector3 doubled = (b - a).cross(c - a);
        for (int k = 0; k < 3; ++k)
        {
            Vector3 shares = Vector3::Constant(1.0 / 6.0);
            shares(k) = 2.0 / 3.0;
            const Vector3 arm = corners.transpose() * shares - point;
            const double r = arm.norm();
            const double weight = doubled.dot(arm) / (6.0 * r * r * r * r);
            above += weight * values.dot(shares);
            below += weight;
        }
    }

    double value() const { return above / below; }
};

TEST_F(MeanValueTest, IsTheMeanOverAllDirectionsThatDefinesIt)
{
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    Eigen::VectorXd values(shape_.vertices().rows());
    for (double& one : values)
        one = value(random_);
    Points points(6, 3);
    for (int i = 0; i < points.rows(); ++i)
        points.row(i) = ((i < 4 ? 0.15 : 0.9) * size_ * direction()).transpose();
    const Eigen::VectorXd found = coordinates_.weights(points) * values;
    for (int i = 0; i < points.rows(); ++i)
    {
        DirectionMean mean;
        for (Eigen::Index t = 0; t < shape_.triangles().rows(); ++t)
        {
            Matrix3 corners;
            Vector3 own;
            for (int k = 0; k < 3; ++k)
            {
                corners.row(k) = shape_.vertices().row(shape_.triangles()(t, k));
                own(k) = values(shape_.triangles()(t, k));
            }
            mean.add(corners, own, points.row(i).transpose(), 4);
        }
        EXPECT_NEAR(found(i), mean.value(), 2e-6) << i;
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

}  // namespace sheetmorph::volume
