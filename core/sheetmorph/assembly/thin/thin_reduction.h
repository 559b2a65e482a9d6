// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/assembly.h"
#include "sheetmorph/assembly/thin/thin_part.h"

#include <memory>

namespace sheetmorph::assembly
{

//! By part of an assembly: its thin solid; nothing if the part is solved as it is.
using ThinParts = std::vector<std::shared_ptr<const ThinPart>>;

//! Recognises the parts that may be thin solids.
//! \param earlier  parts of `earlier_assembly`, or nothing; reused for equal meshes and settings
//! \throws InvalidInput naming a part that must be a thin solid but is not, and the reason
ThinParts find_thin_parts(const Assembly& assembly, const Assembly* earlier_assembly,
                          const ThinParts& earlier);

//! The assembly with every feature of a thin part extended along the walls of its holes, and a
//! further feature for every lump, "cover lump 1", at the end. Features that share vertices become
//! a group.
Assembly with_lumps(Assembly assembly, const ThinParts& thin);

//! The assembly for the solvers: thin parts become their main skins, with regions, features, points
//! and contacts moved to them. If several regions lie over one skin vertex, it belongs to the
//! region that contains it, else to the first.
Assembly reduced_to_skins(const Assembly& whole, const ThinParts& thin);

}  // namespace sheetmorph::assembly
