// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "shapes/sheets.h"

#include <array>
#include <map>

namespace sheetmorph::shapes
{

//! Several meshes as one, vertices nearer than about 1e-7 mm made one.
inline mesh::TriangleMesh welded(const std::vector<mesh::TriangleMesh>& pieces)
{
    std::map<std::array<long long, 3>, int> found;
    std::vector<Vector3> points;
    std::vector<int> corners;
    for (const mesh::TriangleMesh& piece : pieces)
        for (int k = 0; k < piece.triangles().size(); ++k)
        {
            const Vector3 p = piece.points().row(piece.triangles().data()[k]);
            std::array<long long, 3> key;
            for (int c = 0; c < 3; ++c)
                key[c] = std::llround(p(c) * 1e7 + 0.3137);  // round numbers are off its boundary
            const auto [place, is_new] = found.emplace(key, static_cast<int>(points.size()));
            if (is_new)
                points.push_back(p);
            corners.push_back(place->second);
        }
    Points rows(points.size(), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
        rows.row(i) = points[i].transpose();
    return mesh::TriangleMesh(rows, Eigen::Map<Triangles>(corners.data(), corners.size() / 3, 3));
}

//! The closed surface of a box from the origin to `sides`, n by n cells a side, normals outwards.
inline mesh::TriangleMesh box(int n, const Vector3& sides)
{
    std::vector<mesh::TriangleMesh> faces;
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            faces.push_back(sheet({n, n},
                                  [&](double u, double v)
                                  {
                                      Vector3 p;
                                      p(axis) = end;
                                      p((axis + 1) % 3) = end ? u : v;
                                      p((axis + 2) % 3) = end ? v : u;
                                      return Vector3(p.cwiseProduct(sides));
                                  }));
    return welded(faces);
}

//! A sphere about the origin: an octahedron refined `levels` times; 8 * 4^levels triangles.
inline mesh::TriangleMesh sphere(int levels, double radius)
{
    Points points(6, 3);
    points << 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1;
    Triangles triangles(8, 3);
    triangles << 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5;
    for (int level = 0; level < levels; ++level)
    {
        const int count = static_cast<int>(triangles.rows());
        Points corners(6 * count, 3);
        Triangles finer(4 * count, 3);
        for (int t = 0; t < count; ++t)
        {
            for (int c = 0; c < 3; ++c)
            {
                const Eigen::RowVector3d here = points.row(triangles(t, c));
                const Eigen::RowVector3d next = points.row(triangles(t, (c + 1) % 3));
                corners.row(6 * t + c) = here;
                corners.row(6 * t + 3 + c) = (here + next).normalized();
            }
            finer.middleRows(4 * t, 4) << 0, 3, 5, 3, 1, 4, 5, 4, 2, 3, 4, 5;
            finer.middleRows(4 * t, 4).array() += 6 * t;
        }
        const mesh::TriangleMesh merged = welded({mesh::TriangleMesh(corners, finer)});
        points = merged.points();
        triangles = merged.triangles();
    }
    return mesh::TriangleMesh(points * radius, triangles);
}

//! A closed ring about the z axis: `around` by `across` cells, radii of the ring and of its tube.
inline mesh::TriangleMesh torus(int around, int across, double ring, double tube)
{
    return sheet({around, across, true, true},
                 [=](double u, double v)
                 {
                     const double r = ring + tube * std::cos(2 * pi * v);
                     const double height = tube * std::sin(2 * pi * v);
                     return Vector3(r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), height);
                 });
}

}  // namespace sheetmorph::shapes
