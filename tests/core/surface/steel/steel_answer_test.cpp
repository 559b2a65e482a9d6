// SPDX-License-Identifier: LGPL-2.1-or-later
// A part as a sheet of steel, against exact curves.
#include "sheetmorph/base/errors.h"
#include "sheetmorph/surface/solve/prepared_surface.h"
#include "surface/all_cases.h"
#include "surface/free_strip.h"

#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::surface
{
namespace
{

using namespace cases;

constexpr double length = 100.0;
constexpr int along = 32, across = 4;

int vertex(int i, int j)
{
    return i * (across + 1) + j;
}

//! A flat strip, held at one end and moved at the other; a hundredth of its length thick.
Case bar(bool is_regular, double poisson)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> shift(-0.3, 0.3);
    const double step = length / along;
    Points points((along + 1) * (across + 1), 3);
    for (int i = 0; i <= along; ++i)
        for (int j = 0; j <= across; ++j)
        {
            const bool is_inner = !is_regular && i > 0 && i < along && j > 0 && j < across;
            points.row(vertex(i, j)) << step * (i + (is_inner ? shift(random) : 0.0)),
                step * (j + (is_inner ? shift(random) : 0.0)), 0.0;
        }
    Triangles triangles(2 * along * across, 3);
    for (int i = 0, row = 0; i < along; ++i)
        for (int j = 0; j < across; ++j)
        {
            const int a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1);
            const int d = vertex(i, j + 1);
            const bool is_falling = !is_regular && random() % 2 == 0;
            triangles.row(row++) << a, b, (is_falling ? d : c);
            triangles.row(row++) << (is_falling ? b : a), c, d;
        }
    Case one{is_regular ? "regular" : "irregular", mesh::TriangleMesh(points, triangles), {}, {}};
    one.constraints.energy = Energy::steel;
    one.constraints.thickness = length / 100.0;
    one.constraints.poisson = poisson;
    one.constraints.fixed = {
        region("root", one.mesh, [](const Vector3& p) { return p.x() < 1e-9; })};
    one.constraints.handles = {
        region("tip", one.mesh, [](const Vector3& p) { return p.x() > length - 1e-9; })};
    one.targets.handles.resize(1);
    return one;
}

// Where the middle line is and how it slopes, by arc length.
struct Curve
{
    std::vector<Vector3> places;
    std::vector<double> slopes;

    Vector3 at_length(double s) const
    {
        const double place = s / length * static_cast<double>(places.size() - 1);
        const auto k = std::min(static_cast<std::size_t>(place), places.size() - 2);
        const double part = place - static_cast<double>(k);
        return (1.0 - part) * places[k] + part * places[k + 1];
    }
};

//! theta'' = -load cos theta / length^2 from a clamped end: the elastica under end shear.
Curve integrated(double load, double first_curvature, int steps)
{
    Curve curve{{Vector3::Zero()}, {0.0}};
    double slope = 0.0, curvature = first_curvature;
    const double step = length / steps, factor = load / (length * length);
    for (int k = 0; k < steps; ++k)
    {
        // Midpoint rule, exact to a millionth with so many steps.
        const double middle_slope = slope + 0.5 * step * curvature;
        const double middle_curvature = curvature - 0.5 * step * factor * std::cos(slope);
        curve.places.emplace_back(
            curve.places.back()
            + step * Vector3(std::cos(middle_slope), 0.0, std::sin(middle_slope)));
        slope += step * middle_curvature;
        curvature -= step * factor * std::cos(middle_slope);
        curve.slopes.push_back(slope);
    }
    curve.slopes.push_back(curvature);  // at the free end, after all slopes
    return curve;
}

Curve elastica(double load)
{
    double low = 0.0, high = load / length;
    for (int k = 0; k < 60; ++k)
    {
        const double middle = 0.5 * (low + high);
        (integrated(load, middle, 4000).slopes.back() > 0.0 ? high : low) = middle;
    }
    Curve curve = integrated(load, 0.5 * (low + high), 4000);
    curve.slopes.pop_back();
    return curve;
}

