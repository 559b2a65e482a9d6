// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "shapes/solids.h"

#include <algorithm>

namespace sheetmorph::shapes
{

//! Square cells side by side along x, each with a round hole in its middle.
struct PlateSpec
{
    int holes = 3;
    int rim = 32;          //!< vertices of a rim, a multiple of 8
    int rings = 4;         //!< rings of quads between a rim and the border of its cell
    double cell = 60.0;    //!< side of a cell, mm
    double radius = 12.0;  //!< of the holes, mm
};

struct PlateWithHoles
{
    mesh::TriangleMesh mesh;
    std::vector<VertexIds> rims;  //!< by hole, counter-clockwise from its +x side
    VertexIds left, right;        //!< the border rows x = 0 and x = holes * cell, by rising y
};

//! A point on the border of the square [-1, 1]^2: `turn` in [0, 1) runs counter-clockwise from
//! (1, 0), at constant speed, so that neighbouring cells match.
inline Vector3 on_square(double turn)
{
    const double eighths = 8.0 * turn;
    const int side = static_cast<int>(std::floor((eighths + 1.0) / 2.0)) % 4;
    const double along = eighths + 1.0 - 2.0 * std::floor((eighths + 1.0) / 2.0) - 1.0;
    const Vector3 points[] = {{1, along, 0}, {-along, 1, 0}, {-1, -along, 0}, {along, -1, 0}};
    return points[side];
}

//! The cell of hole k: a polar grid, the square its outer ring and the circle its inner one.
inline mesh::TriangleMesh plate_cell(const PlateSpec& spec, int k)
{
    const double half = 0.5 * spec.cell;
    const Vector3 centre((k + 0.5) * spec.cell, half, 0.0);
    return sheet(
        {spec.rim, spec.rings, true, false},
        [&, centre](double u, double v)
        {
            const Vector3 circle(std::cos(2 * pi * u), std::sin(2 * pi * u), 0.0);
            const double out = 1.0 - v;  // from the border inwards: the normals are along +z
            const double t = std::pow(out, 1.3);
            return Vector3(centre + (1.0 - t) * spec.radius * circle + t * half * on_square(u));
        });
}

//! The vertices that satisfy a condition on their position.
template <typename Condition>
VertexIds vertices_where(const mesh::TriangleMesh& mesh, Condition condition)
{
    VertexIds ids;
    for (int i = 0; i < mesh.vertex_count(); ++i)
        if (condition(Vector3(mesh.points().row(i))))
            ids.push_back(i);
    return ids;
}

//! The vertex at a position, -1 if there is none within 1e-6 mm.
inline int vertex_at(const mesh::TriangleMesh& mesh, const Vector3& position)
{
    int nearest = -1;
    const double distance =
        (mesh.points().rowwise() - position.transpose()).rowwise().norm().minCoeff(&nearest);
    return distance < 1e-6 ? nearest : -1;
}

//! A conforming flat plate in z = 0, normals along +z.
inline PlateWithHoles plate_with_holes(const PlateSpec& spec = {})
{
    PlateWithHoles plate;
    std::vector<mesh::TriangleMesh> cells;
    for (int k = 0; k < spec.holes; ++k)
        cells.push_back(plate_cell(spec, k));
    plate.mesh = welded(cells);
    for (const mesh::TriangleMesh& cell : cells)
    {
        plate.rims.emplace_back();
        for (int i = 0; i < spec.rim; ++i)
            plate.rims.back().push_back(
                vertex_at(plate.mesh, cell.points().row(spec.rim * spec.rings + i)));
    }
    const auto by_height = [&](int a, int b)
    { return plate.mesh.points()(a, 1) < plate.mesh.points()(b, 1); };
    const double end = spec.holes * spec.cell;
    plate.left = vertices_where(plate.mesh, [](const Vector3& p) { return p.x() < 1e-6; });
    plate.right = vertices_where(plate.mesh, [=](const Vector3& p) { return p.x() > end - 1e-6; });
    std::sort(plate.left.begin(), plate.left.end(), by_height);
    std::sort(plate.right.begin(), plate.right.end(), by_height);
    return plate;
}

}  // namespace sheetmorph::shapes
