// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/cad_source.h"

#include <memory>
#include <string>

namespace sheetmorph::cad
{

//! \throws InvalidInput if the file cannot be read
std::shared_ptr<CadSource> source_of_step(const std::string& path);
std::shared_ptr<CadSource> source_of_iges(const std::string& path);
std::shared_ptr<CadSource> source_of_brep(const std::string& path, const std::string& name);

//! The same for the text of a BREP file.
std::shared_ptr<CadSource> source_of_brep_text(const std::string& text, const std::string& name);

//! The same, by the ending of a path in UTF-8: .step .stp .iges .igs .brep .brp
std::shared_ptr<CadSource> source_of_file(const std::string& path);

}  // namespace sheetmorph::cad
