// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "assembly/frames.h"

namespace sheetmorph::assembly::frames
{

//! Plates with two skins instead of one: the first stands on the lower skin, with contacts picked
//! there, the others on the upper one.
inline Frame thin_solids(Frame frame)
{
    for (std::size_t k = 0; k < frame.assembly.parts.size(); ++k)
    {
        Part& part = frame.assembly.parts[k];
        const int count = part.mesh.vertex_count();
        part.mesh = shapes::two_skinned(part.mesh, 1.0);
        part.thin = Thin::yes;
        for (Contact& contact : frame.assembly.contacts)
            if (k == 0 && contact.a.part == 0)
                for (int& vertex : contact.a.vertices)
                    vertex += count;
    }
    frame.assembly.fixed = {
        side("root", frame.assembly, 0, [](const Vector3& p) { return p.x() < 1e-6; })};
    frame.name = "thin_" + frame.name;
    return frame;
}

}  // namespace sheetmorph::assembly::frames
