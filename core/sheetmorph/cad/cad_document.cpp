// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/cad_document.h"

#include <TDataStd_Name.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <set>

namespace sheetmorph::cad
{

CadDocument::CadDocument()
{
    XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document_);
    // Otherwise writers in other units would interpret the lengths in their unit, not in mm.
    XCAFDoc_DocumentTool::SetLengthUnit(document_, 1.0, UnitsMethods_LengthUnit_Millimeter);
}

CadDocument::~CadDocument()
{
    document_->Main().Root().ForgetAllAttributes();  // nodes of layers refer to each other
    if (document_->IsOpened())
        XCAFApp_Application::GetApplication()->Close(document_);
}

Handle(XCAFDoc_ShapeTool) CadDocument::shapes() const
{
    return XCAFDoc_DocumentTool::ShapeTool(document_->Main());
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
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    const std::size_t last = bytes.find_last_not_of(" \t\r\n");
    return first == std::string::npos ? "" : bytes.substr(first, last - first + 1);
}

bool is_given_name(const std::string& name)
{
    static const std::set<std::string> types = {"",      "COMPOUND", "COMPSOLID", "SOLID",
                                                "SHELL", "FACE",     "ASSEMBLY"};
    for (const char* start : {"=>[", "Open CASCADE STEP translator"})
        if (name.rfind(start, 0) == 0)
            return false;
    return types.count(name) == 0;
}

}  // namespace sheetmorph::cad
