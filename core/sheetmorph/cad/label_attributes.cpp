// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/label_attributes.h"
#include "sheetmorph/cad/cad_document.h"

#include <Quantity_ColorRGBA.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDataStd_TreeNode.hxx>
#include <XCAFDoc.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_Material.hxx>
#include <XCAFDoc_MaterialTool.hxx>

namespace sheetmorph::cad
{

namespace
{

void copy_colours(const TDF_Label& from, const TDF_Label& to)
{
    const Handle(XCAFDoc_ColorTool) old = XCAFDoc_DocumentTool::ColorTool(from);
    const Handle(XCAFDoc_ColorTool) tool = XCAFDoc_DocumentTool::ColorTool(to);
    for (const XCAFDoc_ColorType type : {XCAFDoc_ColorGen, XCAFDoc_ColorSurf, XCAFDoc_ColorCurv})
        if (Quantity_ColorRGBA colour; old->GetColor(from, type, colour))
            tool->SetColor(to, colour, type);
    if (!old->IsVisible(from))
        tool->SetVisibility(to, false);
}

void copy_layers(const TDF_Label& from, const TDF_Label& to)
{
    const Handle(TColStd_HSequenceOfExtendedString) layers =
        XCAFDoc_DocumentTool::LayerTool(from)->GetLayers(from);
    if (layers.IsNull())
        return;
    for (int i = 1; i <= layers->Length(); ++i)
        XCAFDoc_DocumentTool::LayerTool(to)->SetLayer(to, layers->Value(i));
}

void copy_material(const TDF_Label& from, const TDF_Label& to)
{
    Handle(TDataStd_TreeNode) node;
    Handle(XCAFDoc_Material) material;
    if (!from.FindAttribute(XCAFDoc::MaterialRefGUID(), node) || !node->HasFather()
        || !node->Father()->Label().FindAttribute(XCAFDoc_Material::GetID(), material))
        return;
    XCAFDoc_DocumentTool::MaterialTool(to)->SetMaterial(
        to, material->GetName(), material->GetDescription(), material->GetDensity(),
        material->GetDensName(), material->GetDensValType());
}

}  // namespace

void set_name(const TDF_Label& label, const std::string& name)
{
    if (!name.empty())
        TDataStd_Name::Set(label, TCollection_ExtendedString(name.c_str(), true));
}

void copy_attributes(const TDF_Label& from, const TDF_Label& to)
{
    copy_colours(from, to);
    copy_layers(from, to);
    copy_material(from, to);
}

std::vector<TopoDS_Shape> PartImages::of(const TopoDS_Shape& part) const
{
    std::vector<TopoDS_Shape> found;
    if (one.IsBound(part))
        found.push_back(one.Find(part));
    for (const auto& [whole, washer] : washers)
        if (whole.IsSame(part))
            found.push_back(washer);
    return found;
}

void copy_parts(const TDF_Label& from, const TDF_Label& to, const PartImages& images,
                const Handle(XCAFDoc_ShapeTool) & shapes)
{
    TDF_LabelSequence parts;
    XCAFDoc_ShapeTool::GetSubShapes(from, parts);
    for (int i = 1; i <= parts.Length(); ++i)
    {
        const TopoDS_Shape part = XCAFDoc_ShapeTool::GetShape(parts.Value(i));
        if (part.IsNull())
            continue;
        for (const TopoDS_Shape& image : images.of(part))
            if (const TDF_Label made = shapes->AddSubShape(to, image); !made.IsNull())
            {
                copy_attributes(parts.Value(i), made);
                set_name(made, name_of(parts.Value(i)));
            }
    }
}

}  // namespace sheetmorph::cad
