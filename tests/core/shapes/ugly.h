// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "shapes/sheets.h"

namespace sheetmorph::shapes
{

//! The mesh with a needle at the first side of every `step`-th triangle, as T-junctions closed by
//! slivers have it: the side gets a vertex in its middle, `height` times its length inside the
//! triangle, which is cut there; a sliver fills what is left of it. 0 gives triangles of no area.
inline mesh::TriangleMesh with_slivers(const mesh::TriangleMesh& mesh, int step, double height)
{
    const Triangles& old = mesh.triangles();
    const int added = (mesh.triangle_count() + step - 1) / step;
    Points points(mesh.vertex_count() + added, 3);
    points.topRows(mesh.vertex_count()) = mesh.points();
    Triangles triangles(old.rows() + 2 * added, 3);
    triangles.topRows(old.rows()) = old;
    for (int k = 0; k < added; ++k)
    {
        const int t = k * step, n = mesh.vertex_count() + k;
        const int a = old(t, 0), b = old(t, 1), c = old(t, 2);
        const Vector3 start = mesh.points().row(a), end = mesh.points().row(b);
        const Vector3 apex = mesh.points().row(c);
        const Vector3 along = (end - start).normalized();
        const Vector3 inward = apex - start - along * along.dot(apex - start);
        points.row(n) =
            (0.5 * (start + end) + height * (end - start).norm() * inward.normalized()).transpose();
        triangles.row(t) << a, n, c;
        triangles.row(old.rows() + 2 * k) << n, b, c;
        triangles.row(old.rows() + 2 * k + 1) << a, b, n;
    }
    return mesh::TriangleMesh(points, triangles);
}

//! Three flat sheets of `n` by `n` cells that meet in one straight edge, like a T.
inline mesh::TriangleMesh t_joint(int n, double side)
{
    const int row = n + 1;
    Points points(row * row * 3 - 2 * row, 3);
    Triangles triangles(3 * 2 * n * n, 3);
    const Vector3 ways[] = {{0.0, 1.0, 0.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, 1.0}};
    const Triangles cells = cell_triangles({n, n});
    for (int sheet = 0; sheet < 3; ++sheet)
    {
        // The first row of every sheet is the common edge.
        const auto id = [&](int v) { return v < row ? v : v + sheet * n * row; };
        for (int v = 0; v < row * row; ++v)
            points.row(id(v)) =
                (Vector3(side * (v % row) / n, 0.0, 0.0) + side * (v / row) / n * ways[sheet])
                    .transpose();
        for (Eigen::Index t = 0; t < cells.rows(); ++t)
            triangles.row(sheet * cells.rows() + t) << id(cells(t, 0)), id(cells(t, 1)),
                id(cells(t, 2));
    }
    return mesh::TriangleMesh(points, triangles);
}

}  // namespace sheetmorph::shapes
