// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/reading/cad_shapes.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/threads/stopping.h"
#include "sheetmorph/cad/healing/healing.h"
#include "sheetmorph/cad/reading/face_tags.h"
#include "sheetmorph/cad/reading/step_text.h"
#include "sheetmorph/cad/reading/stop_indicator.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <Interface_Check.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_AsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TransferBRep.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

namespace sheetmorph::cad
{

namespace
{

std::string trimmed(const std::string& text)
{
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    const std::size_t last = text.find_last_not_of(" \t\r\n");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

// The assembly that contains a product.
struct Owner
{
    std::string name;
    TopLoc_Location placement;
};

// Traverses an assembly and collects every product that is not an assembly, with its placement.
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
        if (const std::string name = name_of(named); is_given_name(name))
            here.name = name;
    if (!XCAFDoc_ShapeTool::IsAssembly(product))
    {
        list.add(XCAFDoc_ShapeTool::GetShape(product), here.placement, here.name, body_name);
        return;
    }
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(product, components);
    for (int i = 1; i <= components.Length(); ++i)
        collect(components.Value(i), here, list, body_name);
}

void collect_all(CadSource& source, const BodyList::BodyName& body_name)
{
    TDF_LabelSequence roots;
    source.document.shapes()->GetFreeShapes(roots);
    BodyList list;
    for (int i = 1; i <= roots.Length(); ++i)
        collect(roots.Value(i), {}, list, body_name);
    source.bodies = list.bodies();
}

// The bodies of a source, repaired where possible, with the names of the original bodies.
Healing collect_healed(CadSource& source, const BodyList::BodyName& body_name)
{
    collect_all(source, body_name);
    Healing healing(source);
    const auto name_before = [&](const TopoDS_Shape& body)
    {
        const TopoDS_Shape now = body.Located(TopLoc_Location());
        return body_name(healing.before().IsBound(now) ? healing.before().Find(now) : body);
    };
    if (healing.is_any())
        collect_all(source, body_name ? BodyList::BodyName(name_before) : body_name);
    healing.note(source.bodies);
    return healing;
}

// Requires an existing reader, because only a reader makes the parameter known.
template <typename Reader>
void use_millimetres(const Reader&)
{
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
}

// The common unit of length of a file, by the name that OpenCASCADE's writers use.
std::string unit_of(STEPControl_Reader& reader)
{
    static const std::map<std::string, std::string> known = {
        {"INCH", "INCH"},     {"MILLIMETRE", "MM"}, {"METRE", "M"},
        {"CENTIMETRE", "CM"}, {"KILOMETRE", "KM"},  {"FOOT", "FT"},
        {"MILE", "MI"},       {"MICROMETRE", "UM"}, {"MILLI_INCH", "MIL"},
    };
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    reader.FileUnits(lengths, angles, solid_angles);
    std::string found = "MM";
    for (int i = 1; i <= lengths.Length(); ++i)
    {
        std::string name = lengths.Value(i).ToCString();
        std::transform(name.begin(), name.end(), name.begin(),
                       [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
        const auto unit = known.find(name);
        if (unit == known.end() || (i > 1 && unit->second != found))
            return "MM";
        found = unit->second;
    }
    return found;
}

std::string content_of(const std::string& path)
{
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

// Whether the last line of an IGES file exists, with a T in column 73. OpenCASCADE reads truncated
// files as far as they go.
bool has_iges_end(const std::string& text)
{
    const std::size_t last = text.find_last_not_of(" \t\r\n\x1A" + std::string(1, '\0'));
    if (last == std::string::npos)
        return false;
    const std::size_t before = text.find_last_of("\r\n", last);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    // From the IGES standard: the letter of the section is in column 73.
    constexpr std::size_t column = 72;
    return last >= begin + column && text[begin + column] == 'T';
}

void read_step(STEPCAFControl_Reader& reader, const std::string& path)
{
    use_millimetres(reader);
    reader.SetColorMode(true);
    reader.SetLayerMode(true);
    reader.SetNameMode(true);
    IFSelect_ReturnStatus status = IFSelect_RetVoid;
    if (const std::optional<std::string> text = standard_step_text(content_of(path)))
    {
        std::istringstream stream(*text);
        status = reader.ChangeReader().ReadStream(path.c_str(), stream);
    }
    else
        status = reader.ReadFile(path.c_str());
    if (status != IFSelect_RetDone)
        throw InvalidInput("it is not a STEP file, or it is damaged", "export it again");
}

// The entities of a STEP file that lost values during reading. Entities that lost only a text keep
// their shape. Throws if the text itself was not understood.
std::vector<std::string> unread_entities(const Interface_InterfaceModel& model)
{
    const Handle(Interface_Check) all = model.GlobalCheck(true);
    if (const int fails = all.IsNull() ? 0 : all->NbFails(); fails > 0)
    {
        const std::string first = all->CFail(1);
        if (first.find("yntax") != std::string::npos || first.find("Parsing") != std::string::npos)
            throw InvalidInput("OpenCASCADE finds " + std::to_string(fails)
                                   + " syntax errors and would skip those entities",
                               "export it again (the first: " + first + ")");
    }
    std::vector<std::string> found;
    for (int i = 1; i <= model.NbEntities(); ++i)
    {
        if (!model.IsErrorEntity(i))
            continue;
        const Handle(Interface_Check) check = model.Check(i, true);
        for (int k = 1; k <= check->NbFails(); ++k)
            if (const std::string why = check->CFail(k);
                why.find("not a quoted String") == std::string::npos)
            {
                found.push_back(std::string(model.StringLabel(model.Value(i))->ToCString()) + ": "
                                + why);
                break;
            }
    }
    return found;
}

template <typename Reader>
void transfer(Reader& reader, CadSource& source, const char* todo)
{
    look_for_stop();
    Handle(TDocStd_Document) document = source.document.handle();
    const Handle(StopIndicator) stop = new StopIndicator;
    const bool is_done = reader.Transfer(document, stop->Start());
    look_for_stop();
    if (!is_done)
        throw InvalidInput("its shapes cannot be read", todo);
}

bool names_ap242(const std::string& path)
{
    std::string head(4096, ' ');
    std::ifstream(path, std::ios::binary).read(head.data(), static_cast<int>(head.size()));
    return head.find("AP242") != std::string::npos;
}

std::string ending_of(const std::string& path)
{
    const std::size_t dot = path.find_last_of('.');
    std::string ending = dot == std::string::npos ? "" : path.substr(dot + 1);
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

std::string stem_of(const std::string& path)
{
    const std::size_t slash = path.find_last_of("/\\");
    const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
    return name.substr(0, name.find_last_of('.'));
}

}  // namespace

std::shared_ptr<CadSource> source_of_step(const std::string& path)
{
    const auto source = std::make_shared<CadSource>();
    STEPCAFControl_Reader reader;
    read_step(reader, path);
    look_for_stop();
    source->unread = unread_entities(*reader.Reader().Model());
    source->unit = unit_of(reader.ChangeReader());
    source->is_ap242 = names_ap242(path);
    transfer(reader, *source, "export it again as AP214 or AP242");
    const Handle(XSControl_TransferReader) transferred = reader.Reader().WS()->TransferReader();
    // The names of solids are not in the document.
    const auto name_of_body = [&](const TopoDS_Shape& body) -> std::string
    {
        const TopoDS_Shape unplaced = body.Located(TopLoc_Location());
        const auto item = Handle(StepRepr_RepresentationItem)::DownCast(
            transferred->EntityFromShapeResult(unplaced, 1));
        return item.IsNull() || item->Name().IsNull() ? "" : trimmed(item->Name()->ToCString());
    };
    source->lost_faces = count_lost_faces(transferred);
    if (source->lost_faces > 0)
        source->lost_in = solids_with_lost_faces(transferred);
    const Healing healing = collect_healed(*source, name_of_body);
    FaceNames names = face_names_of(transferred);
    for (TopTools_DataMapOfShapeShape::Iterator it(healing.before()); it.More(); it.Next())
        if (const std::string* name = names.Seek(it.Value()))
            names.Bind(it.Key(), std::string(*name));
    tag_faces(source->bodies, names,
              XCAFDoc_DocumentTool::ColorTool(source->document.handle()->Main()));
    return source;
}

std::shared_ptr<CadSource> source_of_iges(const std::string& path)
{
    if (!has_iges_end(content_of(path)))
        throw InvalidInput("it ends before the last line of an IGES file",
                           "copy or export it again");
    const auto source = std::make_shared<CadSource>();
    IGESCAFControl_Reader reader;
    use_millimetres(reader);
    reader.SetColorMode(true);
    reader.SetLayerMode(true);
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
        throw InvalidInput("it is not an IGES file, or it is damaged", "export it again");
    transfer(reader, *source, "export it again, surfaces as trimmed ones");
    source->lost_faces = count_lost_faces(reader.WS()->TransferReader());
    collect_healed(*source, {});
    return source;
}

std::shared_ptr<CadSource> source_of_brep(const std::string& path, const std::string& name)
{
    return source_of_brep_text(content_of(path), name);
}

std::shared_ptr<CadSource> source_of_brep_text(const std::string& text, const std::string& name)
{
    // The reader searches for these words, and prints a message if it does not find them.
    const std::string head = text.substr(0, 4096);
    TopoDS_Shape shape;
    std::istringstream stream(text);
    if (head.find("CASCADE Topology V") != std::string::npos)
        try
        {
            // Otherwise the reader never ends on a truncated file.
            stream.exceptions(std::ios::failbit);
            BRepTools::Read(shape, stream, BRep_Builder());
        }
        catch (const std::ios::failure&)
        {
            shape.Nullify();
        }
    if (shape.IsNull())
        throw InvalidInput("it is not a BREP file, or it is damaged", "export it again");
    const auto source = std::make_shared<CadSource>();
    const TDF_Label label = source->document.shapes()->AddShape(shape, false, false);
    TDataStd_Name::Set(label, TCollection_ExtendedString(name.c_str(), true));
    collect_healed(*source, {});
    return source;
}

std::shared_ptr<CadSource> source_of_file(const std::string& path)
{
    const std::string ending = ending_of(path);
    if (ending == "step" || ending == "stp")
        return source_of_step(path);
    if (ending == "iges" || ending == "igs")
        return source_of_iges(path);
    if (ending == "brep" || ending == "brp")
        return source_of_brep(path, stem_of(path));
    throw InvalidInput("it is not a CAD file", "use .step, .stp, .iges, .igs, .brep or .brp");
}

}  // namespace sheetmorph::cad
