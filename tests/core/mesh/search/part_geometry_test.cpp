// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/search/part_geometry.h"

#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/mesh/geometry/normals.h"
#include "sheetmorph/mesh/geometry/operators.h"
#include "shapes.h"

#include <gtest/gtest.h>

namespace sheetmorph::mesh
{
namespace
{

TEST(PartGeometry, APatchHasTheNormalsAndAreasOfTheWholePartToTheBit)
{
    const TriangleMesh mesh = shapes::jittered(shapes::cylinder(30, 14, 30.0, 100.0), 1.0, 7);
    const VertexIds region = {0, 31, 32, 100, 233};
    const Submesh patch = PartGeometry(mesh).patch(region);
    EXPECT_LT(patch.mesh.triangle_count(), 6 * 8);
    const Points whole = vertex_normals(mesh.points(), mesh.triangles());
    const Points own = vertex_normals(patch.mesh.points(), patch.mesh.triangles());
    const Eigen::VectorXd areas = voronoi_areas(mesh), own_areas = voronoi_areas(patch.mesh);
    for (const int vertex : region)
    {
        const int row = patch.index_of[static_cast<std::size_t>(vertex)];
        ASSERT_GE(row, 0);
        EXPECT_EQ(own.row(row), whole.row(vertex));
        EXPECT_EQ(own_areas(row), areas(vertex));
    }
}

TEST(PartGeometry, IsMadeOnceWhoeverAsksFirst)
{
    const TriangleMesh mesh = shapes::jittered_grid(40, 30, 2.0, 3);
    const PartGeometry part(mesh);
    std::vector<const void*> trees(64), tables(64);
    parallel_items(64,
                   [&](Eigen::Index item)
                   {
                       trees[static_cast<std::size_t>(item)] = &part.tree();
                       tables[static_cast<std::size_t>(item)] = &part.triangles();
                   });
    for (std::size_t item = 0; item < trees.size(); ++item)
    {
        EXPECT_EQ(trees[item], trees.front());
        EXPECT_EQ(tables[item], tables.front());
    }
    EXPECT_NEAR(part.tree().nearest_point(Vector3(10.0, 10.0, 5.0))->distance, 5.0, 1e-12);
}

}  // namespace
}  // namespace sheetmorph::mesh
