// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/cad_shapes.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/cad/body_list.h"
#include "sheetmorph/cad/face_tags.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_AsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TransferBRep.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <fstream>
#include <set>
#include <sstream>

namespace sheetmorph
{

namespace
{

// A document of OpenCASCADE's own application, closed at the end.
class Document
{
public:
    Document() { XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document_); }
    ~Document()
    {
        if (document_->IsOpened())
            XCAFApp_Application::GetApplication()->Close(document_);
    }
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    Handle(TDocStd_Document) & handle() { return document_; }

private:
    Handle(TDocStd_Document) document_;
};

std::string trimmed(const std::string& text)
{
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    const std::size_t last = text.find_last_not_of(" \t\r\n");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::string name_of(const TDF_Label& label)
{
    Handle(TDataStd_Name) name;
    if (!label.FindAttribute(TDataStd_Name::GetID(), name))
        return "";
    const TCollection_ExtendedString& text = name->Get();
    std::string bytes(static_cast<std::size_t>(text.LengthOfCString()) + 1, '\0');
    char* start = bytes.data();
    bytes.resize(static_cast<std::size_t>(text.ToUTF8CString(start)));
    return trimmed(bytes);
}

// OpenCASCADE calls what has no name after its type, a reference or itself.
bool is_given(const std::string& name)
{
    static const std::set<std::string> types = {"",      "COMPOUND", "COMPSOLID", "SOLID",
                                                "SHELL", "FACE",     "ASSEMBLY"};
    for (const char* start : {"=>[", "Open CASCADE STEP translator"})
        if (name.rfind(start, 0) == 0)
            return false;
    return types.count(name) == 0;
}

// The assembly a product stands in.
struct Owner
{
    std::string name;
    TopLoc_Location placement;
};

// Goes down an assembly; every product that is none comes out placed.
void collect(const TDF_Label& label, const Owner& owner, BodyList& list,
             const BodyList::BodyName& body_name)
{
    TDF_Label product = label;
    Owner here = owner;
    if (XCAFDoc_ShapeTool::IsReference(label))
    {
        XCAFDoc_ShapeTool::GetReferredShape(label, product);
        here.placement = owner.placement * XCAFDoc_ShapeTool::GetLocation(label);
    }
    for (const TDF_Label& named : {label, product})
        if (const std::string name = name_of(named); is_given(name))
            here.name = name;
    if (!XCAFDoc_ShapeTool::IsAssembly(product))
    {
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(product);
        list.add(shape.Located(here.placement * shape.Location()), here.name, body_name);
        return;
    }
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(product, components);
    for (int i = 1; i <= components.Length(); ++i)
        collect(components.Value(i), here, list, body_name);
}

std::vector<NamedShape> collected(Document& document, const BodyList::BodyName& body_name)
{
    const Handle(XCAFDoc_ShapeTool) tool =
        XCAFDoc_DocumentTool::ShapeTool(document.handle()->Main());
    TDF_LabelSequence roots;
    tool->GetFreeShapes(roots);
    BodyList list;
    for (int i = 1; i <= roots.Length(); ++i)
        collect(roots.Value(i), {}, list, body_name);
    return list.bodies();
}

// Needs a reader to exist: only that makes the parameter known.
template <typename Reader>
void use_millimetres(const Reader&)
{
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
}

}  // namespace

std::vector<NamedShape> shapes_of_step(const std::string& path)
{
    Document document;
    STEPCAFControl_Reader reader;
    use_millimetres(reader);
    reader.SetColorMode(true);
    reader.SetLayerMode(false);
    reader.SetNameMode(true);
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
        throw InvalidInput("it is no STEP file, or a damaged one; export it again");
    if (!reader.Transfer(document.handle()))
        throw InvalidInput("its shapes cannot be read; export it again as AP214 or AP242");
    const Handle(XSControl_TransferReader) transfer = reader.Reader().WS()->TransferReader();
    // The names of solids stand beside them, not in the document.
    const auto name_of_body = [&](const TopoDS_Shape& body) -> std::string
    {
        const TopoDS_Shape unplaced = body.Located(TopLoc_Location());
        const auto item = Handle(StepRepr_RepresentationItem)::DownCast(
            transfer->EntityFromShapeResult(unplaced, 1));
        return item.IsNull() || item->Name().IsNull() ? "" : trimmed(item->Name()->ToCString());
    };
    std::vector<NamedShape> bodies = collected(document, name_of_body);
    tag_faces(bodies, face_names_of(transfer),
              XCAFDoc_DocumentTool::ColorTool(document.handle()->Main()));
    return bodies;
}

std::vector<NamedShape> shapes_of_iges(const std::string& path)
{
    Document document;
    IGESCAFControl_Reader reader;
    use_millimetres(reader);
    reader.SetColorMode(false);
    reader.SetLayerMode(false);
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
        throw InvalidInput("it is no IGES file, or a damaged one; export it again");
    if (!reader.Transfer(document.handle()))
        throw InvalidInput("its shapes cannot be read; export it again, surfaces as trimmed ones");
    return collected(document, {});
}

std::vector<NamedShape> shapes_of_brep(const std::string& path, const std::string& name)
{
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return shapes_of_brep_text(text.str(), name);
}

std::vector<NamedShape> shapes_of_brep_text(const std::string& text, const std::string& name)
{
    // The reader looks for these words, and prints when it does not find them.
    const std::string head = text.substr(0, 4096);
    TopoDS_Shape shape;
    std::istringstream stream(text);
    if (head.find("CASCADE Topology V") != std::string::npos)
        BRepTools::Read(shape, stream, BRep_Builder());
    if (shape.IsNull())
        throw InvalidInput("it is no shape in BREP format, or a damaged one; export it again");
    BodyList list;
    list.add(shape, name, {});
    return list.bodies();
}

}  // namespace sheetmorph
