// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/writing/written_file.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/cad/reading/cad_shapes.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IFSelect_ShareOut.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESControl_Controller.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <StepData_StepModel.hxx>
#include <StepSelect_FloatFormat.hxx>
#include <TDF_LabelSequence.hxx>
#include <TopoDS_Compound.hxx>
#include <XSControl_WorkSession.hxx>
#include <map>

namespace sheetmorph::cad
{

namespace
{

// Sets a parameter of OpenCASCADE's writers during its lifetime. Parameters are global to the
// process.
class Setting
{
public:
    Setting(const char* name, const char* value) : name_(name)
    {
        const char* before = Interface_Static::CVal(name);
        before_ = before ? before : "";
        Interface_Static::SetCVal(name, value);
    }
    ~Setting()
    {
        if (!before_.empty())
            Interface_Static::SetCVal(name_, before_.c_str());
    }
    Setting(const Setting&) = delete;
    Setting& operator=(const Setting&) = delete;

private:
    const char* name_;
    std::string before_;
};

// Enough digits for exact radii in inches: 5e-13, relative. OpenCASCADE writes up to 15 characters
// per number.
Handle(StepSelect_FloatFormat) digits()
{
    Handle(StepSelect_FloatFormat) found = new StepSelect_FloatFormat;
    found->SetFormat("%.12E");
    found->SetFormatForRange("%.13f", 0.1, 1000.0);
    found->SetZeroSuppress(true);
    return found;
}

bool write_step(const CadDocument& document, const CadSource& source, const std::string& path,
                double exactness)
{
    STEPCAFControl_Controller::Init();  // makes the parameters known, which a new writer reads
    const Setting unit("write.step.unit", source.unit.c_str());
    const Setting schema("write.step.schema", source.is_ap242 ? "AP242DIS" : "AP214IS");
    const Setting names("write.stepcaf.subshapes.name", "1");
    // Readers recompute curves of edges on faces that deviate by more than the file states. That
    // takes minutes on large splines.
    const Setting mode("write.precision.mode", "User");
    const Setting precision("write.precision.val", std::to_string(exactness).c_str());
    STEPCAFControl_Writer writer;
    writer.SetColorMode(true);
    writer.SetLayerMode(true);
    writer.SetNameMode(true);
    writer.SetMaterialMode(true);
    writer.SetPropsMode(false);
    writer.ChangeWriter().WS()->ShareOut()->AddModifier(digits(), 0);
    // Since 7.8, the setting gives the unit in the file, and lengths are converted to this one.
    writer.ChangeWriter().Model()->SetWriteLengthUnit(millimetres_in(source.unit));
    return writer.Transfer(document.handle(), STEPControl_AsIs)
           && writer.Write(path.c_str()) == IFSelect_RetDone;
}

bool write_iges(const CadDocument& document, const std::string& path)
{
    IGESControl_Controller::Init();
    const Setting solids("write.iges.brep.mode", "1");
    IGESCAFControl_Writer writer;
    writer.SetColorMode(true);
    writer.SetLayerMode(true);
    writer.SetNameMode(true);
    return writer.Transfer(document.handle()) && writer.Write(path.c_str());
}

bool write_brep(const CadDocument& document, const std::string& path)
{
    TDF_LabelSequence roots;
    document.shapes()->GetFreeShapes(roots);
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    for (int i = 1; i <= roots.Length(); ++i)
        builder.Add(all, XCAFDoc_ShapeTool::GetShape(roots.Value(i)));
    const TopoDS_Shape whole =
        roots.Length() == 1 ? XCAFDoc_ShapeTool::GetShape(roots.Value(1)) : all;
    return BRepTools::Write(whole, path.c_str());
}

}  // namespace

double millimetres_in(const std::string& unit)
{
    static const std::map<std::string, double> known = {
        {"INCH", 25.4}, {"MM", 1.0},   {"M", 1000.0},     {"CM", 10.0},    {"KM", 1e6},
        {"FT", 304.8},  {"UM", 0.001}, {"MI", 1609344.0}, {"MIL", 0.0254},
    };
    return known.at(unit);
}

void write_document(const CadDocument& document, const CadSource& source, const CadWriting& writing)
{
    const std::string& path = writing.path;
    const bool is_done = writing.format == CadFormat::step
                             ? write_step(document, source, path, writing.edge_tolerance)
                         : writing.format == CadFormat::iges ? write_iges(document, path)
                                                             : write_brep(document, path);
    if (!is_done)
        throw InvalidInput("the CAD file cannot be written", "check the path and its rights");
}

std::shared_ptr<CadSource> read_document(const std::string& path, CadFormat format)
{
    return format == CadFormat::step   ? source_of_step(path)
           : format == CadFormat::iges ? source_of_iges(path)
                                       : source_of_brep(path, "part");
}

}  // namespace sheetmorph::cad
