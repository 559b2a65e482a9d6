// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/cad_source.h"
#include "sheetmorph/cad/writing/cad_writer.h"

namespace sheetmorph::cad
{

//! The length of a unit, by the name that OpenCASCADE gives it, mm.
double millimetres_in(const std::string& unit);

//! Writes a document. A STEP file states the edge tolerance as its accuracy.
//! \param source  gives unit and schema of the file
//! \throws InvalidInput if it cannot be written
void write_document(const CadDocument& document, const CadSource& source,
                    const CadWriting& writing);

//! Reads a written file.
std::shared_ptr<CadSource> read_document(const std::string& path, CadFormat format);

}  // namespace sheetmorph::cad
