// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/body_list.h"
#include "sheetmorph/cad/cad_document.h"

#include <memory>
#include <string>
#include <vector>

namespace sheetmorph
{

//! What was read of a CAD file: its solids and free shells in the order in which its assembly lists
//! them, and the document with names, colours and layers that they stand in.
struct CadSource
{
    std::vector<NamedShape> bodies;  //!< lengths in mm, faces that belong to no shell sewn
    CadDocument document;
    std::string unit = "MM";           //!< of the lengths in the file, as OpenCASCADE names it
    bool is_ap242 = false;             //!< the schema of a STEP file
    int lost_faces = 0;                //!< faces that the file holds and OpenCASCADE could not make
    std::vector<std::string> lost_in;  //!< solids of a STEP file that lack some: name or number
    std::vector<std::string> unread;   //!< entities of a STEP file with values that make no sense
};

//! \throws InvalidInput if the file cannot be read
std::shared_ptr<CadSource> source_of_step(const std::string& path);
std::shared_ptr<CadSource> source_of_iges(const std::string& path);
std::shared_ptr<CadSource> source_of_brep(const std::string& path, const std::string& name);

//! The same for the text of a BREP file.
std::shared_ptr<CadSource> source_of_brep_text(const std::string& text, const std::string& name);

//! The same by the ending of a path in UTF-8: .step .stp .iges .igs .brep .brp
std::shared_ptr<CadSource> source_of_file(const std::string& path);

}  // namespace sheetmorph
