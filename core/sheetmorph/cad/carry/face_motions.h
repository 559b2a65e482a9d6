// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/carry/kept_motion.h"
#include "sheetmorph/cad/meshing/shape_mesh.h"

#include <TopoDS_Face.hxx>

namespace sheetmorph::cad
{

//! One entry per face of a shape; empty if the face does not keep its surface.
using FaceMotions = std::vector<std::optional<KeptMotion>>;

//! Determines the motion of every face from the vertices of its mesh.
//! \param result     (n, 3) positions of the mesh
//! \param tolerance  of a rigid motion, mm
//! \throws InvalidInput if a face has no mesh
FaceMotions face_motions(const ShapeMesh& mesh, const Points& result, double tolerance);

//! The surface of a face, placed like the face.
Handle(Geom_Surface) placed_surface(const TopoDS_Face& face);

//! Some rows of points.
Points rows_of(const VertexIds& vertices, const Points& points);

//! Tolerance of rigid motions for a mesh at rest, mm.
double rigid_tolerance(const ShapeMesh& mesh);

}  // namespace sheetmorph::cad