Curve rolled(double degrees)
{
    const double angle = degrees * shapes::pi / 180.0;
    Curve curve;
    for (int k = 0; k <= 4000; ++k)
    {
        const double slope = angle * k / 4000.0;
        curve.slopes.push_back(slope);
        curve.places.emplace_back(length / angle
                                  * Vector3(std::sin(slope), 0.0, 1.0 - std::cos(slope)));
    }
    return curve;
}

void move_tip(Case& one, const Curve& curve)
{
    RigidMotion& tip = one.targets.handles[0];
    tip.pivot = Vector3(length, 0.0, 0.0);
    tip.translation = curve.places.back() - tip.pivot;
    tip.rotation_log = rotation_log(Vector3(0.0, -1.0, 0.0), curve.slopes.back());
}

// Of the length.
double farthest_off(const Case& one, const Points& shape, const Curve& curve)
{
    double worst = 0.0;
    for (int i = 0; i < one.mesh.vertex_count(); ++i)
    {
        Vector3 exact = curve.at_length(one.mesh.points()(i, 0));
        exact.y() = one.mesh.points()(i, 1);
        worst = std::max(worst, (shape.row(i).transpose() - exact).norm());
    }
    return worst / length;
}

TEST(SteelAnswer, RollsUpAsAnExactCircle)
{
    for (const bool is_regular : {true, false})
        for (const double poisson : {0.0, 0.3})
            for (const double degrees : {90.0, 180.0, 350.0})
            {
                Case one = bar(is_regular, poisson);
                move_tip(one, rolled(degrees));
                const Deformation found = solve(one);
                EXPECT_TRUE(found.convergence.is_converged) << one << degrees;
                EXPECT_LT(farthest_off(one, found.positions, rolled(degrees)),
                          degrees > 300.0 ? 1.5e-3 : 1e-3)
                    << one << " " << degrees << " " << poisson;
            }
}

// Sze, Liu and Lo (2004), 3.1: tip at 3.286 and 6.698 tenths under a force of 4 E I / L^2.
TEST(SteelAnswer, FollowsTheElasticaUnderAnEndForce)
{
    const Curve exact = elastica(4.0);
    EXPECT_NEAR(1.0 - exact.places.back().x() / length, 0.3286, 5e-4);
    EXPECT_NEAR(exact.places.back().z() / length, 0.6698, 5e-4);
    for (const bool is_regular : {true, false})
    {
        Case one = bar(is_regular, 0.0);
        move_tip(one, exact);
        EXPECT_LT(farthest_off(one, solve(one).positions, exact), 1e-3) << one;
    }
}

double energy_of(const Case& one, Energy start)
{
    SurfaceConstraints linear = one.constraints;
    linear.energy = start;
    const Deformation from = SurfaceDeformer(one.mesh, linear).deform(one.targets);
    const PreparedSurface part(one.mesh, one.constraints, {}, nullptr);
    const PlacementInput placement = part.placement();
    const BodyMotions bodies = known_body_motions(placement, one.targets);
    const SteelAnswer::Shape shape =
        part.steel->solve({placement, one.targets, bodies, from.positions, from.rotation_logs}, {});
    EXPECT_TRUE(shape.convergence.is_converged);
    return shape.energy;
}

TEST(SteelAnswer, PullsBackAsTheElasticaDoes)
{
    const Curve exact = elastica(4.0);
    for (const bool is_regular : {true, false})
    {
        Case one = bar(is_regular, 0.0);
        move_tip(one, exact);
        one.constraints.handles[0].is_rotation_free = true;
        one.targets.handles[0].rotation_log.setZero();
        const double nudge = 1e-3 * length;
        const double width = length * across / along;
        const double thickness = one.constraints.thickness;
        // Energies are over E h, the force is 4 E I / L^2.
        const double force = 4.0 * width * std::pow(thickness, 2) / 12.0 / (length * length);
        for (const int axis : {0, 2})
        {
            Case forth = one, back = one;
            forth.targets.handles[0].translation(axis) += nudge;
            back.targets.handles[0].translation(axis) -= nudge;
            const double reaction =
                (energy_of(forth, Energy::neumann) - energy_of(back, Energy::neumann))
                / (2.0 * nudge);
            EXPECT_NEAR(reaction, axis == 2 ? force : 0.0, 0.01 * force) << one << axis;
        }
    }
}

