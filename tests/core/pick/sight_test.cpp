// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/pick/sight.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/search/triangle_queries.h"
#include "cameras.h"
#include "shapes.h"

#include <gmock/gmock.h>

#include <numeric>

namespace sheetmorph::pick
{

using namespace mesh;

namespace
{

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

RigidMotion turn(const Vector3& rotation_log, const Vector3& translation)
{
    RigidMotion motion;
    motion.rotation_log = rotation_log;
    motion.translation = translation;
    return motion;
}

TriangleMesh scene(int which)
{
    const auto tilted = turn({0.7, 0.4, 0.1}, {1, -2, 3});
    if (which == 0)
        return shapes::moved(shapes::torus(30, 16, 20, 9), tilted);
    if (which == 1)
        return shapes::moved(shapes::box(6, {30, 20, 10}), tilted);
    return shapes::jittered(shapes::grid(20, 20, 40, 40), 0.4, 7);
}

std::vector<Screen> screens()
{
    return {cameras::parallel_from_above(100.0), cameras::perspective_from_above(100.0)};
}

VertexIds all_of(const TriangleMesh& mesh)
{
    VertexIds all(static_cast<std::size_t>(mesh.vertex_count()));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

ScreenOutline wavy()
{
    ScreenPoints corners(90, 2);
    for (int k = 0; k < 90; ++k)
    {
        const double angle = 2.0 * shapes::pi * k / 90.0;
        const double radius = 70.0 + 30.0 * std::sin(5.0 * angle);
        corners.row(k) << 390.0 + radius * std::cos(angle), 310.0 + radius * std::sin(angle);
    }
    return ScreenOutline(corners);
}

// Whether a triangle that does not touch the vertex lies between it and the eye, by the ray.
bool is_hidden(const Vector3& vertex, const Vector3& to_eye, const TriangleMesh& mesh)
{
    const TriangleRay ray(vertex, to_eye.normalized(), 1000.0);
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        TriangleCorners corners;
        for (int k = 0; k < 3; ++k)
            corners[k] = mesh.points().row(mesh.triangles()(t, k)).transpose();
        if (Hit hit; ray.meets(corners, hit) && hit.distance > 1e-3)
            return true;
    }
    return false;
}

}  // namespace

TEST(Sight, AnOutlineHoldsTheVerticesWhosePictureItHolds)
{
    for (int which = 0; which < 3; ++which)
        for (const Screen& screen : screens())
        {
            const TriangleMesh mesh = scene(which);
            const ScreenOutline outline = wavy();
            VertexIds expected;
            for (int i = 0; i < mesh.vertex_count(); ++i)
                if (const Vector3 seen = screen.seen(mesh.points().row(i));
                    outline.contains(seen.x(), seen.y()))
                    expected.push_back(i);
            EXPECT_EQ(vertices_inside(PickingTree(mesh), screen, outline), expected);
            EXPECT_GT(expected.size(), 10u);
            EXPECT_LT(expected.size(), static_cast<std::size_t>(mesh.vertex_count()));
        }
}

TEST(Sight, VisibleIsWhatARayReachesFromTheEye)
{
    for (int which = 0; which < 3; ++which)
        for (const bool is_parallel : {true, false})
        {
            const TriangleMesh mesh = scene(which);
            const PickingTree tree(mesh);
            VertexIds expected;
            for (int i = 0; i < mesh.vertex_count(); ++i)
            {
                const Vector3 place = mesh.points().row(i);
                const Vector3 to_eye =
                    is_parallel ? Vector3(0, 0, 1) : Vector3(Vector3(0, 0, 100) - place);
                if (!is_hidden(place, to_eye, mesh))
                    expected.push_back(i);
            }
            const VertexIds visible =
                visible_vertices(tree, all_of(mesh), screens()[is_parallel ? 0 : 1], {&tree});
            EXPECT_EQ(visible, expected) << which << is_parallel;
        }
}

TEST(Sight, OtherShapesHideAndWhatTouchesDoesNot)
{
    const TriangleMesh sheet = shapes::grid(10, 10, 40, 40);
    const PickingTree tree(sheet);
    const PickingTree above(
        shapes::moved(shapes::grid(3, 3, 41, 20), turn(Vector3::Zero(), {-0.5, -0.5, 2})));
    const PickingTree touching(shapes::grid(7, 7, 40, 40));
    for (const Screen& screen : screens())
    {
        EXPECT_EQ(visible_vertices(tree, all_of(sheet), screen, {&tree, &touching}), all_of(sheet));
        const VertexIds rest = visible_vertices(tree, all_of(sheet), screen, {&tree, &above});
        EXPECT_THAT(rest, SizeIs(121 - 5 * 11));
        EXPECT_GT(sheet.points()(rest.front(), 1), 19.5);
    }
}

TEST(Sight, OneLargeTriangleHidesManyVertices)
{
    const TriangleMesh sheet = shapes::grid(30, 30, 40, 40);
    Points corners(3, 3);
    corners << -500, -480, 5, 620, -30, 5, 3, 700, 5;
    Triangles triangle(1, 3);
    triangle << 0, 1, 2;
    const PickingTree tree(sheet);
    const PickingTree roof(TriangleMesh(corners, triangle));
    for (const Screen& screen : screens())
        EXPECT_THAT(visible_vertices(tree, all_of(sheet), screen, {&roof}), IsEmpty());
}

TEST(Sight, WhatLiesBehindTheEyeIsNotSeenAndHidesNothing)
{
    const PickingTree tree(shapes::grid(2, 2, 10, 10));
    const PickingTree behind(
        shapes::moved(shapes::grid(1, 1, 90, 90), turn(Vector3::Zero(), {-40, -40, 120})));
    const Screen screen = cameras::perspective_from_above(100.0);
    EXPECT_THAT(visible_vertices(tree, {4, 4, 8}, screen, {&behind}), ElementsAre(4, 8));
    EXPECT_THAT(visible_vertices(behind, {0, 1, 2, 3}, screen, {&tree}), IsEmpty());
    EXPECT_THAT(vertices_inside(behind, screen, wavy()), IsEmpty());
}

TEST(Sight, VerticesThatDoNotExistAreNamed)
{
    const PickingTree tree(shapes::grid(2, 2, 10, 10));
    EXPECT_THROW(visible_vertices(tree, {3, 99}, screens()[0], {}), InvalidInput);
    EXPECT_THAT(visible_vertices(tree, {3}, screens()[0], {}), ElementsAre(3));
}

}  // namespace sheetmorph::pick
