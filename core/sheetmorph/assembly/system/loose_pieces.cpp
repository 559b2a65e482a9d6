// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/system/loose_pieces.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/mesh/geometry/components.h"
#include "sheetmorph/mesh/search/picking.h"
#include "sheetmorph/surface/bodies/vertex_roles.h"

#include <algorithm>

namespace sheetmorph::assembly
{

namespace
{

// Vertices at which a place beside a piece is searched. Chosen: enough on all its sides, however
// fine it is.
constexpr std::size_t most_samples = 200;

// The triangles outside loose pieces.
mesh::TriangleMesh held_mesh(const mesh::TriangleMesh& mesh, const std::vector<VertexIds>& loose)
{
    std::vector<char> is_loose(at(mesh.vertex_count()), 0);
    for (const VertexIds& piece : loose)
        for (const int vertex : piece)
            is_loose[at(vertex)] = 1;
    Triangles held(mesh.triangle_count(), 3);
    Eigen::Index count = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (!is_loose[at(mesh.triangles()(t, 0))] && !is_loose[at(mesh.triangles()(t, 1))]
            && !is_loose[at(mesh.triangles()(t, 2))])
            held.row(count++) = mesh.triangles().row(t);
    return {mesh.points(), held.topRows(count)};
}

// The constraint that moves each vertex directly; -2 for none.
std::vector<int> movers_of(const mesh::TriangleMesh& mesh,
                           const surface::SurfaceConstraints& constraints)
{
    std::vector<int> mover(at(mesh.vertex_count()), -2);
    for (std::size_t k = 0; k < constraints.handles.size(); ++k)
        for (const int vertex : constraints.handles[k].vertices)
            mover[at(vertex)] = static_cast<int>(k);
    for (const surface::KnownRegion& region : constraints.fixed)
        for (const int vertex : region.vertices)
            mover[at(vertex)] = -1;
    return mover;
}

// The corners of the triangle nearest to a piece, restricted to those with one common mover.
VertexIds place_beside(const VertexIds& piece, const mesh::TriangleMesh& held,
                       const mesh::PickingTree& tree, const std::vector<int>& movers)
{
    std::optional<mesh::Hit> nearest;
    const std::size_t step = std::max<std::size_t>(1, piece.size() / most_samples);
    for (std::size_t k = 0; k < piece.size(); k += step)
    {
        const std::optional<mesh::Hit> hit =
            tree.nearest_point(held.points().row(piece[k]).transpose());
        if (hit && (!nearest || hit->distance < nearest->distance))
            nearest = hit;
    }
    if (!nearest)
        return {};
    VertexIds corners;
    Eigen::Index most = 0;
    nearest->barycentric.maxCoeff(&most);
    const int first = held.triangles()(nearest->triangle, most);
    for (int k = 0; k < 3; ++k)
        if (const int corner = held.triangles()(nearest->triangle, k);
            movers[at(corner)] == movers[at(first)])
            corners.push_back(corner);
    return corners;
}

void send_along(Sheet& sheet)
{
    const mesh::TriangleMesh& mesh = sheet.mesh;
    surface::SurfaceConstraints& surface = sheet.surface;
    const mesh::TriangleMesh held = held_mesh(mesh, sheet.loose);
    const mesh::PickingTree tree(held);
    const std::vector<int> movers = movers_of(mesh, surface);
    for (const VertexIds& piece : sheet.loose)
    {
        surface::FormFeature body{"around vertex " + std::to_string(piece.front()),
                                  piece,
                                  surface::FeatureRotation::interpolated,
                                  "loose piece",
                                  {},
                                  false,
                                  sheet.of};
        const VertexIds beside = place_beside(piece, held, tree, movers);
        body.vertices.insert(body.vertices.end(), beside.begin(), beside.end());
        surface.features.push_back(std::move(body));
    }
}

}  // namespace

void hold_loose_pieces(Unheld unheld, Sheet& sheet)
{
    if (unheld == Unheld::refuse || !sheet.is_driven()
        || mesh::connected_components(sheet.mesh).count < 2)
        return;
    surface::SurfaceConstraints& surface = sheet.surface;
    try
    {
        sheet.loose = surface::unheld_components(sheet.mesh, surface);
    }
    catch (const InvalidInput& fault)
    {
        throw in_sheet(fault, sheet);
    }
    if (sheet.loose.empty())
        return;
    if (unheld == Unheld::along)
        return send_along(sheet);
    surface::KnownRegion rest{"loose pieces", {}, "region", false, sheet.of};
    for (const VertexIds& piece : sheet.loose)
        rest.vertices.insert(rest.vertices.end(), piece.begin(), piece.end());
    surface.fixed.push_back(std::move(rest));
}

}  // namespace sheetmorph::assembly
