// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/thin/thin_solid.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/topology/polygons.h"
#include "shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sheetmorph::recognise
{

using namespace mesh;
namespace
{

using testing::Each;
using testing::HasSubstr;

ThinSolid found(const TriangleMesh& mesh, double thickness = 0.0)
{
    ThinFinding finding = find_thin_solid(mesh, thickness);
    EXPECT_TRUE(finding.solid) << finding.reason;
    return finding.solid ? *finding.solid : ThinSolid{};
}

std::string why_not(const TriangleMesh& mesh)
{
    const ThinFinding finding = find_thin_solid(mesh);
    EXPECT_FALSE(finding.solid);
    return finding.reason;
}

int count_of(const std::vector<SolidSide>& sides, SolidSide side)
{
    return static_cast<int>(std::count(sides.begin(), sides.end(), side));
}

TriangleMesh block(const Vector3& low, const Vector3& sides, int n)
{
    return shapes::mapped(shapes::box(n, sides),
                          [&](const Vector3& p) { return Vector3(low + p); });
}

// A flat face with square openings, in one plane, as CAD cuts it: no vertex inside, slivers.
TriangleMesh flat_with_openings(const std::vector<VertexIds>& loops, const Points& points)
{
    VertexIds polygon = loops.front();
    for (std::size_t k = 1; k < loops.size(); ++k)
    {
        // A bridge there and back from the outer loop's first corner.
        VertexIds bridged = {polygon.front()};
        bridged.insert(bridged.end(), loops[k].begin(), loops[k].end());
        bridged.push_back(loops[k].front());
        bridged.push_back(polygon.front());
        bridged.insert(bridged.end(), polygon.begin() + 1, polygon.end());
        polygon = bridged;
    }
    return TriangleMesh(points, split_polygon(points, polygon));
}

// 200 x 100 x 2 mm with one round hole of 40 facets: a dozen slivers on each skin.
TriangleMesh cad_plate()
{
    const int around = 40;
    Points points(4 + around, 3);
    points.topRows(4) << 0, 0, 0, 200, 0, 0, 200, 100, 0, 0, 100, 0;
    VertexIds outer = {0, 1, 2, 3}, hole;
    for (int i = 0; i < around; ++i)
    {
        const double turn = -2.0 * shapes::pi * i / around - 2.2;
        points.row(4 + i) << 60.0 + 15.0 * std::cos(turn), 50.0 + 15.0 * std::sin(turn), 0.0;
        hole.push_back(4 + i);
    }
    return shapes::two_skinned(flat_with_openings({outer, hole}, points), 2.0);
}

TEST(ThinSolid, APlateWithHolesHasTwoSkinsAWallAndItsHoles)
{
    const shapes::PlateWithHoles plate = shapes::plate_with_holes();
    const TriangleMesh mesh = shapes::two_skinned(plate.mesh, 2.0);
    const ThinSolid solid = found(mesh);
    EXPECT_NEAR(solid.thickness, 2.0, 1e-9);
    EXPECT_EQ(count_of(solid.facets, SolidSide::main), plate.mesh.triangle_count());
    EXPECT_EQ(count_of(solid.facets, SolidSide::opposite), plate.mesh.triangle_count());
    EXPECT_EQ(count_of(solid.facets, SolidSide::lump), 0);
    ASSERT_EQ(solid.holes.size(), 3u);
    EXPECT_EQ(solid.walls.size(), 4u);
    for (const ThroughHole& hole : solid.holes)
    {
        EXPECT_EQ(hole.rim.size(), 32u);
        EXPECT_EQ(hole.vertices.size(), 3u * 32u);
    }
    for (int i = 0; i < 2 * plate.mesh.vertex_count(); ++i)
        EXPECT_NEAR(solid.thicknesses(i), 2.0, 1e-9);
}

TEST(ThinSolid, AWallIsNoSkinHoweverLowItsFacetsAreBesideTheRim)
{
    const shapes::PlateWithHoles plate = shapes::plate_with_holes();
    const TriangleMesh even = shapes::two_skinned(plate.mesh, 2.0);
    const double top = even.points().col(2).maxCoeff(), bottom = even.points().col(2).minCoeff();
    for (const double height : {0.001, 0.03, 1.96})
    {
        const TriangleMesh mesh = shapes::mapped(even,
                                                 [&](Vector3 p)
                                                 {
                                                     if (p.z() > bottom && p.z() < top)
                                                         p.z() = bottom + height;
                                                     return p;
                                                 });
        const ThinSolid solid = found(mesh);
        EXPECT_EQ(count_of(solid.facets, SolidSide::main), plate.mesh.triangle_count()) << height;
        EXPECT_EQ(count_of(solid.facets, SolidSide::opposite), plate.mesh.triangle_count());
    }
}

TEST(ThinSolid, TheHugeSliversOfACadTessellationTellAsMuch)
{
    const ThinSolid solid = found(cad_plate());
    EXPECT_NEAR(solid.thickness, 2.0, 1e-9);
    ASSERT_EQ(solid.holes.size(), 1u);
    EXPECT_EQ(solid.holes.front().rim.size(), 40u);
    EXPECT_EQ(solid.walls.size(), 2u);
    EXPECT_EQ(count_of(solid.facets, SolidSide::main), count_of(solid.facets, SolidSide::opposite));
}

TEST(ThinSolid, BendsAndSharpFoldsStayOnTheirSkin)
{
    const TriangleMesh flat = shapes::grid(40, 12, 120.0, 40.0);
    for (const double arc : {30.0, 12.0})
        for (const double angle : {0.5, 1.0, shapes::pi / 2.0})
        {
            const TriangleMesh sheet = shapes::with_bend(flat, 50.0, arc, angle);
            const ThinSolid solid = found(shapes::two_skinned(sheet, 1.5));
            EXPECT_EQ(count_of(solid.facets, SolidSide::main), flat.triangle_count());
            EXPECT_EQ(count_of(solid.facets, SolidSide::opposite), flat.triangle_count());
            EXPECT_EQ(solid.walls.size(), 1u);
            EXPECT_TRUE(solid.lumps.empty());
            EXPECT_TRUE(solid.holes.empty());
        }
}

TEST(ThinSolid, AFinelyMeshedFoldWithoutRadiusStaysOnItsSkin)
{
    // An L of 2 mm, its section extruded by 40 mm, all facets smaller than the thickness.
    const double t = 2.0, leg = 30.0;
    std::vector<Vector3> section = {{0, 0, 0}, {0, 0, leg}, {t, 0, leg},
                                    {t, 0, t}, {leg, 0, t}, {leg, 0, 0}};
    std::vector<TriangleMesh> faces;
    for (std::size_t k = 0; k < section.size(); ++k)
    {
        const Vector3 from = section[k], to = section[(k + 1) % section.size()];
        const int cells = static_cast<int>((to - from).norm() + 0.5);
        faces.push_back(
            shapes::sheet({cells, 40}, [&](double u, double v)
                          { return Vector3(from + u * (to - from) + Vector3(0, 40.0 * v, 0)); }));
    }
    for (const double y : {0.0, 40.0})
    {
        const auto end = [&](double x, double z, double lx, double lz)
        {
            const int nx = static_cast<int>(lx + 0.5), nz = static_cast<int>(lz + 0.5);
            faces.push_back(
                shapes::sheet({nx, nz}, [&](double u, double v)
                              { return Vector3(x + lx * (y > 0 ? 1.0 - u : u), y, z + lz * v); }));
        };
        end(0, 0, leg, t);
        end(0, t, t, leg - t);
    }
    const ThinSolid solid = found(shapes::welded(faces));
    const double outside = 2.0 * leg * 40.0, inside = 2.0 * (leg - t) * 40.0;
    EXPECT_EQ(count_of(solid.facets, SolidSide::main), static_cast<int>(2.0 * outside));
    EXPECT_EQ(count_of(solid.facets, SolidSide::opposite), static_cast<int>(2.0 * inside));
    EXPECT_TRUE(solid.lumps.empty());
}

// A block of 20 x 20 x 15 mm stands in the middle of a plate of 100 x 100 x 2 mm.
TriangleMesh plate_with_boss()
{
    const TriangleMesh plate = block({0, 0, 0}, {100, 100, 2}, 20);
    const TriangleMesh boss = block({40, 40, 2}, {20, 20, 15}, 4);
    const auto without_contact = [](const TriangleMesh& mesh)
    {
        std::vector<int> kept;
        for (int t = 0; t < mesh.triangle_count(); ++t)
        {
            Vector3 centre = Vector3::Zero();
            for (int k = 0; k < 3; ++k)
                centre += mesh.points().row(mesh.triangles()(t, k)).transpose() / 3.0;
            const bool is_contact = std::abs(centre.z() - 2.0) < 1e-9 && centre.x() > 40.0
                                    && centre.x() < 60.0 && centre.y() > 40.0 && centre.y() < 60.0;
            if (!is_contact)
                kept.push_back(t);
        }
        return TriangleMesh(mesh.points(), mesh.triangles()(kept, Eigen::indexing::all));
    };
    return shapes::welded({without_contact(plate), without_contact(boss)});
}

TEST(ThinSolid, ABossIsALumpWithItsFootOnBothSkins)
{
    const TriangleMesh mesh = plate_with_boss();
    const ThinSolid solid = found(mesh);
    ASSERT_EQ(solid.lumps.size(), 1u);
    for (const int vertex : solid.lumps.front())
    {
        const auto point = mesh.points().row(vertex);
        EXPECT_TRUE(point(0) > 35.0 && point(0) < 65.0 && point(1) > 35.0 && point(1) < 65.0);
    }
    const auto is_in_lump = [&](const Vector3& place)
    {
        const int vertex = shapes::vertex_at(mesh, place);
        const VertexIds& lump = solid.lumps.front();
        return std::find(lump.begin(), lump.end(), vertex) != lump.end();
    };
    EXPECT_TRUE(is_in_lump({50, 50, 17}));  // its top
    EXPECT_TRUE(is_in_lump({50, 50, 0}));   // its foot, from behind
    EXPECT_FALSE(is_in_lump({20, 20, 0}));
    EXPECT_EQ(solid.vertices[static_cast<std::size_t>(shapes::vertex_at(mesh, {50, 50, 0}))],
              SolidSide::main)
        << "the skin without the boss is the main one";
}

TEST(ThinSolid, BlocksBarsBallsAndRingsAreNone)
{
    EXPECT_THAT(why_not(shapes::box(6, {10, 10, 10})), HasSubstr("of its surface are two skins"));
    EXPECT_THAT(why_not(shapes::box(6, {100, 4, 4})), HasSubstr("of its surface are two skins"));
    EXPECT_THAT(why_not(shapes::box(6, {100, 100, 20})), HasSubstr("a tenth of its size"));
    EXPECT_THAT(why_not(shapes::sphere(4, 20.0)), HasSubstr("of its surface are two skins"));
    EXPECT_THAT(why_not(shapes::torus(40, 20, 60.0, 3.0)),
                HasSubstr("of its surface are two skins"));
}

TEST(ThinSolid, AnOpenOrTornSurfaceIsNone)
{
    EXPECT_THAT(why_not(shapes::grid(4, 4, 10.0, 10.0)), HasSubstr("not closed"));
    TriangleMesh mesh = shapes::two_skinned(shapes::grid(8, 8, 50.0, 50.0), 1.0);
    Triangles turned = mesh.triangles();
    std::swap(turned(3, 0), turned(3, 1));
    EXPECT_THAT(why_not(TriangleMesh(mesh.points(), turned)), HasSubstr("orient"));
    EXPECT_THAT(why_not(TriangleMesh(Points(0, 3), Triangles(0, 3))), HasSubstr("no triangles"));
}

TEST(ThinSolid, InsideOutMovedScaledAndMirroredSolidsAreFoundAlike)
{
    const TriangleMesh mesh = shapes::two_skinned(shapes::plate_with_holes().mesh, 2.0);
    const ThinSolid expected = found(mesh);
    const TriangleMesh inside_out(mesh.points(), mesh.triangles().rowwise().reverse());
    EXPECT_EQ(found(inside_out).facets, expected.facets);
    const auto far_and_small = [](const Vector3& p)
    { return Vector3(0.001 * Vector3(-p.y(), p.x(), p.z()) + Vector3(3.0, -2.0, 1.0)); };
    const ThinSolid small = found(shapes::mapped(mesh, far_and_small));
    EXPECT_EQ(small.facets, expected.facets);
    EXPECT_NEAR(small.thickness, 0.002, 1e-12);
    const auto mirror = [](const Vector3& p) { return Vector3(-p.x(), p.y(), p.z()); };
    EXPECT_EQ(found(shapes::mapped(mesh, mirror)).facets, expected.facets);
}

TEST(ThinSolid, RenumberedVerticesGiveTheSameSkins)
{
    const TriangleMesh sheet =
        shapes::with_bend(shapes::plate_with_holes().mesh, 57.0, 8.0, shapes::pi / 4.0);
    const TriangleMesh mesh = shapes::two_skinned(sheet, 2.0);
    const ThinSolid expected = found(mesh);
    const shapes::Renumbered other = shapes::renumbered(mesh, 7);
    const ThinSolid solid = found(other.mesh);
    EXPECT_EQ(solid.facets, expected.facets);
    for (int i = 0; i < mesh.vertex_count(); ++i)
        EXPECT_EQ(
            solid.vertices[static_cast<std::size_t>(other.new_id[static_cast<std::size_t>(i)])],
            expected.vertices[static_cast<std::size_t>(i)]);
}

TEST(ThinSolid, AKnownThicknessChoosesTheSheet)
{
    const TriangleMesh mesh = shapes::two_skinned(shapes::grid(20, 20, 100.0, 100.0), 2.0);
    EXPECT_NEAR(found(mesh, 2.1).thickness, 2.1, 1e-12);
    EXPECT_FALSE(find_thin_solid(mesh, 8.0).solid);
    EXPECT_THROW(find_thin_solid(mesh, -1.0), InvalidInput);
}

}  // namespace
}  // namespace sheetmorph::recognise
