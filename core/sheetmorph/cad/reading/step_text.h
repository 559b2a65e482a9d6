// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>

namespace sheetmorph::cad
{

//! The text of a STEP file as ISO 10303-21 has it, where writers differ and OpenCASCADE loses what
//! they mean: exponents are in capitals, strings are not broken over lines,
//! and there is no byte order mark.
//! \returns nothing if the text is so already
std::optional<std::string> standard_step_text(const std::string& text);

}  // namespace sheetmorph::cad
