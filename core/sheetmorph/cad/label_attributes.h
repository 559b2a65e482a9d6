// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TDF_Label.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <string>
#include <utility>
#include <vector>

namespace sheetmorph::cad
{

//! What became of the parts of a shape.
struct PartImages
{
    TopTools_DataMapOfShapeShape one;
    //! Faces that were divided from others, after the face that each was of.
    std::vector<std::pair<TopoDS_Shape, TopoDS_Shape>> washers;

    //! All that a part is now.
    std::vector<TopoDS_Shape> of(const TopoDS_Shape& part) const;
};

//! Gives a product or component of a document a name in UTF-8.
void set_name(const TDF_Label& label, const std::string& name);

//! Copies colours, layers, material and visibility to a label of another document.
void copy_attributes(const TDF_Label& from, const TDF_Label& to);

//! The same and the names of all faces, edges, ... of a product that have some; their images are in
//! the other product.
void copy_parts(const TDF_Label& from, const TDF_Label& to, const PartImages& images,
                const Handle(XCAFDoc_ShapeTool) & shapes);

}  // namespace sheetmorph::cad
