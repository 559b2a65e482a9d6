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

//! The images of the parts of a shape.
struct PartImages
{
    TopTools_DataMapOfShapeShape one;
    //! Pairs of an original face and a face that was divided from it.
    std::vector<std::pair<TopoDS_Shape, TopoDS_Shape>> washers;

    //! All images of a part.
    std::vector<TopoDS_Shape> of(const TopoDS_Shape& part) const;
};

//! Sets the name of a product or component of a document, in UTF-8.
void set_name(const TDF_Label& label, const std::string& name);

//! Copies colours, layers, material and visibility to a label of another document.
void copy_attributes(const TDF_Label& from, const TDF_Label& to);

//! The same, with the names of all named faces, edges, ... of a product. Their images are in the
//! other product.
void copy_parts(const TDF_Label& from, const TDF_Label& to, const PartImages& images,
                const Handle(XCAFDoc_ShapeTool) & shapes);

}  // namespace sheetmorph::cad
