// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/assembly.h"
#include "sheetmorph/base/errors.h"

namespace sheetmorph::assembly
{

//! The entries of the user that an entry of an assembly stands for.
template <typename Entry>
std::vector<Subject> subjects_of(const std::string& kind, const Entry& entry)
{
    return entry.of.empty() ? std::vector<Subject>{{kind, entry.name}} : entry.of;
}

//! "handle 'tip'", about what it stands for.
template <typename Entry>
Text label_of(const std::string& kind, const Entry& entry)
{
    return Text::about(kind + " '" + entry.name + "'", subjects_of(kind, entry));
}

//! The same fault with a part's name in front and its vertices as its file numbers them.
inline InvalidInput in_part(const InvalidInput& fault, const Part& part)
{
    return fault.in_part(part.name, part.ids);
}

}  // namespace sheetmorph::assembly
