// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/reading/face_tags.h"

#include <IGESGeom_TrimmedSurface.hxx>
#include <IGESSolid_Face.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Quantity_Color.hxx>
#include <StepShape_ClosedShell.hxx>
#include <StepShape_Face.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_HArray1OfFace.hxx>
#include <StepShape_ManifoldSolidBrep.hxx>
#include <TCollection_AsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>
#include <algorithm>
#include <cctype>

namespace sheetmorph::cad
{

namespace
{

TopoDS_Shape unplaced(const TopoDS_Shape& shape)
{
    return shape.Located(TopLoc_Location());
}

// "#rrggbb"; empty if the file gives the shape no colour.
std::string colour_of(const TopoDS_Shape& shape, const Handle(XCAFDoc_ColorTool) & colours)
{
    Quantity_Color colour;
    for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen})
        if (colours->GetColor(shape, type, colour))
        {
            std::string text = Quantity_Color::ColorToHex(colour).ToCString();
            std::transform(text.begin(), text.end(), text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            return text;
        }
    return "";
}

bool is_said(const FaceTag& tag)
{
    return !tag.name.empty() || !tag.colour.empty();
}

}  // namespace

FaceNames face_names_of(const Handle(XSControl_TransferReader) & transfer)
{
    FaceNames names;
    const Handle(Transfer_TransientProcess) process = transfer->TransientProcess();
    for (int i = 1; !process.IsNull() && i <= process->NbMapped(); ++i)
    {
        const auto face = Handle(StepShape_FaceSurface)::DownCast(process->Mapped(i));
        if (face.IsNull() || face->Name().IsNull())
            continue;
        const std::string name = face->Name()->ToCString();
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process->MapItem(i));
        if (!shape.IsNull() && !name.empty() && name != "NONE")
            names.Bind(unplaced(shape), name);
    }
    return names;
}

int count_lost_faces(const Handle(XSControl_TransferReader) & transfer)
{
    const Handle(Interface_InterfaceModel) model = transfer->Model();
    const Handle(Transfer_TransientProcess) process = transfer->TransientProcess();
    int lost = 0;
    for (int i = 1; !process.IsNull() && i <= model->NbEntities(); ++i)
    {
        const Handle(Standard_Transient) entity = model->Value(i);
        const bool is_face = entity->IsKind(STANDARD_TYPE(StepShape_FaceSurface))
                             || entity->IsKind(STANDARD_TYPE(IGESGeom_TrimmedSurface))
                             || entity->IsKind(STANDARD_TYPE(IGESSolid_Face));
        if (is_face && TransferBRep::ShapeResult(process, entity).IsNull())
            ++lost;
    }
    return lost;
}

std::vector<std::string> solids_with_lost_faces(const Handle(XSControl_TransferReader) & transfer)
{
    const Handle(Interface_InterfaceModel) model = transfer->Model();
    const Handle(Transfer_TransientProcess) process = transfer->TransientProcess();
    std::vector<std::string> found;
    for (int i = 1; !process.IsNull() && i <= model->NbEntities(); ++i)
    {
        const auto solid = Handle(StepShape_ManifoldSolidBrep)::DownCast(model->Value(i));
        if (solid.IsNull())
            continue;
        const auto shell = solid->Outer();
        bool is_whole = !shell.IsNull() && !shell->CfsFaces().IsNull();
        for (int f = 1; is_whole && f <= shell->NbCfsFaces(); ++f)
        {
            const Handle(StepShape_Face) face = shell->CfsFacesValue(f);
            is_whole = !face.IsNull() && !TransferBRep::ShapeResult(process, face).IsNull();
        }
        if (is_whole)
            continue;
        const bool is_named = !solid->Name().IsNull() && !solid->Name()->IsEmpty();
        const Handle(TCollection_HAsciiString) name =
            is_named ? solid->Name() : model->StringLabel(solid);
        found.emplace_back(name->ToCString());
    }
    return found;
}

void tag_faces(std::vector<NamedShape>& bodies, const FaceNames& names,
               const Handle(XCAFDoc_ColorTool) & colours)
{
    TDF_LabelSequence known;
    colours->GetColors(known);
    const bool has_colours = known.Length() > 0;
    for (NamedShape& body : bodies)
    {
        const TopoDS_Shape shape = unplaced(body.shape);
        const std::string own = has_colours ? colour_of(shape, colours) : "";
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(shape, TopAbs_FACE, faces);
        std::vector<FaceTag> tags;
        for (int f = 1; f <= faces.Extent(); ++f)
        {
            const TopoDS_Shape face = unplaced(faces(f));
            FaceTag tag{"", has_colours ? colour_of(face, colours) : ""};
            if (const std::string* name = names.Seek(face))
                tag.name = *name;
            if (tag.colour.empty())
                tag.colour = own;
            tags.push_back(tag);
        }
        if (std::any_of(tags.begin(), tags.end(), is_said))
            body.faces = std::move(tags);
    }
}

}  // namespace sheetmorph::cad
