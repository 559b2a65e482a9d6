// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/geometry/normals.h"
#include "sheetmorph/mesh/topology/boundary.h"
#include "shapes/plates.h"

namespace sheetmorph::shapes
{

//! The wall below one boundary loop: `rows` of vertices, the sheet's own first.
inline void add_wall(const std::vector<VertexIds>& rows, std::vector<Eigen::RowVector3i>& triangles)
{
    for (std::size_t k = 0; k + 1 < rows.size(); ++k)
        for (std::size_t i = 0; i < rows[k].size(); ++i)
        {
            const std::size_t j = (i + 1) % rows[k].size();
            triangles.emplace_back(rows[k][j], rows[k][i], rows[k + 1][i]);
            triangles.emplace_back(rows[k][j], rows[k + 1][i], rows[k + 1][j]);
        }
}

//! The closed solid under an open sheet: vertex i of the sheet is vertex i, what is `thickness`
//! behind it is vertex n + i; walls under every boundary loop have one row of vertices between.
//! \param normals  (n, 3) of length 1
inline mesh::TriangleMesh two_skinned(const mesh::TriangleMesh& sheet, const Points& normals,
                                      double thickness)
{
    const int count = sheet.vertex_count();
    const std::vector<VertexIds> loops = mesh::boundary_loops(sheet);
    std::vector<Eigen::RowVector3d> points;
    for (int skin = 0; skin < 2; ++skin)
        for (int i = 0; i < count; ++i)
            points.push_back(sheet.points().row(i) - skin * thickness * normals.row(i));
    std::vector<Eigen::RowVector3i> triangles;
    for (int t = 0; t < sheet.triangle_count(); ++t)
    {
        const Eigen::RowVector3i own = sheet.triangles().row(t);
        triangles.push_back(own);
        triangles.emplace_back(own(0) + count, own(2) + count, own(1) + count);
    }
    for (const VertexIds& loop : loops)
    {
        std::vector<VertexIds> rows(3);
        for (const int vertex : loop)
        {
            rows[0].push_back(vertex);
            rows[1].push_back(static_cast<int>(points.size()));
            points.push_back(sheet.points().row(vertex) - 0.5 * thickness * normals.row(vertex));
            rows[2].push_back(vertex + count);
        }
        add_wall(rows, triangles);
    }
    Points all_points(points.size(), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
        all_points.row(i) = points[i];
    Triangles all_triangles(triangles.size(), 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        all_triangles.row(t) = triangles[t];
    return mesh::TriangleMesh(std::move(all_points), std::move(all_triangles));
}

//! The same with the normals of the sheet.
inline mesh::TriangleMesh two_skinned(const mesh::TriangleMesh& sheet, double thickness)
{
    return two_skinned(sheet, mesh::vertex_normals(sheet.points(), sheet.triangles()), thickness);
}

//! A plate bent along its x axis, up by an angle > 0, down by one < 0, over an arc of length `arc`
//! that starts at x = `start`.
inline mesh::TriangleMesh with_bend(const mesh::TriangleMesh& plate, double start, double arc,
                                    double angle)
{
    const double radius = arc / angle;
    return mesh::TriangleMesh(
        [&]
        {
            Points points = plate.points();
            for (int i = 0; i < plate.vertex_count(); ++i)
            {
                const double x = points(i, 0) - start;
                const double turn = angle * std::clamp(x / arc, 0.0, 1.0);
                const double beyond = std::max(x - arc, 0.0);
                if (x <= 0.0)
                    continue;
                const Vector3 inwards(-std::sin(turn), 0.0, std::cos(turn));
                const Vector3 along(std::cos(turn), 0.0, std::sin(turn));
                points.row(i) = (Vector3(start, points(i, 1), radius) - radius * inwards
                                 + points(i, 2) * inwards + beyond * along)
                                    .transpose();
            }
            return points;
        }(),
        plate.triangles());
}

}  // namespace sheetmorph::shapes
