// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>

namespace sheetmorph::cad
{

//! The text of a STEP file in the form of ISO 10303-21, where writers differ and OpenCASCADE loses
//! data: exponents in capitals, strings not broken over lines, no byte order mark.
//! \returns nothing if the text has this form already
std::optional<std::string> standard_step_text(const std::string& text);

}  // namespace sheetmorph::cad
