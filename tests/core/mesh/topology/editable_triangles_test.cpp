// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/topology/editable_triangles.h"

#include "shapes.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace sheetmorph
{
namespace
{

int alive(const EditableTriangles& net)
{
    return static_cast<int>(std::count_if(net.triangles().begin(), net.triangles().end(),
                                          [](const auto& t) { return t.is_alive(); }));
}

// Neighbours know each other over the side they share, and every vertex one of its triangles.
void expect_consistent(const EditableTriangles& net)
{
    for (int t = 0; t < net.count(); ++t)
        for (int k = 0; k < 3 && net.triangle(t).is_alive(); ++k)
        {
            ASSERT_GE(net.corner_of(net.triangle_at(net.corner(t, k)), net.corner(t, k)), 0);
            const int other = net.across(t, k);
            if (other < 0)
                continue;
            const int back = net.corner_of(other, net.corner(t, k + 1));
            ASSERT_GE(back, 0);
            EXPECT_EQ(net.corner(other, back + 1), net.corner(t, k));
            EXPECT_EQ(net.across(other, back), t);
        }
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

std::set<int> corners_of(const EditableTriangles& net, const std::vector<int>& triangles)
{
    std::set<int> found;
    for (const int t : triangles)
        found.insert(net.triangle(t).corner.begin(), net.triangle(t).corner.end());
    return found;
}

// Whether the two ends of a side have no neighbours in common but the two over it.
bool may_collapse(const EditableTriangles& net, int t, int v, int to)
{
    const std::set<int> beside_v = corners_of(net, net.around(v));
    const std::set<int> beside_to = corners_of(net, net.fan(t, to));
    std::vector<int> common;
    std::set_intersection(beside_v.begin(), beside_v.end(), beside_to.begin(), beside_to.end(),
                          std::back_inserter(common));
    return common.size() == 4;
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
        else if (const int c = net.corner(t, k + 2), d = net.opposite(t, k); step % 3 == 1)
        {
            const auto fan = net.fan(t, c);
            if (std::none_of(fan.begin(), fan.end(),
                             [&](int other) { return net.corner_of(other, d) >= 0; }))
                net.flip(t, k);
        }
        else if (const int inner = inner_neighbour(net, t); inner >= 0)
        {
            const int v = net.corner(t, inner), to = net.corner(t, inner + 1);
            if (!may_collapse(net, t, v, to))
                continue;
            net.collapse(v, to);
            EXPECT_EQ(alive(net), before - 2);
            EXPECT_EQ(net.triangle_at(v), -1);
        }
        expect_consistent(net);
    }
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
}  // namespace sheetmorph
