// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/carry/face_motions.h"

#include <TopTools_DataMapOfShapeShape.hxx>
#include <memory>

namespace sheetmorph::cad
{

//! A shape with faces that were divided because a part of them moves with a hole.
struct WasheredMesh
{
    //! Old faces, edges and vertices keep their numbers; new ones follow.
    std::shared_ptr<const ShapeMesh> mesh;
    TopTools_DataMapOfShapeShape replaced;  //!< divided faces and their owners, by their originals
    std::vector<std::pair<TopoDS_Shape, TopoDS_Shape>> washers;  //!< original face, washer
};

struct WasherTolerances
{
    double rigid = 0.0;  //!< tolerance for moving like a face, mm
    double edge = 0.0;   //!< tolerance of a new edge on a curved face, mm
};

//! Divides every face that does not keep its surface along the rings of triangles that surround one
//! of its borders and move like the face beyond that border.
//! \returns no mesh if there is nothing to divide
WasheredMesh divide_along_washers(const ShapeMesh& mesh, const Points& result,
                                  const FaceMotions& motions, const WasherTolerances& tolerances);

}  // namespace sheetmorph::cad
