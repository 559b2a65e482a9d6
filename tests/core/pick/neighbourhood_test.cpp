// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/pick/neighbourhood.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/regions/growing.h"
#include "shapes.h"

#include <gmock/gmock.h>

namespace sheetmorph::pick
{

using namespace mesh;

namespace
{

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<TriangleMesh> meshes()
{
    const TriangleMesh grid = shapes::grid(6, 5, 6, 5);
    Points folded(44, 3);  // a third sheet stands on a row of the grid: T-joints
    folded << grid.points(),
        Points::NullaryExpr(2, 3, [](auto i, auto c) { return c ? 2.0 * c : i; });
    Triangles triangles(63, 3);
    triangles << grid.triangles(), 14, 15, 42, 15, 43, 42, 15, 16, 43;
    return {shapes::plate_with_holes().mesh, shapes::torus(20, 12, 10, 4),
            shapes::box(5, {30, 20, 10}), TriangleMesh(folded, triangles)};
}

}  // namespace

TEST(Neighbourhood, GrowsAndShrinksAsALookAtTheWholeMeshDoes)
{
    for (const TriangleMesh& mesh : meshes())
    {
        const Neighbourhood near(mesh);
        for (const int rings : {0, 1, 2, 5})
        {
            const VertexIds start = {0, 17, 3, 17};
            const VertexIds grown = grow_rings(mesh, start, rings);
            EXPECT_EQ(near.grown(start, rings), grown);
            EXPECT_EQ(near.shrunk(grown, rings), shrink_rings(mesh, grown, rings));
            EXPECT_EQ(near.shrunk(grown, 1), shrink_rings(mesh, grown, 1));
        }
    }
}

TEST(Neighbourhood, FacesAndPiecesAreThoseOfTheWholeMesh)
{
    for (const TriangleMesh& mesh : meshes())
    {
        const Neighbourhood near(mesh);
        for (const int t : {0, 9, mesh.triangle_count() - 1})
        {
            for (const double angle : {0.1, 0.8, 2.0})
                EXPECT_EQ(near.face(t, angle), grow_to_creases(mesh, t, angle));
            EXPECT_EQ(near.piece(t), connected_triangles(mesh, t));
        }
    }
}

TEST(Neighbourhood, TheTrianglesAtAVertexAreThoseThatHaveIt)
{
    const TriangleMesh grid = shapes::grid(2, 2, 2, 2);
    EXPECT_THAT(Neighbourhood(grid).triangles_at({0, 0}), ElementsAre(0, 1));
    EXPECT_THAT(Neighbourhood(grid).triangles_at({}), IsEmpty());
    EXPECT_THAT(Neighbourhood(grid).triangles_at({4}).size(), 8);
}

TEST(Neighbourhood, PiecesAreWhatHangsTogether)
{
    const TriangleMesh grid = shapes::grid(4, 4, 4, 4);
    EXPECT_THAT(Neighbourhood(grid).pieces({24, 0, 23, 1, 5}),
                ElementsAre(ElementsAre(0, 1, 5), ElementsAre(23, 24)));
    EXPECT_THAT(Neighbourhood(grid).pieces({}), IsEmpty());
}

TEST(Neighbourhood, RimsOfAnOpenSheetAreItsBoundaryLoops)
{
    const auto plate = shapes::plate_with_holes();
    EXPECT_THAT(Neighbourhood(plate.mesh).rims(0.5), SizeIs(plate.rims.size() + 1));
}

TEST(Neighbourhood, IdsOutsideTheMeshAreNamed)
{
    const Neighbourhood near(shapes::grid(2, 2, 2, 2));
    EXPECT_THROW(near.triangles_at({9}), InvalidInput);
    EXPECT_THROW(near.grown({-1}, 1), InvalidInput);
    EXPECT_THROW(near.grown({0}, -1), InvalidInput);
    EXPECT_THROW(near.shrunk({42}, 1), InvalidInput);
    EXPECT_THROW(near.face(8, 1.0), InvalidInput);
    EXPECT_THROW(near.piece(-2), InvalidInput);
    EXPECT_THROW(near.pieces({25}), InvalidInput);
}

}  // namespace sheetmorph::pick
