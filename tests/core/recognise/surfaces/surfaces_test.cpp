// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/surfaces/surfaces.h"

#include "shapes/solids.h"
#include "shapes/variations.h"

#include <cmath>
#include <gtest/gtest.h>

namespace sheetmorph::recognise
{

using namespace fitting;

namespace
{

std::vector<Surface> surfaces_of(const mesh::TriangleMesh& mesh)
{
    std::vector<Surface> found;
    for (const SurfaceRegion& region : find_surfaces(FacetGraph(mesh, 1e-7), FeatureTolerances()))
        found.push_back(region.surface);
    return found;
}

// A sheet along x, bent by 90 degrees around a radius of 6 mm from x = 40 on.
Vector3 bent(const Vector3& p)
{
    constexpr double radius = 6.0;
    const double arc = std::clamp((p.x() - 40.0) / radius, 0.0, M_PI / 2.0);
    const double beyond = std::max(0.0, p.x() - 40.0 - radius * M_PI / 2.0);
    return {std::min(p.x(), 40.0) + radius * std::sin(arc), p.y(),
            radius * (1.0 - std::cos(arc)) + beyond};
}

TEST(Surfaces, ABentSheetIsTwoPlanesAndACylinder)
{
    const auto found = surfaces_of(shapes::mapped(shapes::grid(100, 20, 100.0, 60.0), bent));
    ASSERT_EQ(found.size(), 3u);
    int planes = 0;
    for (const Surface& surface : found)
        if (surface.kind == Surface::Kind::cylinder)
        {
            EXPECT_NEAR(surface.radius, 6.0, 1e-9);
            EXPECT_NEAR(std::abs(surface.axis.y()), 1.0, 1e-12);
            EXPECT_NEAR(surface.point.z(), 6.0, 1e-9);
        }
        else
            planes += surface.kind == Surface::Kind::plane;
    EXPECT_EQ(planes, 2);
}

TEST(Surfaces, AConeIsExactHoweverSlenderAndFine)
{
    for (const double slope : {0.2, 0.5, 1.0})
    {
        const auto cone = shapes::mapped(shapes::cylinder(48, 12, 1.0, 30.0),
                                         [=](const Vector3& p)
                                         {
                                             const double radius = 10.0 + slope * p.z();
                                             return Vector3(radius * p.x(), radius * p.y(), p.z());
                                         });
        const auto found = surfaces_of(cone);
        ASSERT_EQ(found.size(), 1u) << slope;
        EXPECT_EQ(found[0].kind, Surface::Kind::cone);
        EXPECT_NEAR(found[0].angle, std::atan(slope), 1e-9);
        EXPECT_NEAR((found[0].point - Vector3(0.0, 0.0, -10.0 / slope)).norm(), 0.0, 1e-6);
    }
}

TEST(Surfaces, ASphereAndABoxAreWhatTheyAre)
{
    const auto sphere = surfaces_of(shapes::sphere(3, 30.0));
    ASSERT_EQ(sphere.size(), 1u);
    EXPECT_EQ(sphere[0].kind, Surface::Kind::sphere);
    EXPECT_NEAR(sphere[0].radius, 30.0, 1e-9);
    const auto box = surfaces_of(shapes::box(6, Vector3(30.0, 40.0, 50.0)));
    EXPECT_EQ(box.size(), 6u);
    for (const Surface& side : box)
        EXPECT_EQ(side.kind, Surface::Kind::plane);
}

TEST(Surfaces, OfASaddleTheyTellThatTheyDidNotSettle)
{
    const mesh::TriangleMesh saddle =
        shapes::mapped(shapes::grid(60, 40, 100.0, 60.0), [](const Vector3& p)
                       { return Vector3(p.x(), p.y(), (p.x() * p.x() - p.y() * p.y()) / 200.0); });
    int lost = 0;
    for (const SurfaceRegion& region : find_surfaces(FacetGraph(saddle, 1e-7), {}))
    {
        const std::string told = region.convergence.sentence();
        EXPECT_EQ(told.empty(), region.convergence.is_converged);
        if (told.empty())
            continue;
        EXPECT_EQ(told.find("the triangles of a surface did not converge in 8 iterations"), 0U);
        EXPECT_GT(region.convergence.miss, 0.0);
        ++lost;
    }
    EXPECT_GT(lost, 0);
    for (const SurfaceRegion& region :
         find_surfaces(FacetGraph(shapes::box(6, Vector3(30.0, 40.0, 50.0)), 1e-7), {}))
        EXPECT_TRUE(region.convergence.is_converged);
}

TEST(Surfaces, AMeasuredTubeIsOneCylinder)
{
    for (unsigned seed = 0; seed < 3; ++seed)
    {
        const auto tube = shapes::scattered(shapes::cylinder(48, 24, 40.0, 120.0), 0.15, seed);
        const auto found = surfaces_of(tube);
        ASSERT_EQ(found.size(), 1u) << seed;
        EXPECT_EQ(found[0].kind, Surface::Kind::cylinder);
        EXPECT_NEAR(found[0].radius, 40.0, 0.1);
    }
}

}  // namespace

}  // namespace sheetmorph::recognise
