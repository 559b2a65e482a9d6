// SPDX-License-Identifier: LGPL-2.1-or-later
// Sheets that are pushed together: they buckle, or the answer says that it did not converge.
#include "sheetmorph/surface/solve/prepared_surface.h"
#include "sheetmorph/surface/steel/shell_minimum.h"
#include "surface/all_cases.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::surface
{
namespace
{

using namespace cases;

constexpr double length = 100.0, width = 25.0;
constexpr int along = 32, across = 8;

Case strip(int lengths = 1)
{
    const double whole = lengths * length;
    Case one{"strip", shapes::grid(lengths * along, across, whole, width), {}, {}};
    one.constraints.energy = Energy::neumann;
    one.constraints.fixed = {
        region("root", one.mesh, [](const Vector3& p) { return p.x() < 1e-9; })};
    one.constraints.handles = {
        region("tip", one.mesh, [whole](const Vector3& p) { return p.x() > whole - 1e-9; })};
    one.targets.handles.resize(1);
    one.targets.handles[0].pivot = Vector3(length, 0.5 * width, 0.0);
    return one;
}

//! The shell of an answer, where minimise_shell() left it.
class Answered
{
public:
    Answered(const Case& one, double thickness)
        : thickness_(thickness),
          part_(one.mesh, one.constraints, {}, nullptr),
          placement_(part_.placement()),
          linear_(SurfaceDeformer(one.mesh, one.constraints).deform(one.targets)),
          bodies_(known_body_motions(placement_, one.targets)),
          shell_mesh_(one.mesh),
          joints_(placement_, one.targets, turners_, bodies_),
          shell_({shell_mesh_, placement_, one.constraints.poisson},
                 ShellMovers(
                     shell_mesh_,
                     {placement_, one.targets, bodies_, linear_.positions, linear_.rotation_logs},
                     joints_, turners_),
                 joints_),
          convergence(minimise_shell(shell_, {one.targets, length, thickness}))
    {
    }

private:
    double thickness_;
    PreparedSurface part_;
    PlacementInput placement_;
    Deformation linear_;
    BodyMotions bodies_;
    ShellMesh shell_mesh_;
    std::vector<Turner> turners_;
    Joints joints_;
    ShellSystem shell_;

public:
    Convergence convergence;

    const Points& positions() const { return shell_.shape().positions; }
    double energy() const { return shell_.energy(thickness_ * thickness_ / 12.0); }

    //! The norm of the gradient by differences of the energy along random directions, which know
    //! nothing of the solver's tangent.
    double measured_gradient()
    {
        const ShellShape found = shell_.shape();
        std::mt19937 random(5);
        std::normal_distribution<double> number;
        constexpr double nudge = 1e-5;
        constexpr int directions = 10;
        double sum = 0.0;
        for (int k = 0; k < directions; ++k)
        {
            const Eigen::VectorXd along =
                Eigen::VectorXd::NullaryExpr(shell_.unknowns(), [&] { return number(random); });
            std::array<double, 2> energies{};
            for (const int side : {0, 1})
            {
                shell_.step((side == 0 ? -nudge : nudge) * along);
                energies[static_cast<std::size_t>(side)] = energy();
                shell_.restore(found);
            }
            sum += std::pow((energies[1] - energies[0]) / (2.0 * nudge), 2);
        }
        return std::sqrt(sum / directions);
    }
};

// Of its length at rest.
double shortest_edge(const Case& one, const Points& shape)
{
    double shortest = 1e300;
    for (const auto& row : one.mesh.triangles().rowwise())
        for (int k = 0; k < 3; ++k)
        {
            const int a = row(k), b = row((k + 1) % 3);
            shortest = std::min(shortest,
                                (shape.row(a) - shape.row(b)).norm()
                                    / (one.mesh.points().row(a) - one.mesh.points().row(b)).norm());
        }
    return shortest;
}

RigidMotion moved(const Vector3& by)
{
    RigidMotion motion;
    motion.pivot = Vector3(length, 0.5 * width, 0.0);
    motion.translation = by;
    return motion;
}

//! \returns whether it claims to have converged
bool expect_honest(const Case& one, double thickness)
{
    Answered answer(one, thickness);
    if (!answer.convergence.is_converged)
        return false;
    EXPECT_GT(shortest_edge(one, answer.positions()), 0.1)
        << one.targets.handles[0].translation.transpose();
    // Over E h: mm. A millionth of a stress of E h over the width.
    EXPECT_LT(answer.measured_gradient(), 1e-6 * width)
        << one.targets.handles[0].translation.transpose();
    return true;
}

TEST(Compression, AStripThatIsPushedTogetherBuckles)
{
    Case one = strip();
    one.targets.handles[0] = moved({-50.0, 0.0, 5.0});
    EXPECT_TRUE(expect_honest(one, 0.05 * length));
    one.targets.handles[0] = moved({-80.0, 0.0, 5.0});
    EXPECT_TRUE(expect_honest(one, 1.0));
}

TEST(Compression, WhateverClaimsToHaveConvergedIsStationaryAndNotCrushed)
{
    std::mt19937 random(45);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    constexpr int poses = 15;
    int converged = 0;
    for (int k = 0; k < poses; ++k)
    {
        Case one = strip();
        one.targets.handles[0] =
            moved({-50.0 + 35.0 * part(random), 10.0 * part(random), 20.0 * part(random)});
        one.targets.handles[0].rotation_log = rotation_log(
            Vector3(part(random), part(random), part(random)).normalized(), 0.5 * part(random));
        converged += expect_honest(one, k % 2 == 0 ? 5.0 : 1.0) ? 1 : 0;
    }
    EXPECT_EQ(converged, poses);
}

// A shallow roof between two clamped edges; its middle is moved down. The force falls after the
// limit load and rises again once the roof has snapped through.
TEST(Compression, ARoofThatIsPushedThroughSnapsAndIsNotCrushed)
{
    constexpr double radius = 2540.0, half = 0.1, thickness = 3.0;
    const auto bent = [](const Vector3& p)
    {
        const double turn = half * (2.0 * p.x() - 1.0);
        return Vector3(radius * std::sin(turn), 508.0 * p.y(), radius * std::cos(turn));
    };
    Case one{"roof", shapes::mapped(shapes::grid(20, 20, 1.0, 1.0), bent), {}, {}};
    one.constraints.energy = Energy::neumann;
    one.constraints.fixed = {region("edges", one.mesh,
                                    [](const Vector3& p)
                                    { return std::abs(p.x()) > radius * std::sin(half) - 1e-6; })};
    one.constraints.handles = {region("middle", one.mesh,
                                      [](const Vector3& p)
                                      { return std::hypot(p.x(), p.y() - 254.0) < 1e-6; })};
    one.targets.handles.resize(1);
    const auto energy_at = [&](double depth)
    {
        one.targets.handles[0] = moved({0.0, 0.0, -depth});
        Answered answer(one, thickness);
        EXPECT_TRUE(answer.convergence.is_converged) << depth;
        EXPECT_GT(shortest_edge(one, answer.positions()), 0.95) << depth;
        return answer.energy();
    };
    const auto force_at = [&](double depth)
    { return (energy_at(depth + 0.05) - energy_at(depth - 0.05)) / 0.1; };
    const double limit = force_at(8.0);
    EXPECT_LT(force_at(15.0), 0.6 * limit);
    EXPECT_GT(force_at(26.0), 2.0 * limit);
}

// The elastica between two clamps that come closer by d: four quarter waves of modulus k, with
// d / L = 2 - 2 E(k) / K(k), the force E I (4 K / L)^2 and the rise k L / K.
struct Buckled
{
    double force, rise;  //!< over E h (mm), mm
};

Buckled elastica(double shortening, double thickness)
{
    const auto shortened = [](double k)
    { return 2.0 - 2.0 * std::comp_ellint_2(k) / std::comp_ellint_1(k); };
    double low = 0.0, high = 0.9;
    for (int round = 0; round < 60; ++round)
    {
        const double middle = 0.5 * (low + high);
        (shortened(middle) * length > shortening ? high : low) = middle;
    }
    const double quarter = std::comp_ellint_1(low);
    return {width * thickness * thickness / 12.0 * std::pow(4.0 * quarter / length, 2),
            low * length / quarter};
}

TEST(Compression, BucklesAtEulersForceAndFollowsTheElastica)
{
    constexpr double thickness = 1.0;
    Case one = strip();
    one.constraints.poisson = 0.0;
    const auto pushed = [&](double by)
    {
        one.targets.handles[0] =
            moved({-by, 0.0, 0.0});  // straight: only buckling leaves the plane
        return Answered(one, thickness);
    };
    for (const double by : {1.0, 10.0, 40.0})
    {
        const Answered less = pushed(by - 0.02), more = pushed(by + 0.02), found = pushed(by);
        ASSERT_TRUE(found.convergence.is_converged) << by;
        const double force = (more.energy() - less.energy()) / 0.04;
        // The force itself shortens the strip, before it bends.
        const double pressed = force * length / width;
        const Buckled exact = elastica(by - pressed, thickness);
        EXPECT_NEAR(force, exact.force, 0.01 * exact.force) << by;
        EXPECT_NEAR(found.positions().col(2).cwiseAbs().maxCoeff(), exact.rise, 0.01 * exact.rise)
            << by;
        if (by == 1.0)
            EXPECT_NEAR(
                force,
                width * thickness * thickness / 12.0 * std::pow(2.0 * shapes::pi / length, 2),
                0.02 * force);
    }
}

TEST(Compression, ATwistedStripHasTheStiffnessOfSaintVenant)
{
    constexpr double thickness = 2.0, angle = 2.0 * shapes::pi / 180.0;
    // Two strips of one angle a length, of which the longer one has no more ends.
    std::array<double, 2> energies{};
    for (const int lengths : {1, 2})
    {
        Case one = strip(lengths);
        one.constraints.poisson = 0.0;
        one.targets.handles[0].pivot.x() = lengths * length;
        one.targets.handles[0].rotation_log = rotation_log(Vector3::UnitX(), lengths * angle);
        const Answered found(one, thickness);
        EXPECT_TRUE(found.convergence.is_converged);
        energies[static_cast<std::size_t>(lengths - 1)] = found.energy();
    }
    // 1/2 G J angle^2 / L over E h, with J = b h^3 / 3 of a thin plate and G = E / 2.
    const double exact = 0.25 * width * thickness * thickness / 3.0 * angle * angle / length;
    EXPECT_NEAR(energies[1] - energies[0], exact, 0.02 * exact);
}

}  // namespace
}  // namespace sheetmorph::surface
