// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <cmath>

namespace sheetmorph::shapes
{

constexpr double pi = 3.14159265358979323846;

//! How many cells a sheet has in both directions, and in which it closes upon itself.
struct Cells
{
    int columns = 1;
    int rows = 1;
    bool is_closed_u = false;
    bool is_closed_v = false;
};

//! Two triangles per cell with alternating diagonals; vertices are numbered row by row.
inline Triangles cell_triangles(const Cells& cells)
{
    const int across = cells.columns + (cells.is_closed_u ? 0 : 1);
    const int along = cells.rows + (cells.is_closed_v ? 0 : 1);
    const auto id = [&](int i, int j) { return (j % along) * across + i % across; };
    Triangles triangles(2 * cells.columns * cells.rows, 3);
    int t = 0;
    for (int j = 0; j < cells.rows; ++j)
        for (int i = 0; i < cells.columns; ++i, t += 2)
        {
            const int a = id(i, j), b = id(i + 1, j), c = id(i + 1, j + 1), d = id(i, j + 1);
            if ((i + j) % 2 == 0)
                triangles.middleRows(t, 2) << a, b, c, a, c, d;
            else
                triangles.middleRows(t, 2) << a, b, d, b, c, d;
        }
    return triangles;
}

//! The cells mapped by position(u, v), u and v in [0, 1].
template <typename Map>
mesh::TriangleMesh sheet(const Cells& cells, Map position)
{
    const int across = cells.columns + (cells.is_closed_u ? 0 : 1);
    const int along = cells.rows + (cells.is_closed_v ? 0 : 1);
    Points points(across * along, 3);
    for (int j = 0; j < along; ++j)
        for (int i = 0; i < across; ++i)
            points.row(j * across + i) =
                Vector3(position(double(i) / cells.columns, double(j) / cells.rows)).transpose();
    return mesh::TriangleMesh(std::move(points), cell_triangles(cells));
}

//! Flat, from the origin to (lx, ly, 0); (nx + 1)(ny + 1) vertices, rows along x.
inline mesh::TriangleMesh grid(int nx, int ny, double lx, double ly)
{
    return sheet({nx, ny}, [=](double u, double v) { return Vector3(lx * u, ly * v, 0.0); });
}

//! Flat, `length` by 1/4 of it, `nx` by `ny` cells that shrink towards x = 0: x = length * u^power.
inline mesh::TriangleMesh graded_grid(int nx, int ny, double length, double power)
{
    return sheet({nx, ny}, [=](double u, double v)
                 { return Vector3(length * std::pow(u, power), 0.25 * length * v, 0.0); });
}

//! Half a tube along x, `around` by `along` cells.
inline mesh::TriangleMesh half_pipe(int around, int along, double radius, double length)
{
    return sheet(
        {along, around}, [=](double u, double v)
        { return Vector3(length * u, -radius * std::cos(pi * v), radius * std::sin(pi * v)); });
}

//! A tube about the z axis, open at both ends (z = 0 and z = height).
inline mesh::TriangleMesh cylinder(int around, int along, double radius, double height)
{
    return sheet({around, along, true, false},
                 [=](double u, double v) {
                     return Vector3(radius * std::cos(2 * pi * u), radius * std::sin(2 * pi * u),
                                    height * v);
                 });
}

//! A flat ring about the z axis; vertices 0..around-1 are its inner rim.
inline mesh::TriangleMesh annulus(int around, int rings, double inner, double outer)
{
    return sheet({around, rings, true, false},
                 [=](double u, double v)
                 {
                     const double r = inner + (outer - inner) * v;
                     return Vector3(-r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), 0.0);
                 });
}

}  // namespace sheetmorph::shapes
