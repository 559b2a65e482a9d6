// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/quality/pieces.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/mesh/geometry/areas.h"

#include <Eigen/Geometry>
#include <cmath>

namespace sheetmorph::mesh
{

namespace
{

bool is_closed(const EdgeTable& table, const std::vector<int>& triangles)
{
    for (const int t : triangles)
        for (int k = 0; k < 3; ++k)
            if (table.uses(table.edge_of(t, k)).count() == 1)
                return false;
    return true;
}

double area_of(const TriangleMesh& mesh, const std::vector<int>& triangles)
{
    double area = 0.0;
    for (const int t : triangles)
        area += 0.5 * doubled_area(mesh, t).norm();
    return area;
}

// Diagnoses the volume and orientation of a closed piece. Flips `sign` so that the piece faces
// outwards.
void look_inside(const TriangleMesh& mesh, const std::vector<int>& triangles,
                 std::vector<int>& sign, PieceDiagnosis& piece)
{
    const double volume = signed_volume(mesh, triangles, sign);
    if (volume < 0.0)
        for (const int t : triangles)
            sign[t] = -sign[t];
    int outwards = 0;
    for (const int t : triangles)
        outwards += sign[t];
    piece.is_inside_out = outwards < 0;
    piece.volume = std::abs(volume);
    piece.kind = PieceKind::solid;
}

}  // namespace

std::vector<std::vector<int>> triangles_of_pieces(const TriangleMesh& mesh, const EdgeTable& table)
{
    DisjointSets sets(mesh.vertex_count());
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 1; k < 3 && table.edge_of(t, 0) >= 0; ++k)
            sets.join(mesh.triangles()(t, 0), mesh.triangles()(t, k));
    std::vector<int> number(static_cast<std::size_t>(mesh.vertex_count()), -1);
    std::vector<std::vector<int>> pieces;
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        if (table.edge_of(t, 0) < 0)
            continue;
        int& piece = number[sets.root(mesh.triangles()(t, 0))];
        if (piece < 0)
        {
            piece = static_cast<int>(pieces.size());
            pieces.emplace_back();
        }
        pieces[piece].push_back(t);
    }
    return pieces;
}

std::vector<PieceDiagnosis> diagnose_pieces(const TriangleMesh& mesh, const EdgeTable& table)
{
    Orientation orientation = consistent_orientation(mesh, table);
    std::vector<PieceDiagnosis> pieces;
    for (const std::vector<int>& triangles : triangles_of_pieces(mesh, table))
    {
        PieceDiagnosis piece;
        piece.triangles = static_cast<int>(triangles.size());
        piece.area = area_of(mesh, triangles);
        if (is_closed(table, triangles))
            look_inside(mesh, triangles, orientation.sign, piece);
        pieces.push_back(piece);
    }
    return pieces;
}

}  // namespace sheetmorph::mesh
