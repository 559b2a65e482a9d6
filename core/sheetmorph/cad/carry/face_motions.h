// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/carry/kept_motion.h"
#include "sheetmorph/cad/meshing/shape_mesh.h"

#include <TopoDS_Face.hxx>

namespace sheetmorph::cad
{

//! One a face of a shape; none where it does not keep its surface.
using FaceMotions = std::vector<std::optional<KeptMotion>>;

//! What became of every face, by what the vertices of its mesh did.
//! \param result     (n, 3) positions of the mesh
//! \param tolerance  of a rigid motion, mm
//! \throws InvalidInput if a face has no mesh
FaceMotions face_motions(const ShapeMesh& mesh, const Points& result, double tolerance);

//! A surface where its face stands.
Handle(Geom_Surface) placed_surface(const TopoDS_Face& face);

//! Some rows of points.
Points rows_of(const VertexIds& vertices, const Points& points);

//! Of the size of a mesh at rest: what moves rigidly to within it is rigid, mm.
double rigid_tolerance(const ShapeMesh& mesh);

}  // namespace sheetmorph::cad
