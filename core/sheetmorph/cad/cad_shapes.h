// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

namespace sheetmorph
{

//! What a file says of a face besides its surface; empty where it says nothing.
struct FaceTag
{
    std::string name;
    std::string colour;  //!< "#rrggbb"
};

//! A solid, or a shell that belongs to none, placed by its location.
struct NamedShape
{
    std::string name;  //!< unique among those of a file
    TopoDS_Shape shape;
    std::vector<FaceTag> faces = {};  //!< in the order of TopExp::MapShapes, or none
};

//! The solids and free shells of a file; lengths in mm, faces that belong to no shell sewn.
//! \throws InvalidInput if the file cannot be read
std::vector<NamedShape> shapes_of_step(const std::string& path);
std::vector<NamedShape> shapes_of_iges(const std::string& path);
std::vector<NamedShape> shapes_of_brep(const std::string& path, const std::string& name);

//! The same for the text of a BREP file.
std::vector<NamedShape> shapes_of_brep_text(const std::string& text, const std::string& name);

}  // namespace sheetmorph
