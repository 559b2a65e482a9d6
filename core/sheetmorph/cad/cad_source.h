// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/body_list.h"
#include "sheetmorph/cad/cad_document.h"

#include <string>
#include <vector>

namespace sheetmorph::cad
{

//! The data of a CAD file: its solids and free shells, in the order of its assembly, and the
//! document with their names, colours and layers.
struct CadSource
{
    std::vector<NamedShape> bodies;  //!< lengths in mm; free faces are sewn
    CadDocument document;
    std::string unit = "MM";           //!< of lengths in the file, as OpenCASCADE names it
    bool is_ap242 = false;             //!< schema of a STEP file
    int lost_faces = 0;                //!< faces of the file that OpenCASCADE could not read
    std::vector<std::string> lost_in;  //!< solids that lack some of these faces: name or number
    std::vector<std::string> unread;   //!< entities of a STEP file with impossible values
};

}  // namespace sheetmorph::cad
