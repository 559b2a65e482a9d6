// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives of a triangle's energy against differences of it.
#include "sheetmorph/surface/steel/shell_element.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::surface
{
namespace
{

using Place = ShellElement::Place;
using Vector = ShellElement::Vector;
using Matrix = ShellElement::Matrix;

constexpr double bending = 0.02;  // mm^2

class Triangle
{
public:
    explicit Triangle(unsigned seed) : random_(seed) {}

    double number() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
    Vector3 vector() { return {number(), number(), number()}; }
    Vector step()
    {
        Vector found;
        for (int k = 0; k < 12; ++k)
            found(k) = number();
        return found;
    }

    //! Directors at right angles to their sides, up to half a radian off the normal.
    Place place(const ShellElement::Corners& corners)
    {
        Place found{corners, {}};
        const Vector3 normal =
            (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
        for (std::size_t k = 0; k < 3; ++k)
        {
            const Vector3 side = (corners[(k + 1) % 3] - corners[k]).normalized();
            found.directors[k] = Eigen::AngleAxisd(0.5 * number(), side) * normal;
        }
        return found;
    }

private:
    std::mt19937 random_;
};

// Corners go straight, directors turn with their sides and then about them.
Place moved(const Place& from, const Vector& step)
{
    Place to = from;
    for (std::size_t k = 0; k < 3; ++k)
        to.corners[k] += step.segment<3>(3 * static_cast<Eigen::Index>(k));
    for (std::size_t k = 0; k < 3; ++k)
    {
        const Vector3 before = (from.corners[(k + 1) % 3] - from.corners[k]).normalized();
        const Vector3 now = (to.corners[(k + 1) % 3] - to.corners[k]).normalized();
        to.directors[k] = Eigen::AngleAxisd(step(9 + static_cast<Eigen::Index>(k)), now)
                          * (Eigen::Quaterniond::FromTwoVectors(before, now) * from.directors[k]);
    }
    return to;
}

//! A triangle at rest, and places where it is stretched, bent and crushed.
struct Sample
{
    ShellElement element;
    Place place;
    double area;  //!< now over rest
};

std::vector<Sample> samples()
{
    std::vector<Sample> found;
    for (unsigned seed = 1; seed <= 12; ++seed)
    {
        Triangle draw(seed);
        const ShellElement::Corners rest = {Vector3(0.1 * draw.vector()),
                                            Vector3(1.5, 0.2, 0.1) + 0.2 * draw.vector(),
                                            Vector3(0.4, 1.1, -0.1) + 0.2 * draw.vector()};
        const ShellElement element(draw.place(rest), 0.3);
        // Stretched, a little and far crushed, and beyond where the logarithm ends.
        for (const double squeeze : {1.2, 0.7, 0.2, 0.01})
        {
            const Vector3 along = draw.vector().normalized();
            ShellElement::Corners now;
            for (std::size_t k = 0; k < 3; ++k)
                now[k] = rest[k] + (squeeze - 1.0) * along.dot(rest[k]) * along
                         + 0.02 * std::min(1.0, squeeze) * draw.vector();
            const auto area = [](const ShellElement::Corners& c)
            { return (c[1] - c[0]).cross(c[2] - c[0]).norm(); };
            found.push_back({element, draw.place(now), area(now) / area(rest)});
        }
    }
    return found;
}

double energy(const Sample& one, const Vector& step)
{
    return one.element.energy(one.element.strain(moved(one.place, step)), bending);
}

TEST(ShellElement, TheGradientIsThatOfDifferences)
{
    Triangle draw(100);
    for (const Sample& one : samples())
    {
        const Vector gradient = one.element.gradient(one.element.strain(one.place), bending);
        const double nudge = 1e-5 * std::min(1.0, one.area);
        for (int k = 0; k < 6; ++k)
        {
            const Vector step = draw.step();
            const double slope =
                (energy(one, nudge * step) - energy(one, -nudge * step)) / (2.0 * nudge);
            EXPECT_NEAR(gradient.dot(step), slope, 1e-6 * (1.0 + gradient.norm()))
                << "area " << one.area;
        }
    }
}

TEST(ShellElement, TheStiffnessIsThatOfDifferences)
{
    Triangle draw(200);
    for (const Sample& one : samples())
    {
        const ShellElement::Strain strain = one.element.strain(one.place);
        const Matrix stiffness =
            one.element.stiffness(strain, bending, one.element.stress(strain, bending));
        EXPECT_LT((stiffness - stiffness.transpose()).norm(), 1e-9 * stiffness.norm());
        const double nudge = 1e-4 * std::min(1.0, one.area);
        for (int k = 0; k < 12; ++k)
        {
            const Vector step = draw.step();
            const double curvature = (energy(one, nudge * step) + energy(one, -nudge * step)
                                      - 2.0 * energy(one, Vector::Zero()))
                                     / (nudge * nudge);
            EXPECT_NEAR(step.dot(stiffness * step), curvature, 1e-4 * (1.0 + stiffness.norm()))
                << "area " << one.area;
        }
    }
}

TEST(ShellElement, ThePredictedStressIsThatOfASmallStep)
{
    Triangle draw(300);
    for (const Sample& one : samples())
    {
        const ShellElement::Strain strain = one.element.strain(one.place);
        const double nudge = 1e-5 * std::min(1.0, one.area);
        const Vector step = nudge * draw.step();
        const ShellElement::Stress predicted = one.element.predicted(strain, bending, step);
        const ShellElement::Stress there =
            one.element.stress(one.element.strain(moved(one.place, step)), bending);
        const ShellElement::Stress here = one.element.stress(strain, bending);
        const double change = (there.membrane - here.membrane).norm();
        EXPECT_LT((predicted.membrane - there.membrane).norm(), 1e-2 * change) << one.area;
        EXPECT_LT((predicted.moments - there.moments).norm(),
                  1e-2 * (there.moments - here.moments).norm() + 1e-9)
            << one.area;
    }
}

TEST(ShellElement, TheTangentOfTensionHasNoNegativeDirection)
{
    for (const Sample& one : samples())
    {
        const ShellElement::Strain strain = one.element.strain(one.place);
        const ShellElement::Stress pull =
            ShellElement::tension(one.element.stress(strain, bending));
        const Eigen::SelfAdjointEigenSolver<Matrix> eigen(
            one.element.stiffness(strain, bending, pull));
        EXPECT_GT(eigen.eigenvalues()(0), -1e-9 * eigen.eigenvalues()(11)) << one.area;
    }
}

// A triangle in its plane at rest, directors along z.
Place flat_place(const ShellElement::Corners& corners)
{
    return {corners, {Vector3::UnitZ(), Vector3::UnitZ(), Vector3::UnitZ()}};
}

// The sheet resists alike in all directions: whichever corner comes first, and with it the axes of
// the triangle.
TEST(ShellElement, ItsEnergyDoesNotDependOnTheFirstCorner)
{
    for (unsigned seed = 1; seed <= 12; ++seed)
    {
        Triangle draw(seed);
        const Place rest =
            draw.place({Vector3(0.1 * draw.vector()), Vector3(1.5, 0.2, 0.1) + 0.2 * draw.vector(),
                        Vector3(0.4, 1.1, -0.1) + 0.2 * draw.vector()});
        const Place now = moved(rest, 0.1 * draw.step());
        const auto of = [&](std::size_t first, double thickness)
        {
            const auto turned = [&](const Place& place)
            {
                Place found;
                for (std::size_t k = 0; k < 3; ++k)
                {
                    found.corners[k] = place.corners[(k + first) % 3];
                    found.directors[k] = place.directors[(k + first) % 3];
                }
                return found;
            };
            const ShellElement element(turned(rest), 0.3);
            return element.energy(element.strain(turned(now)), thickness);
        };
        // Of a thick sheet, so that bending counts.
        for (const double thickness : {0.0, 10.0})
            for (const std::size_t first : {1u, 2u})
                EXPECT_NEAR(of(first, thickness), of(0, thickness), 1e-10 * of(0, thickness));
    }
}

// Plane stress: of a sheet of unit stiffness E h and Poisson's ratio nu.
TEST(ShellElement, PlainStrainsCostWhatPlaneStressSays)
{
    const ShellElement::Corners rest = {Vector3(0.2, 0.1, 0.0), Vector3(1.7, 0.4, 0.0),
                                        Vector3(0.5, 1.3, 0.0)};
    for (const double nu : {0.0, 0.3, 0.45})
    {
        const ShellElement element(flat_place(rest), nu);
        const auto energy_of = [&](const Matrix3& stretch)
        {
            ShellElement::Corners now;
            for (std::size_t k = 0; k < 3; ++k)
                now[k] = stretch * rest[k];
            return element.energy(element.strain(flat_place(now)), bending) / element.area();
        };
        const double small = 1e-5;
        Matrix3 pull = Matrix3::Identity(), shear = Matrix3::Identity();
        pull(0, 0) += small;
        shear(0, 1) += small;
        EXPECT_NEAR(energy_of(pull) / (small * small), 0.5 / (1.0 - nu * nu), 1e-4);
        EXPECT_NEAR(energy_of(shear) / (small * small), 0.25 / (1.0 + nu), 1e-4);
    }
}

// A flat triangle whose directors are the normals of a surface of small curvatures in its middle:
// z = (a x^2 + c y^2) / 2 + b x y.
TEST(ShellElement, CurvaturesCostWhatAThinPlateSays)
{
    const ShellElement::Corners rest = {Vector3(-0.7, -0.5, 0.0), Vector3(0.8, -0.3, 0.0),
                                        Vector3(-0.1, 0.8, 0.0)};
    const double nu = 0.3, small = 1e-5;
    const ShellElement element(flat_place(rest), nu);
    for (const Vector3& curved : {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1),
                                  Vector3(1, 1, 0), Vector3(0.3, -0.8, 0.5)})
    {
        const double a = small * curved(0), c = small * curved(1), b = small * curved(2);
        Place now = flat_place(rest);
        const auto slope = [&](const Vector3& p)
        { return Vector3(a * p.x() + b * p.y(), b * p.x() + c * p.y(), 0.0); };
        for (std::size_t k = 0; k < 3; ++k)
        {
            const Vector3& p = rest[k];
            now.corners[k].z() = 0.5 * (a * p.x() * p.x() + c * p.y() * p.y()) + b * p.x() * p.y();
        }
        for (std::size_t k = 0; k < 3; ++k)
        {
            const Vector3 side = (now.corners[(k + 1) % 3] - now.corners[k]).normalized();
            const Vector3 middle = 0.5 * (rest[k] + rest[(k + 1) % 3]);
            const Vector3 normal = Vector3::UnitZ() - slope(middle);
            now.directors[k] = (normal - normal.dot(side) * side).normalized();
        }
        const double thick = 4.0;
        const double expected = 0.5 * thick * element.area() / (1.0 - nu * nu)
                                * (a * a + c * c + 2.0 * nu * a * c + 2.0 * (1.0 - nu) * b * b);
        const double found = element.energy(element.strain(now), thick);
        EXPECT_NEAR(found / expected, 1.0, 1e-3) << curved.transpose();
    }
}

TEST(ShellElement, ItTakesEverMoreToCrushATriangle)
{
    const ShellElement::Corners rest = {Vector3(0.0, 0.0, 0.0), Vector3(1.0, 0.0, 0.0),
                                        Vector3(0.3, 0.9, 0.0)};
    const ShellElement::Corners up = {Vector3::UnitZ(), Vector3::UnitZ(), Vector3::UnitZ()};
    const ShellElement element({rest, up}, 0.3);
    double before = 0.0, slope = 0.0;
    for (double stretch = 0.99; stretch > 0.02; stretch -= 0.01)
    {
        ShellElement::Corners now = rest;
        for (Vector3& corner : now)
            corner.x() *= stretch;
        const double energy = element.energy(element.strain({now, up}), bending);
        EXPECT_GT(energy - before, slope) << stretch;
        slope = energy - before;
        before = energy;
    }
    EXPECT_GT(before, element.area());  // over E h: far above any strain that a sheet bears
}

}  // namespace
}  // namespace sheetmorph::surface
