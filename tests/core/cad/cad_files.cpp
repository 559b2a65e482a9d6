// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cad_files.h"

#include "sheetmorph/cad/cad_document.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <IGESControl_Writer.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <filesystem>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <stdlib.h>
#include <vector>

namespace sheetmorph::cad::test
{

namespace
{

TopoDS_Shape cylinder(const gp_Pnt& foot, double radius, double height)
{
    return BRepPrimAPI_MakeCylinder(gp_Ax2(foot, gp_Dir(0, 0, 1)), radius, height).Shape();
}

TopoDS_Shape plate()
{
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(60.0, 40.0, 2.0).Shape();
    const TopoDS_Shape one = BRepAlgoAPI_Cut(box, cylinder({15, 20, -1}, 3.0, 4.0)).Shape();
    return BRepAlgoAPI_Cut(one, cylinder({40, 20, -1}, 5.0, 4.0)).Shape();
}

TopoDS_Shape upper_face(const TopoDS_Shape& shape)
{
    TopoDS_Shape found;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    {
        double low = 1e9;
        for (TopExp_Explorer v(it.Current(), TopAbs_VERTEX); v.More(); v.Next())
            low = std::min(low, BRep_Tool::Pnt(TopoDS::Vertex(v.Current())).Z());
        if (low > 1.9)
            found = it.Current();
    }
    return found;
}

TopoDS_Compound compound(const std::vector<TopoDS_Shape>& shapes)
{
    TopoDS_Compound all;
    BRep_Builder builder;
    builder.MakeCompound(all);
    for (const TopoDS_Shape& shape : shapes)
        builder.Add(all, shape);
    return all;
}

}  // namespace

TemporaryFolder::TemporaryFolder()
{
    std::string pattern = (std::filesystem::temp_directory_path() / "cadXXXXXX").string();
    path_ = mkdtemp(pattern.data());
    Message::DefaultMessenger()->ChangePrinters().Clear();
}

TemporaryFolder::~TemporaryFolder()
{
    std::filesystem::remove_all(path_);
}

void write_plate_step(const std::string& path)
{
    STEPControl_Writer writer;
    writer.Transfer(plate(), STEPControl_AsIs);
    writer.Write(path.c_str());
}

void write_plate_iges(const std::string& path)
{
    IGESControl_Writer writer("MM", 0);
    writer.AddShape(plate());
    writer.Write(path.c_str());
}

void write_plate_brep(const std::string& path)
{
    BRepTools::Write(plate(), path.c_str());
}

void write_sheet_and_ball_brep(const std::string& path)
{
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(100, 0, 0), 4.0).Shape();
    BRepTools::Write(compound({upper_face(plate()), ball}), path.c_str());
}

void write_assembly_step(const std::string& path)
{
    const CadDocument own;
    const Handle(TDocStd_Document) document = own.handle();
    const auto tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const TDF_Label root = tool->NewShape();
    TDataStd_Name::Set(root, "fixture");
    const TDF_Label plate_label = tool->AddShape(plate(), false);
    const TDF_Label pin_label = tool->AddShape(cylinder({0, 0, 0}, 3.0, 8.0), false);
    TDataStd_Name::Set(plate_label, "plate");
    TDataStd_Name::Set(pin_label, "pin");
    gp_Trsf upright, lying;
    upright.SetTranslation(gp_Vec(15, 20, -3));
    lying.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)), M_PI / 2);
    lying.SetTranslationPart(gp_Vec(40, 20, -3));
    tool->AddComponent(root, plate_label, TopLoc_Location());
    tool->AddComponent(root, pin_label, TopLoc_Location(upright));
    tool->AddComponent(root, pin_label, TopLoc_Location(lying));
    tool->UpdateAssemblies();
    STEPCAFControl_Writer writer;
    writer.Transfer(document);
    writer.Write(path.c_str());
}

void write_coloured_step(const std::string& path)
{
    const CadDocument own;
    const Handle(TDocStd_Document) document = own.handle();
    const auto tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const auto colours = XCAFDoc_DocumentTool::ColorTool(document->Main());
    const TopoDS_Shape sheet = plate();
    const TDF_Label label = tool->AddShape(sheet, false);
    TDataStd_Name::Set(label, "sheet");
    colours->SetColor(label, Quantity_NOC_RED, XCAFDoc_ColorSurf);
    colours->SetColor(tool->AddSubShape(label, upper_face(sheet)), Quantity_NOC_BLUE1,
                      XCAFDoc_ColorSurf);
    XCAFDoc_DocumentTool::LayerTool(document->Main())->SetLayer(label, "sheets");
    const TDF_Label pins = tool->AddShape(
        compound({cylinder({100, 0, 0}, 3.0, 8.0), cylinder({120, 0, 0}, 3.0, 8.0)}), false);
    pins.ForgetAttribute(TDataStd_Name::GetID());
    STEPCAFControl_Writer writer;
    writer.SetLayerMode(true);
    writer.Transfer(document);
    writer.Write(path.c_str());
}

void write_bend_brep(const std::string& path)
{
    const gp_Ax2 axis(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
    const TopoDS_Shape outer = BRepPrimAPI_MakeCylinder(axis, 2.0, 30.0, M_PI / 2).Shape();
    const TopoDS_Shape inner = BRepPrimAPI_MakeCylinder(axis, 1.0, 30.0, M_PI / 2).Shape();
    TopoDS_Shape strip = BRepAlgoAPI_Cut(outer, inner).Shape();
    strip = BRepAlgoAPI_Fuse(strip, BRepPrimAPI_MakeBox(gp_Pnt(-20, 1, 0), 20, 1, 30).Shape());
    strip = BRepAlgoAPI_Fuse(strip, BRepPrimAPI_MakeBox(gp_Pnt(1, -20, 0), 1, 20, 30).Shape());
    BRepTools::Write(strip, path.c_str());
}

void write_solids_brep(const std::string& path)
{
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(6.0, 0.0, 12.0).Shape();
    const gp_Ax2 beside(gp_Pnt(40, 0, 0), gp_Dir(0, 0, 1));
    const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(beside, 8.0, 2.0).Shape();
    const TopoDS_Shape pin = cylinder({80, 0, 0}, 5.0, 10.0);
    const TopoDS_Shape spline = BRepBuilderAPI_NurbsConvert(pin).Shape();
    BRepTools::Write(compound({cone, ring, spline}), path.c_str());
}

}  // namespace sheetmorph::cad::test
