// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/cad_source.h"

#include <NCollection_DataMap.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XSControl_TransferReader.hxx>

namespace sheetmorph::cad
{

//! The names that a STEP file gives to faces, by the face without its placement.
using FaceNames = NCollection_DataMap<TopoDS_Shape, std::string, TopTools_ShapeMapHasher>;

FaceNames face_names_of(const Handle(XSControl_TransferReader) & transfer);

//! How many faces of a STEP or IGES file came to no shape.
int count_lost_faces(const Handle(XSControl_TransferReader) & transfer);

//! The solids of a STEP file of whose faces some came to no shape: what the file calls each, else
//! "#" and its number there.
std::vector<std::string> solids_with_lost_faces(const Handle(XSControl_TransferReader) & transfer);

//! Gives every body the names and colours of its faces; a face without a colour has its body's.
//! Bodies of which the file says neither stay as they are.
void tag_faces(std::vector<NamedShape>& bodies, const FaceNames& names,
               const Handle(XCAFDoc_ColorTool) & colours);

}  // namespace sheetmorph::cad
