// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/cad_source.h"
#include "sheetmorph/cad/writing/cad_writer.h"

namespace sheetmorph::cad
{

//! Writes a document; a STEP file says that it is exact to the edge tolerance.
//! \param source  which has the unit and schema that the file shall have, too
//! \throws InvalidInput if it cannot be written
//! How long a unit is that OpenCASCADE names so.
double millimetres_in(const std::string& unit);

void write_document(const CadDocument& document, const CadSource& source,
                    const CadWriting& writing);

//! Reads it again.
std::shared_ptr<CadSource> read_document(const std::string& path, CadFormat format);

}  // namespace sheetmorph::cad
