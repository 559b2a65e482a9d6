// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/topology/editable_triangles.h"

#include "sheetmorph/mesh/topology/orientation.h"
#include "shapes.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::mesh
{
namespace
{

int alive(const EditableTriangles& net)
{
    return static_cast<int>(std::count_if(net.triangles().begin(), net.triangles().end(),
                                          [](const auto& t) { return t.is_alive(); }));
}

// Around a vertex that no border passes; -1 if there is none.
int inner_neighbour(const EditableTriangles& net, int t)
{
    for (int k = 0; k < 3; ++k)
        if (net.across(net.fan(t, net.corner(t, k)).back(),
                       net.corner_of(net.fan(t, net.corner(t, k)).back(), net.corner(t, k)) + 2)
            == t)
            return k;
    return -1;
}

TEST(EditableTriangles, StayASurfaceWhateverIsSplitFlippedAndCollapsed)
{
    EditableTriangles net(shapes::grid(6, 5, 6.0, 5.0), {});
    std::mt19937 random(3);
    for (int step = 0; step < 400; ++step)
    {
        const int t = static_cast<int>(random() % static_cast<unsigned>(net.count()));
        const int k = static_cast<int>(random() % 3U), before = alive(net);
        if (!net.triangle(t).is_alive() || !net.is_free_side(t, k))
            continue;
        if (step % 3 == 0)
        {
            net.split(t, k);
            EXPECT_EQ(alive(net), before + 2);
        }
        else if (step % 3 == 1)
        {
            if (net.may_flip(t, k))
                net.flip(t, k);
        }
        else if (const int inner = inner_neighbour(net, t); inner >= 0)
        {
            const int v = net.corner(t, inner), to = net.corner(t, inner + 1);
            if (!net.may_collapse(t, inner))
                continue;
            net.collapse(v, to);
            EXPECT_EQ(alive(net), before - 2);
            EXPECT_EQ(net.triangle_at(v), -1);
        }
        EXPECT_EQ(net.fault(), "");
    }
}

// Triangles over few vertices, so that many are doubled, many sides have three, and many pieces are
// closed over three or four triangles. Neighbours face the same way, as WorkingMesh has them.
TriangleMesh tangle(std::mt19937& random)
{
    const auto pick = [&](int count)
    { return static_cast<int>(random() % static_cast<unsigned>(count)); };
    const int vertices = 4 + pick(6);
    Triangles triangles(4 + pick(30), 3);
    for (int t = 0; t < triangles.rows(); ++t)
        do
            triangles.row(t) << pick(vertices), pick(vertices), pick(vertices);
        while (triangles(t, 0) == triangles(t, 1) || triangles(t, 1) == triangles(t, 2)
               || triangles(t, 2) == triangles(t, 0));
    const TriangleMesh mesh(Points::Random(vertices, 3), triangles);
    return oriented(mesh, consistent_orientation(mesh, EdgeTable(mesh)));
}

// The two ends of a free side whose triangles all go round the first of them.
bool is_whole_fan(const EditableTriangles& net, int t, int v)
{
    const auto is_at = [&](const auto& one)
    { return std::count(one.corner.begin(), one.corner.end(), v) > 0; };
    const auto at = std::count_if(net.triangles().begin(), net.triangles().end(), is_at);
    const std::vector<int> fan = net.fan(t, v);
    const int last = fan.back();
    return at == static_cast<int>(fan.size()) && fan.size() > 2
           && std::all_of(fan.begin(), fan.end(),
                          [&](int one) { return net.across(one, net.corner_of(one, v)) >= 0; })
           && net.across(last, net.corner_of(last, v) + 2) >= 0;
}

TEST(EditableTriangles, StaySoundWhereTheyAreNoSurface)
{
    std::mt19937 random(11);
    int flips = 0, collapses = 0;
    for (int round = 0; round < 2000; ++round)
    {
        EditableTriangles net(tangle(random), {});
        ASSERT_EQ(net.fault(), "");
        for (int step = 0; step < 30; ++step)
        {
            const int t = static_cast<int>(random() % static_cast<unsigned>(net.count()));
            const int k = static_cast<int>(random() % 3U), what = static_cast<int>(random() % 4U);
            if (!net.triangle(t).is_alive() || !net.is_free_side(t, k))
                continue;
            if (what == 0)
                net.split(t, k);
            else if (what == 1 && net.may_flip(t, k))
            {
                net.flip(t, k);
                ++flips;
            }
            else if (what > 1 && is_whole_fan(net, t, net.corner(t, k)) && net.may_collapse(t, k))
            {
                const int before = alive(net);
                net.collapse(net.corner(t, k), net.corner(t, k + 1));
                ASSERT_EQ(alive(net), before - 2);
                ++collapses;
            }
            ASSERT_EQ(net.fault(), "") << "round " << round << ", step " << step;
        }
    }
    EXPECT_GT(flips, 1000);
    EXPECT_GT(collapses, 100);
}

TEST(EditableTriangles, AreNoNeighboursOverACut)
{
    const TriangleMesh box = shapes::box(1, Vector3(1, 1, 1));
    const int a = box.triangles()(0, 0), b = box.triangles()(0, 1);
    const EditableTriangles whole(box, {}), cut(box, {std::pair(std::min(a, b), std::max(a, b))});
    EXPECT_TRUE(whole.is_free_side(0, 0));
    EXPECT_FALSE(cut.is_free_side(0, 0));
    EXPECT_EQ(whole.around(a).size(), cut.fan(0, a).size());
    EXPECT_FALSE(whole.has_clash());
}

TEST(EditableTriangles, TellWhereTheyAreNoSurface)
{
    Points points(4, 3);
    points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    Triangles triangles(2, 3);
    triangles << 0, 1, 2, 0, 1, 3;
    const EditableTriangles net(TriangleMesh(points, triangles), {});
    EXPECT_TRUE(net.has_clash());
    EXPECT_FALSE(net.is_free_side(0, 0));
}

}  // namespace
}  // namespace sheetmorph::mesh
