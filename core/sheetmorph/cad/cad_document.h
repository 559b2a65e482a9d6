// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TDF_Label.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <string>

namespace sheetmorph::cad
{

//! A document of OpenCASCADE's own application. Its destructor closes it.
class CadDocument
{
public:
    CadDocument();
    ~CadDocument();
    CadDocument(const CadDocument&) = delete;
    CadDocument& operator=(const CadDocument&) = delete;

    const Handle(TDocStd_Document) & handle() const { return document_; }
    Handle(XCAFDoc_ShapeTool) shapes() const;

private:
    Handle(TDocStd_Document) document_;
};

//! The name of a product or component in UTF-8; empty if it has none.
std::string name_of(const TDF_Label& label);

//! Whether the name comes from the file. OpenCASCADE names labels without a name after their type.
bool is_given_name(const std::string& name);

}  // namespace sheetmorph::cad