TEST(SteelAnswer, EndsInTheSameEnergyFromWhereverItStarts)
{
    for (const double degrees : {90.0, 180.0})
    {
        Case one = bar(false, 0.3);
        move_tip(one, rolled(degrees));
        const double from_neumann = energy_of(one, Energy::neumann);
        EXPECT_NEAR(energy_of(one, Energy::natural), from_neumann, 1e-6 * from_neumann);
    }
}

std::vector<Case> steel_cases()
{
    std::vector<Case> found = {flat_plate(), bent_plate(), strip_with_holes(), graded_sheet()};
    for (Case& one : found)
        one.constraints.energy = Energy::steel;
    return with_free_features(found);
}

TEST(SteelAnswer, KeepsFeaturesRigidAndMeetsHandlesToTheBit)
{
    for (const Case& one : steel_cases())
    {
        const Deformation shape = solve(one);
        EXPECT_TRUE(shape.convergence.is_converged) << one;
        for (std::size_t k = 0; k < one.constraints.features.size(); ++k)
            for (const int v : one.constraints.features[k].vertices)
                EXPECT_LT((shape.positions.row(v).transpose()
                           - shape.features[k].apply(Vector3(one.mesh.points().row(v))))
                              .norm(),
                          1e-10)
                    << one;
        for (const int v : one.constraints.handles[0].vertices)
            EXPECT_EQ(Vector3(shape.positions.row(v)),
                      one.targets.handles[0].apply(Vector3(one.mesh.points().row(v))))
                << one;
        for (const int v : one.constraints.fixed[0].vertices)
            EXPECT_EQ(Vector3(shape.positions.row(v)), Vector3(one.mesh.points().row(v))) << one;
    }
}

TEST(SteelAnswer, LeavesRestAndRigidMotionsAlone)
{
    for (Case one : steel_cases())
    {
        one.targets.handles = {RigidMotion{}};
        EXPECT_EQ(solve(one).positions, one.mesh.points()) << one;
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

TEST(SteelAnswer, CanBeCancelled)
{
    Case one = bar(true, 0.3);
    move_tip(one, rolled(180.0));
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    const Progress progress([](double, const std::string&) { return false; });
    EXPECT_THROW(deformer.deform(one.targets, Exactness::exact, progress), Cancelled);
}

TEST(SteelAnswer, APointOnATriangleIsMet)
{
    Case one = bar(true, 0.3);
    one.constraints.points = {{"dent", 5 * 2 * across, Vector3(0.2, 0.3, 0.5)}};
    const Vector3 rest = [&]
    {
        Vector3 sum = Vector3::Zero();
        for (int c = 0; c < 3; ++c)
            sum += one.constraints.points[0].barycentric(c)
                   * one.mesh.points()
                         .row(one.mesh.triangles()(one.constraints.points[0].triangle, c))
                         .transpose();
        return sum;
    }();
    one.targets.points = {{rest + Vector3(0.0, 0.0, 4.0), Vector3::Zero()}};
    const Deformation shape = solve(one);
    EXPECT_TRUE(shape.convergence.is_converged);
    Vector3 place = Vector3::Zero();
    for (int c = 0; c < 3; ++c)
        place += one.constraints.points[0].barycentric(c)
                 * shape.positions.row(one.mesh.triangles()(one.constraints.points[0].triangle, c))
                       .transpose();
    EXPECT_LT((place - one.targets.points[0].position).norm(), 1e-9);
}

}  // namespace
}  // namespace sheetmorph::surface
