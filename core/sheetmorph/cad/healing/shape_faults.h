// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

namespace sheetmorph::cad
{

//! The faults that OpenCASCADE's BRepCheck finds, a few words each: "face 3: its borders cross".
//! Faces are counted from 0. Empty for a valid shape.
std::vector<std::string> shape_faults(const TopoDS_Shape& shape);

}  // namespace sheetmorph::cad
