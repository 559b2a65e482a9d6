// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/session/prepared_assembly.h"

namespace sheetmorph::assembly
{

//! The deformer of the sheet of the same name in an earlier session, or nothing.
std::shared_ptr<const surface::SurfaceDeformer> earlier_deformer(const PreparedAssembly* previous,
                                                                 const Sheet& sheet);

//! Whether a deformer is that of a mesh under some constraints.
bool is_deformer_of(const surface::SurfaceDeformer& deformer, const mesh::TriangleMesh& mesh,
                    const surface::SurfaceConstraints& constraints);

//! The link from the same source vertices of the same mesh to the same points, or nothing.
std::shared_ptr<const MotionLink> reusable_link(const PreparedAssembly* previous,
                                                const Part& source, const PreparedLink& wanted);

}  // namespace sheetmorph::assembly
