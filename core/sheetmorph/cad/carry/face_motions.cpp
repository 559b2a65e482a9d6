// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/carry/face_motions.h"
#include "sheetmorph/base/errors.h"

#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <algorithm>

namespace sheetmorph
{

Points rows_of(const VertexIds& vertices, const Points& points)
{
    Points rows(static_cast<Eigen::Index>(vertices.size()), 3);
    for (std::size_t i = 0; i < vertices.size(); ++i)
        rows.row(static_cast<Eigen::Index>(i)) = points.row(vertices[i]);
    return rows;
}

double rigid_tolerance(const ShapeMesh& mesh)
{
    constexpr double share = 1e-9;
    return share * (mesh.rest.colwise().maxCoeff() - mesh.rest.colwise().minCoeff()).norm();
}

Handle(Geom_Surface) placed_surface(const TopoDS_Face& face)
{
    TopLoc_Location place;
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, place);
    return Handle(Geom_Surface)::DownCast(surface->Transformed(place.Transformation()));
}

FaceMotions face_motions(const ShapeMesh& mesh, const Points& result, double tolerance)
{
    FaceMotions found;
    for (int f = 0; f < mesh.faces.Extent(); ++f)
    {
        VertexIds vertices = mesh.on_face[static_cast<std::size_t>(f)].vertices;
        if (vertices.empty())
            throw InvalidInput("face " + std::to_string(f)
                               + " has no mesh to be carried by; repair it in the CAD system");
        std::sort(vertices.begin(), vertices.end());
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        const Points before = rows_of(vertices, mesh.rest), after = rows_of(vertices, result);
        found.push_back(rigid_fit(before, after, tolerance, false));
        if (!found.back())
            found.back() = resized_fit(before, after, tolerance,
                                       placed_surface(TopoDS::Face(mesh.faces(f + 1))));
    }
    return found;
}

}  // namespace sheetmorph
