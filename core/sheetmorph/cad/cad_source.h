// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/body_list.h"
#include "sheetmorph/cad/cad_document.h"

#include <string>
#include <vector>

namespace sheetmorph::cad
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

}  // namespace sheetmorph::cad
