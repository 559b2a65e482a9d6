// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact regions of a few vertices, in line, or nearly on one another drive their targets too.
#include "sheetmorph/assembly/links/control_box.h"
#include "sheetmorph/assembly/links/motion_link.h"
#include "sheetmorph/base/rotation.h"
#include "shapes.h"

#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::assembly
{

using namespace volume;
namespace
{

//! A region of a sheet, and targets just above it.
struct Region
{
    std::string name;
    mesh::TriangleMesh mesh;
    VertexIds vertices;
    Points targets;
};

// Vertices of a sheet with edges of about 5 mm, drawn together to `extent` around the first.
Region drawn_together(std::mt19937& bits, double extent)
{
    static const std::vector<VertexIds> choices = {
        {40}, {40, 41}, {40, 41, 42}, {40, 41, 50}, {40, 41, 49, 50}, {30, 40, 50}, {40, 44, 80}};
    const VertexIds vertices = choices[bits() % choices.size()];
    const mesh::TriangleMesh grid = shapes::jittered_grid(9, 9, 5.0, static_cast<unsigned>(bits()));
    Points points = grid.points();
    const Eigen::RowVector3d first = points.row(vertices.front());
    const bool is_in_line = bits() % 2 == 0;
    for (const int vertex : vertices)
    {
        Eigen::RowVector3d arm = points.row(vertex) - first;
        if (is_in_line)
            arm.tail<2>().setZero();
        points.row(vertex) = first + arm * (extent / 5.0);
    }
    Points targets(static_cast<Eigen::Index>(vertices.size()), 3);
    for (std::size_t k = 0; k < vertices.size(); ++k)
        targets.row(static_cast<Eigen::Index>(k)) =
            points.row(vertices[k]) + Eigen::RowVector3d(0.0, 0.0, 0.3 * extent);
    return {std::to_string(vertices.size()) + (is_in_line ? " in line, " : ", ")
                + std::to_string(extent),
            mesh::TriangleMesh(points, grid.triangles()), vertices, targets};
}

OrientedBox box_around(const Region& region)
{
    const Points all = stacked(rows_of(region.mesh.points(), region.vertices), region.targets);
    BoxOptions options;
    options.single_point_size = 0.02 * region.mesh.size();
    return oriented_box(all, principal_axes(all, {}, Matrix3::Identity()), options);
}

TEST(ControlMeshLink, ARegionOfAnyExtentTakesItsTargetsAlongRigidly)
{
    std::mt19937 bits(36);
    const RigidMotion motion{{3.0, -2.0, 5.0}, {0.2, 0.4, -0.3}, {10.0, 20.0, 0.0}};
    for (double extent = 10.0; extent > 1e-11; extent *= 0.1)
        for (int draw = 0; draw < 8; ++draw)
        {
            const Region region = drawn_together(bits, extent);
            const mesh::PartGeometry part(region.mesh);
            const auto link = control_mesh_link({part, region.vertices, region.targets},
                                                {box_around(region), 3, 0.05});
            surface::Deformation moved;
            moved.positions = motion.apply(region.mesh.points());
            moved.rotation_logs =
                motion.rotation_log.transpose().replicate(region.mesh.vertex_count(), 1);
            const LinkedTargets found = link->transfer(moved, Exactness::exact);
            const double missed =
                (found.positions - motion.apply(region.targets)).rowwise().norm().maxCoeff();
            EXPECT_LT(missed, 1e-9 * region.mesh.size()) << region.name;
            // Slivers as thin as rounding have no exact rotation of their own.
            const double turned = (found.logs.rowwise() - motion.rotation_log.transpose()).norm();
            EXPECT_LT(turned, extent < 1e-6 ? 0.1 : 1e-6) << region.name;
        }
}

}  // namespace
}  // namespace sheetmorph::assembly
