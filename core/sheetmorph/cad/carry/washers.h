// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/carry/face_motions.h"

#include <TopTools_DataMapOfShapeShape.hxx>
#include <memory>

namespace sheetmorph::cad
{

//! A shape whose faces were divided where a part of them moves with a hole.
struct WasheredMesh
{
    //! Faces, edges and vertices that were there keep their numbers, new ones follow them.
    std::shared_ptr<const ShapeMesh> mesh;
    TopTools_DataMapOfShapeShape replaced;  //!< divided faces, what holds them: by what they were
    std::vector<std::pair<TopoDS_Shape, TopoDS_Shape>> washers;  //!< the face that each is of, it
};

struct WasherTolerances
{
    double rigid = 0.0;  //!< of what moves as a face does, mm
    double edge = 0.0;   //!< of a new edge on a curved face, mm
};

//! Divides every face that is not kept along the rings of triangles that go all around one of its
//! borders and move as the face beyond that border does.
//! \returns no mesh if there is nothing to divide
WasheredMesh divide_along_washers(const ShapeMesh& mesh, const Points& result,
                                  const FaceMotions& motions, const WasherTolerances& tolerances);

}  // namespace sheetmorph::cad
