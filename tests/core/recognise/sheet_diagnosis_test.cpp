// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/sheet_diagnosis.h"

#include "sheetmorph/mesh/topology/orientation.h"
#include "sheetmorph/recognise/thin/thin_solid.h"
#include "shapes.h"
#include "shapes/thick.h"
#include "shapes/thin.h"

#include <gtest/gtest.h>

namespace sheetmorph::recognise
{

using namespace mesh;
namespace
{

// A flat ring, `height` thick.
TriangleMesh washer(double height)
{
    const auto face = [&](double z, bool is_up)
    {
        const TriangleMesh ring = shapes::annulus(48, 3, 10.0, 30.0);
        return shapes::mapped(ring,
                              [=](Vector3 p) { return Vector3(p.x(), is_up ? p.y() : -p.y(), z); });
    };
    const TriangleMesh outer = shapes::cylinder(48, 1, 30.0, height);
    const TriangleMesh inner = shapes::cylinder(48, 1, 10.0, height);
    return shapes::welded({face(height, true), face(0.0, false), outer, inner});
}

TEST(SheetDiagnosis, TellsAThinSolidAndItsThickness)
{
    const Diagnosis found = diagnose_sheets(washer(1.5), 1e-6);
    ASSERT_EQ(found.pieces.size(), 1U);
    EXPECT_EQ(found.pieces[0].kind, PieceKind::thin_solid);
    EXPECT_NEAR(found.pieces[0].thickness, 1.5, 1e-6);
    EXPECT_NEAR(found.pieces[0].thinnest, 1.5, 1e-6);
    EXPECT_NEAR(found.pieces[0].thickest, 1.5, 1e-6);
    EXPECT_EQ(found.open_edges, 0);
}

// A plate whose thickness grows evenly from 1.5 to 2.5 mm: a twentieth of it is below 1.55 mm.
TEST(SheetDiagnosis, TellsTheThicknessesOfATaperedPlateByArea)
{
    const TriangleMesh plate = shapes::two_skinned(shapes::grid(60, 10, 120.0, 40.0), 2.0);
    const TriangleMesh tapered =
        shapes::mapped(plate, [](const Vector3& p)
                       { return Vector3(p.x(), p.y(), p.z() * (1.5 + p.x() / 120.0) / 2.0); });
    const Diagnosis found = diagnose_sheets(tapered, 1e-6);
    ASSERT_EQ(found.pieces.size(), 1U);
    ASSERT_EQ(found.pieces[0].kind, PieceKind::thin_solid);
    EXPECT_NEAR(found.pieces[0].thinnest, 1.55, 0.03);
    EXPECT_NEAR(found.pieces[0].thickest, 2.45, 0.03);
}

// A sheet, a block and a sheet of another thickness, every triangle with corners of its own and
// some of them turned over: what a weld cures plays no role.
TEST(SheetDiagnosis, JudgesEveryPieceAsTheRecogniserDoes)
{
    const auto at = [](const TriangleMesh& mesh, double x)
    { return shapes::mapped(mesh, [=](Vector3 p) { return Vector3(p + Vector3(x, 0, 0)); }); };
    const TriangleMesh parts[] = {washer(1.5), at(shapes::box(4, Vector3(30, 20, 20)), 100.0),
                                  at(washer(3.0), 200.0)};
    TriangleMesh soup = shapes::unwelded(shapes::welded({parts[0], parts[1], parts[2]}));
    Triangles triangles = soup.triangles();
    for (int t = 0; t < soup.triangle_count(); t += 7)
        std::swap(triangles(t, 1), triangles(t, 2));
    const Diagnosis found = diagnose_sheets(TriangleMesh(soup.points(), triangles), 1e-6);
    ASSERT_EQ(found.pieces.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k)
    {
        const TriangleMesh whole =
            oriented(parts[k], outward_orientation(parts[k], EdgeTable(parts[k])));
        const std::optional<ThinSolid> solid = find_thin_solid(whole).solid;
        EXPECT_EQ(solid.has_value(), k != 1) << k;
        EXPECT_EQ(found.pieces[k].kind == PieceKind::thin_solid, solid.has_value()) << k;
        EXPECT_NEAR(found.pieces[k].thickness, solid ? solid->thickness : 0.0, 1e-9) << k;
    }
}

}  // namespace
}  // namespace sheetmorph::recognise
