// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/cad_source.h"

#include <NCollection_DataMap.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XSControl_TransferReader.hxx>

namespace sheetmorph::cad
{

//! The names of faces in a STEP file, by the face without its placement.
using FaceNames = NCollection_DataMap<TopoDS_Shape, std::string, TopTools_ShapeMapHasher>;

FaceNames face_names_of(const Handle(XSControl_TransferReader) & transfer);

//! Number of faces of a STEP or IGES file that did not become a shape.
int count_lost_faces(const Handle(XSControl_TransferReader) & transfer);

//! The solids of a STEP file with faces that did not become a shape: their names in the file, else
//! "#" and the number.
std::vector<std::string> solids_with_lost_faces(const Handle(XSControl_TransferReader) & transfer);

//! Sets the names and colours of the faces of every body. A face without a colour takes that of its
//! body. Bodies for which the file has neither do not change.
void tag_faces(std::vector<NamedShape>& bodies, const FaceNames& names,
               const Handle(XCAFDoc_ColorTool) & colours);

}  // namespace sheetmorph::cad
