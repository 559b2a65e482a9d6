// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/assembly.h"
#include "sheetmorph/assembly/thin/thin_part.h"

#include <memory>

namespace sheetmorph::assembly
{

//! By part of an assembly: its thin solid; nothing where it is solved as it is.
using ThinParts = std::vector<std::shared_ptr<const ThinPart>>;

//! Recognises the parts that may be thin solids. \param earlier  parts found for `earlier_assembly`
//! (or nothing): taken over where mesh and wish are the same
//! \throws InvalidInput naming a part that should be a thin solid but is none, and why
ThinParts find_thin_parts(const Assembly& assembly, const Assembly* earlier_assembly,
                          const ThinParts& earlier);

//! The assembly with every feature of a thin part grown along the walls of its holes, and a feature
//! more for every lump: "cover lump 1". They come last. Features that share vertices become a
//! group.
Assembly with_lumps(Assembly assembly, const ThinParts& thin);

//! What the solvers see: the main skin of every thin part, regions, features, points and contacts
//! moved to it. Where several regions would get one skin vertex below them, it stays with the
//! region whose own it is, and else with the first.
Assembly reduced_to_skins(const Assembly& whole, const ThinParts& thin);

}  // namespace sheetmorph::assembly
