// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/sheet_diagnosis.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/mesh/geometry/areas.h"
#include "sheetmorph/mesh/quality/pieces.h"
#include "sheetmorph/mesh/topology/orientation.h"
#include "sheetmorph/recognise/thin/thin_solid.h"

#include <algorithm>
#include <map>

namespace sheetmorph::recognise
{

namespace
{

// Minimum share of a piece's surface that belongs to sheets. The rest is small bodies that touch
// it. Chosen: a piece is a sheet if most of it is.
constexpr double least_share = 0.5;

// Pairs (local thickness of a skin in mm, area it represents in mm^2), ascending.
using Samples = std::vector<std::pair<double, double>>;

Samples thicknesses(const mesh::TriangleMesh& mesh, const ThinSolid& solid,
                    const std::vector<int>& triangles)
{
    Samples found;
    for (const int t : triangles)
        for (int k = 0; k < 3; ++k)
            if (const double local = solid.thicknesses(mesh.triangles()(t, k)); local > 0.0)
                found.emplace_back(local, mesh::doubled_area(mesh, t).norm() / 6.0);
    std::sort(found.begin(), found.end());
    return found;
}

// The thickness below which this share of the area lies, mm.
double quantile(const Samples& samples, double share)
{
    double whole = 0.0, passed = 0.0;
    for (const auto& sample : samples)
        whole += sample.second;
    for (const auto& [local, area] : samples)
        if (passed += area; passed >= share * whole)
            return local;
    return samples.back().first;
}

void look_at(const mesh::TriangleMesh& mesh, const ThinSolid& solid,
             const std::vector<int>& triangles, mesh::PieceDiagnosis& piece)
{
    std::map<double, double> areas;  // mm^2 by thickness of the component; key 0: not a sheet
    for (const int t : triangles)
        areas[solid.of_component[at(solid.component[at(t)])]] +=
            0.5 * mesh::doubled_area(mesh, t).norm();
    if (piece.area - areas[0.0] < least_share * piece.area || areas.size() < 2)
        return;
    areas.erase(0.0);
    const auto largest =
        std::max_element(areas.begin(), areas.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    piece.kind = mesh::PieceKind::thin_solid;
    piece.thickness = piece.thinnest = piece.thickest = largest->first;
    const Samples samples = thicknesses(mesh, solid, triangles);
    if (samples.empty())
        return;
    // Chosen: 5 % at either end are rims, walls and misses.
    piece.thinnest = quantile(samples, 0.05);
    piece.thickest = quantile(samples, 0.95);
}

}  // namespace

mesh::Diagnosis diagnose_sheets(const mesh::TriangleMesh& mesh, double tolerance)
{
    mesh::Diagnosis found = mesh::diagnose(mesh, tolerance);
    const mesh::TriangleMesh merged = mesh::without_cuts(mesh, tolerance);
    const mesh::EdgeTable table(merged);
    const mesh::TriangleMesh whole =
        mesh::oriented(merged, mesh::outward_orientation(merged, table));
    const std::optional<ThinSolid> solid = find_thin_solid(whole).solid;
    if (!solid)
        return found;
    const std::vector<std::vector<int>> pieces = mesh::triangles_of_pieces(merged, table);
    for (std::size_t k = 0; k < pieces.size(); ++k)
        if (found.pieces[k].kind == mesh::PieceKind::solid)
            look_at(whole, *solid, pieces[k], found.pieces[k]);
    return found;
}

}  // namespace sheetmorph::recognise
