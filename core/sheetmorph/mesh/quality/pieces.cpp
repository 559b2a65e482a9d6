// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/quality/pieces.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/mesh/geometry/areas.h"
#include "sheetmorph/mesh/quality/wall_thickness.h"

#include <Eigen/Geometry>
#include <cmath>

namespace sheetmorph
{

namespace
{

// A sheet encloses its thickness times half its area, a rod or a block much less.
constexpr double least_sheet_volume = 0.7;
constexpr double least_sheet_share = 0.7;

// The triangles of every piece, by their first triangle.
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

struct Inside
{
    const TriangleMesh& mesh;
    const PickingTree& tree;
};

// A closed piece: which way it faces as a whole, and whether it is thin. `sign` is turned outwards.
void look_inside(const Inside& inside, const std::vector<int>& triangles, std::vector<int>& sign,
                 PieceDiagnosis& piece)
{
    const double volume = signed_volume(inside.mesh, triangles, sign);
    if (volume < 0.0)
        for (const int t : triangles)
            sign[t] = -sign[t];
    int outwards = 0;
    for (const int t : triangles)
        outwards += sign[t];
    piece.is_inside_out = outwards < 0;
    piece.volume = std::abs(volume);
    piece.kind = PieceKind::solid;
    const WallThickness wall = wall_thickness(inside.mesh, inside.tree, triangles, sign);
    if (wall.share < least_sheet_share
        || piece.volume < least_sheet_volume * 0.5 * wall.median * piece.area)
        return;
    piece.kind = PieceKind::thin_solid;
    piece.thickness = wall.median;
    piece.thinnest = wall.low;
    piece.thickest = wall.high;
}

}  // namespace

std::vector<PieceDiagnosis> diagnose_pieces(const TriangleMesh& mesh, const EdgeTable& table)
{
    Orientation orientation = consistent_orientation(mesh, table);
    const PickingTree tree(mesh);
    std::vector<PieceDiagnosis> pieces;
    for (const std::vector<int>& triangles : triangles_of_pieces(mesh, table))
    {
        PieceDiagnosis piece;
        piece.triangles = static_cast<int>(triangles.size());
        piece.area = area_of(mesh, triangles);
        if (is_closed(table, triangles))
            look_inside({mesh, tree}, triangles, orientation.sign, piece);
        pieces.push_back(piece);
    }
    return pieces;
}

}  // namespace sheetmorph
