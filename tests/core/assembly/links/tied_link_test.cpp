// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/links/motion_link.h"
#include "shapes.h"

#include <gtest/gtest.h>
#include <malloc.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SHEETMORPH_SANITIZED
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();  // GCC installs no header for it
#endif

namespace sheetmorph::assembly
{
namespace
{

// Bytes that are in use on the heap. Sanitizers have a heap of their own, of which mallinfo2 knows
// nothing.
double used_bytes()
{
#ifdef SHEETMORPH_SANITIZED
    return static_cast<double>(__sanitizer_get_current_allocated_bytes());
#else
    const struct mallinfo2 heap = mallinfo2();
    return static_cast<double>(heap.uordblks + heap.hblkhd);
#endif
}

TEST(TiedLink, ManyContactsKeepNoCopyOfTheLargePartTheyAreOn)
{
    const mesh::TriangleMesh mesh = shapes::grid(200, 200, 400.0, 400.0);
    const mesh::PartGeometry part(mesh);
    const double bytes_of_points = 24.0 * mesh.vertex_count();
    const auto link_at = [&](int k)
    {
        const VertexIds region =
            shapes::vertices_where(mesh, [&](const Vector3& p)
                                   { return (p - Vector3(15.0 * k, 200.0, 0.0)).norm() < 6.0; });
        Points targets(region.size(), 3);
        for (std::size_t row = 0; row < region.size(); ++row)
            targets.row(static_cast<Eigen::Index>(row)) =
                mesh.points().row(region[row]) + Eigen::RowVector3d(0.3, 0.2, 1.0);
        return tied_link({part, region, targets});
    };
    const auto first = link_at(1);
    const double before = used_bytes();
    std::vector<std::unique_ptr<MotionLink>> links;
    for (int k = 2; k < 22; ++k)
        links.push_back(link_at(k));
    EXPECT_LT(used_bytes() - before, bytes_of_points);
    EXPECT_GT(used_bytes(), before);
}

TEST(TiedLink, AFewVerticesOfAPartTurnAsTheyDoAmongAll)
{
    const mesh::TriangleMesh mesh = shapes::jittered_grid(12, 9, 5.0, 3);
    const RigidMotion motion{{1.0, -2.0, 3.0}, {0.3, 0.9, -0.2}, {5.0, 4.0, 3.0}};
    const VertexIds region = {40, 41, 42, 53, 54, 55};
    const Points targets =
        mesh.points()({40, 54}, Eigen::indexing::all).rowwise() + Eigen::RowVector3d(0.4, 0.3, 1.5);
    const mesh::PartGeometry part(mesh);
    const auto link = tied_link({part, region, targets});
    surface::Deformation shape{motion.apply(mesh.points()),
                               motion.rotation_log.transpose().replicate(mesh.vertex_count(), 1),
                               {}};
    const volume::LinkedTargets found = link->transfer(shape, Exactness::exact);
    EXPECT_LT((found.positions - motion.apply(targets)).norm(), 1e-11);
}

}  // namespace
}  // namespace sheetmorph::assembly
