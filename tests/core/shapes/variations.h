// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/rigid_motion.h"
#include "sheetmorph/mesh/triangle_mesh.h"
#include "shapes/sheets.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace sheetmorph::shapes
{

//! The same mesh with every position passed through position(p).
template <typename Map>
mesh::TriangleMesh mapped(const mesh::TriangleMesh& mesh, Map position)
{
    Points points(mesh.vertex_count(), 3);
    for (int i = 0; i < mesh.vertex_count(); ++i)
        points.row(i) = Vector3(position(Vector3(mesh.points().row(i)))).transpose();
    return mesh::TriangleMesh(std::move(points), mesh.triangles());
}

inline mesh::TriangleMesh moved(const mesh::TriangleMesh& mesh, const RigidMotion& motion)
{
    return mesh::TriangleMesh(motion.apply(mesh.points()), mesh.triangles());
}

//! Vertices inside the bounding box in x and y moved there by up to `amplitude` mm each way.
inline mesh::TriangleMesh jittered(const mesh::TriangleMesh& mesh, double amplitude, unsigned seed)
{
    std::mt19937 random(seed);
    const auto shift = [&] { return amplitude * (2.0 * (random() / 4294967296.0) - 1.0); };
    const Eigen::RowVector3d low = mesh.points().colwise().minCoeff();
    const Eigen::RowVector3d high = mesh.points().colwise().maxCoeff();
    return mapped(mesh,
                  [&](Vector3 p)
                  {
                      for (int c = 0; c < 2; ++c)
                          if (p(c) > low(c) && p(c) < high(c))
                              p(c) += shift();
                      return p;
                  });
}

//! The mesh as measured: vertices off by a normal distribution of this standard deviation, mm.
inline mesh::TriangleMesh scattered(const mesh::TriangleMesh& mesh, double deviation, unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> off(0.0, deviation);
    return mapped(mesh,
                  [&](const Vector3& p)
                  {
                      const double x = off(random), y = off(random), z = off(random);
                      return Vector3(p + Vector3(x, y, z));
                  });
}

//! A flat grid as of grid(), its inner vertices moved by up to a quarter of a cell.
inline mesh::TriangleMesh jittered_grid(int nx, int ny, double cell, unsigned seed)
{
    return jittered(grid(nx, ny, nx * cell, ny * cell), 0.25 * cell, seed);
}

//! A mesh whose vertices carry other numbers: vertex i of the old one is new_id[i].
struct Renumbered
{
    mesh::TriangleMesh mesh;
    VertexIds new_id;
};

inline Renumbered renumbered(const mesh::TriangleMesh& mesh, unsigned seed)
{
    std::mt19937 random(seed);
    VertexIds order(mesh.vertex_count());
    std::iota(order.begin(), order.end(), 0);
    for (int i = mesh.vertex_count() - 1; i > 0; --i)
        std::swap(order[i], order[random() % (i + 1)]);
    Points points(mesh.vertex_count(), 3);
    for (int i = 0; i < mesh.vertex_count(); ++i)
        points.row(order[i]) = mesh.points().row(i);
    Triangles triangles = mesh.triangles().unaryExpr([&](int id) { return order[id]; });
    return {mesh::TriangleMesh(std::move(points), std::move(triangles)), order};
}

}  // namespace sheetmorph::shapes
