// SPDX-License-Identifier: LGPL-2.1-or-later
// Sze, Liu and Lo (2004), Popular benchmark problems for geometric nonlinear analysis of shells,
// Finite Elements in Analysis and Design 40: displacements of two points of a shell under a load.
#include "surface/steel/loaded_shell.h"

#include <gtest/gtest.h>

namespace sheetmorph::surface
{
namespace
{

using namespace cases;

//! What a row of the reference's table has, at a part of the whole load.
struct Row
{
    double load, first, second;
};

//! A point of a shell, the axis it is watched along, and which way counts as positive.
struct Watched
{
    int vertex, axis;
    double sign;
};

constexpr double rounding = 0.5e-3;  // of the table

void expect_near_table(LoadedShell& shell, const std::array<Watched, 2>& watched,
                       const std::vector<Row>& table, double allowed)
{
    for (const Row& row : table)
    {
        EXPECT_TRUE(shell.carry(row.load)) << row.load;
        const std::array<double, 2> wanted = {row.first, row.second};
        for (std::size_t k = 0; k < 2; ++k)
            EXPECT_NEAR(watched[k].sign * shell.moved(watched[k].vertex, watched[k].axis),
                        wanted[k], allowed * wanted[k] + rounding)
                << "load " << row.load << ", point " << k;
    }
}

bool is_zero(double x)
{
    return std::abs(x) < 1e-9;
}

// 3.1, 16 x 4: 10 x 1 x 0.1, an end shear of 4.
TEST(ShellBenchmarks, ACantileverUnderEndShearIsWithinHalfAPercent)
{
    LoadedShell shell(shapes::grid(16, 4, 10.0, 1.0), {1.2e6, 0.0, 0.1},
                      {[](const Vector3& p) { return is_zero(p.x()); }, {}, {}});
    for (int j = 0; j <= 4; ++j)
        shell.pull(vertex_near(shell.rest(), {10.0, 0.25 * j, 0.0}), 2, j % 4 == 0 ? 0.5 : 1.0);
    const int tip = vertex_near(shell.rest(), {10.0, 0.5, 0.0});
    expect_near_table(shell, {{{tip, 0, -1.0}, {tip, 2, 1.0}}},
                      {{0.10, 0.103, 1.309},
                       {0.25, 0.563, 3.015},
                       {0.50, 1.604, 4.933},
                       {0.75, 2.541, 6.031},
                       {1.00, 3.286, 6.698}},
                      5e-3);
}

// 3.3, 16 x 128: radii 6 and 10, 0.03 thick, a line force of 0.8 a length lifts one side of the
// slit. The slit is opened by a thousandth of a degree: its sides are told apart by their places.
TEST(ShellBenchmarks, ASlitPlateIsWithinOneAndAHalfPercent)
{
    constexpr int radial = 16, around = 128;
    const auto bent = [](const Vector3& p)
    {
        const double angle = 2.0 * shapes::pi * (1.0 - 1e-6) * p.x();
        return Vector3((6.0 + p.y()) * std::cos(angle), (6.0 + p.y()) * std::sin(angle), 0.0);
    };
    LoadedShell shell(shapes::mapped(shapes::grid(around, radial, 1.0, 4.0), bent),
                      {21e6, 0.0, 0.03},
                      {[](const Vector3& p) { return p.x() > 0.0 && p.y() == 0.0; }, {}, {}});
    std::vector<int> lifted;
    for (int j = 0; j <= radial; ++j)
        lifted.push_back(vertex_near(shell.rest(), bent({1.0, 4.0 * j / radial, 0.0})));
    for (int j = 0; j <= radial; ++j)
        shell.pull(lifted[static_cast<std::size_t>(j)], 2,
                   3.2 / radial * (j % radial == 0 ? 0.5 : 1.0));
    expect_near_table(shell, {{{lifted.front(), 2, 1.0}, {lifted.back(), 2, 1.0}}},
                      {{0.05, 2.455, 3.370},
                       {0.20, 6.725, 9.160},
                       {0.50, 10.468, 13.768},
                       {1.00, 13.891, 17.528}},
                      1.5e-2);
}

// 3.4, a quarter of it, 16 x 16: radius 10, a hole of 18 degrees, 0.04 thick, forces of 400 pull
// and push in turn at the rim.
TEST(ShellBenchmarks, AHemisphereIsWithinThreePercent)
{
    const auto bent = [](const Vector3& p)
    {
        const double turn = 0.5 * shapes::pi * p.x(), up = 0.4 * shapes::pi * p.y();
        return Vector3(10.0 * std::cos(up) * std::cos(turn), 10.0 * std::cos(up) * std::sin(turn),
                       10.0 * std::sin(up));
    };
    const mesh::TriangleMesh mesh = shapes::mapped(shapes::grid(16, 16, 1.0, 1.0), bent);
    const int pulled = vertex_near(mesh, {10.0, 0.0, 0.0});
    const int pushed = vertex_near(mesh, {0.0, 10.0, 0.0});
    ShellSupport support;
    support.symmetries = {{0, [](const Vector3& p) { return is_zero(p.x()); }},
                          {1, [](const Vector3& p) { return is_zero(p.y()); }}};
    support.held = {{pulled, 2}};
    LoadedShell shell(mesh, {6.825e7, 0.3, 0.04}, support);
    shell.pull(pulled, 0, 200.0);
    shell.pull(pushed, 1, -200.0);
    expect_near_table(shell, {{{pulled, 0, 1.0}, {pushed, 1, -1.0}}},
                      {{0.05, 0.855, 0.955},
                       {0.10, 1.499, 1.840},
                       {0.20, 2.321, 3.261},
                       {0.40, 3.158, 5.196},
                       {0.60, 3.598, 6.497},
                       {0.80, 3.875, 7.448},
                       {1.00, 4.067, 8.178}},
                      3e-2);
}

// 3.5, an eighth of it, 32 around and 16 along: radius 4.953, length 10.35, 0.094 thick, two forces
// of 40,000 pull at its middle. It snaps at about half of them.
TEST(ShellBenchmarks, APulledOutCylinderIsWithinOnePercentBeforeAndAfterItSnaps)
{
    const auto bent = [](const Vector3& p)
    {
        const double turn = 0.5 * shapes::pi * p.x();
        return Vector3(4.953 * std::cos(turn), 5.175 * p.y(), 4.953 * std::sin(turn));
    };
    const mesh::TriangleMesh mesh = shapes::mapped(shapes::grid(32, 16, 1.0, 1.0), bent);
    ShellSupport support;
    support.symmetries = {{0, [](const Vector3& p) { return is_zero(p.x()); }},
                          {1, [](const Vector3& p) { return is_zero(p.y()); }},
                          {2, [](const Vector3& p) { return is_zero(p.z()); }}};
    LoadedShell shell(mesh, {10.5e6, 0.3125, 0.094}, support);
    const int pulled = vertex_near(mesh, {0.0, 0.0, 4.953});
    const int side = vertex_near(mesh, {4.953, 0.0, 0.0});
    shell.pull(pulled, 2, 1e4);
    expect_near_table(shell, {{{pulled, 2, 1.0}, {side, 0, -1.0}}},
                      {{0.025, 0.819, 0.864},
                       {0.05, 1.260, 1.471},
                       {0.10, 1.707, 2.217},
                       {0.20, 2.079, 2.904},
                       {0.30, 2.257, 3.227},
                       {0.40, 2.376, 3.443},
                       {0.50, 2.473, 3.653},
                       {0.60, 2.618, 4.274},
                       {0.80, 2.710, 4.455},
                       {1.00, 2.768, 4.551}},
                      1e-2);
}

// 3.7, a quarter of it, 10 x 10: a shallow roof of radius 2540, 508 long and 0.2 radians wide,
// 12.7 thick, hinged along its straight edges. Up to 2.2 kN in its middle it has a shape near by.
TEST(ShellBenchmarks, AShallowRoofCarriesItsLimitLoadAndNoMore)
{
    constexpr double radius = 2540.0;
    const auto bent = [](const Vector3& p)
    {
        const double turn = 0.1 * p.x();
        return Vector3(radius * std::sin(turn), 254.0 * p.y(), radius * std::cos(turn));
    };
    const mesh::TriangleMesh mesh = shapes::mapped(shapes::grid(10, 10, 1.0, 1.0), bent);
    ShellSupport support;
    support.symmetries = {{0, [](const Vector3& p) { return is_zero(p.x()); }},
                          {1, [](const Vector3& p) { return is_zero(p.y()); }}};
    for (int k = 0; k <= 10; ++k)
    {
        const int hinge =
            vertex_near(mesh, {radius * std::sin(0.1), 25.4 * k, radius * std::cos(0.1)});
        for (int axis = 0; axis < 3; ++axis)
            support.held.emplace_back(hinge, axis);
    }
    LoadedShell shell(mesh, {3102.75, 0.3, 12.7}, support);
    const int middle = vertex_near(mesh, {0.0, 0.0, radius});
    shell.pull(middle, 2, -0.25 * 1000.0);
    for (const double load : {1.0, 1.6, 2.0, 2.1})
        EXPECT_TRUE(shell.carry(load)) << load;
    EXPECT_NEAR(-shell.moved(middle, 2), 9.5, 2.0);
    EXPECT_FALSE(shell.carry(2.35));
    // An answer beyond it is the snapped roof.
    if (shell.carry(3.0))
        EXPECT_GT(-shell.moved(middle, 2), 25.0);
    EXPECT_GT(shell.shortest_edge(), 0.95);
}

}  // namespace
}  // namespace sheetmorph::surface
