// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/thin/thin_part.h"

#include "shapes/thin.h"

#include <gtest/gtest.h>

namespace sheetmorph::assembly
{
namespace
{

constexpr double thickness = 2.0;

ThinPart thin(const mesh::TriangleMesh& mesh)
{
    return ThinPart(mesh, *recognise::find_thin_solid(mesh).solid);
}

// The skin's vertices by their number in the part.
VertexIds in_part(const ThinPart& part, const VertexIds& of_skin)
{
    VertexIds found;
    for (const int s : of_skin)
        found.push_back(part.skin().vertices[static_cast<std::size_t>(s)]);
    return found;
}

TEST(ThinPart, ItsMiddleIsHalfwayBetweenItsSkins)
{
    const mesh::TriangleMesh flat = shapes::grid(24, 8, 120.0, 40.0);
    for (const double angle : {0.0, 0.6, shapes::pi / 2.0})
    {
        const mesh::TriangleMesh sheet =
            angle > 0.0 ? shapes::with_bend(flat, 50.0, 20.0, angle) : flat;
        const ThinPart part = thin(shapes::two_skinned(sheet, thickness));
        const Points& points = part.mesh().points();
        for (int s = 0; s < part.middle().vertex_count(); ++s)
        {
            const int v = part.skin().vertices[static_cast<std::size_t>(s)];
            const int other = (v + flat.vertex_count()) % (2 * flat.vertex_count());
            const Eigen::RowVector3d halfway = 0.5 * (points.row(v) + points.row(other));
            EXPECT_LT((part.middle().points().row(s) - halfway).norm(), 0.02 * thickness) << angle;
        }
    }
}

// A patch of the main skin is itself on it; the same patch of the other skin is what lies over it.
TEST(ThinPart, ARegionOfEitherSkinIsTheSamePlaceOfTheMainOne)
{
    const mesh::TriangleMesh sheet = shapes::grid(20, 10, 100.0, 50.0);
    const ThinPart part = thin(shapes::two_skinned(sheet, thickness));
    const int count = sheet.vertex_count();
    VertexIds front = shapes::vertices_where(
        sheet, [](const Vector3& p) { return (p - Vector3(50, 25, 0)).norm() < 11.0; });
    VertexIds back = front;
    for (int& vertex : back)
        vertex += count;
    const bool is_front_main = part.skin().index_of[0] >= 0;
    const VertexIds& own = is_front_main ? front : back;
    const VertexIds& other = is_front_main ? back : front;
    const SkinRegion here = part.on_skin(own);
    EXPECT_EQ(in_part(part, here.own), own);
    EXPECT_TRUE(here.below.empty());
    const SkinRegion there = part.on_skin(other);
    EXPECT_TRUE(there.own.empty());
    EXPECT_EQ(in_part(part, there.below), own);
    VertexIds both = own;
    both.insert(both.end(), other.begin(), other.end());
    EXPECT_EQ(in_part(part, part.on_skin(both).own), own);
    EXPECT_TRUE(part.on_skin(both).below.empty());
}

TEST(ThinPart, TheRimOfAHoleTakesItsWallAlong)
{
    const shapes::PlateWithHoles plate = shapes::plate_with_holes();
    const ThinPart part = thin(shapes::two_skinned(plate.mesh, thickness));
    const VertexIds& rim = plate.rims[1];
    EXPECT_EQ(part.with_walls(rim).size(), 3u * rim.size());
    const VertexIds some(rim.begin(), rim.end() - 1);
    EXPECT_EQ(part.with_walls(some).size(), some.size());
}

}  // namespace
}  // namespace sheetmorph::assembly
