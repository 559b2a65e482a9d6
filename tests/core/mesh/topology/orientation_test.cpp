// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/topology/orientation.h"

#include "shapes.h"

#include <gtest/gtest.h>
#include <numeric>

namespace sheetmorph::mesh
{
namespace
{

TriangleMesh with_turned(const TriangleMesh& mesh, const std::vector<int>& turned)
{
    Triangles triangles = mesh.triangles();
    for (const int t : turned)
        std::swap(triangles(t, 1), triangles(t, 2));
    return TriangleMesh(mesh.points(), triangles);
}

TEST(Orientation, NamesTheFewestTrianglesToTurn)
{
    const std::vector<int> turned{3, 4, 17, 40};
    const TriangleMesh mesh = with_turned(shapes::box(3, Vector3(1, 1, 1)), turned);
    const Orientation found = consistent_orientation(mesh, EdgeTable(mesh));
    EXPECT_EQ(found.flipped, turned);
    EXPECT_TRUE(found.is_possible);
}

TEST(Orientation, GivesTheVolumeASign)
{
    const TriangleMesh mesh = shapes::box(2, Vector3(2, 3, 4));
    std::vector<int> all(static_cast<std::size_t>(mesh.triangle_count()));
    std::iota(all.begin(), all.end(), 0);
    EXPECT_NEAR(signed_volume(mesh, all, std::vector<int>(all.size(), 1)), 24.0, 1e-12);
    EXPECT_NEAR(signed_volume(mesh, all, std::vector<int>(all.size(), -1)), -24.0, 1e-12);
}

TEST(Orientation, OfAMoebiusStripIsImpossible)
{
    Points points = Points::Random(5, 3);
    Triangles triangles(5, 3);
    triangles << 0, 1, 2, 1, 2, 3, 2, 3, 4, 3, 4, 0, 4, 0, 1;
    const TriangleMesh strip(points, triangles);
    EXPECT_FALSE(consistent_orientation(strip, EdgeTable(strip)).is_possible);
}

}  // namespace
}  // namespace sheetmorph::mesh
