// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "surface/cases.h"

namespace sheetmorph::surface::cases
{

// A strip of 100 x 25 mm: held at x = 0, its handle at x = 100.
inline Case strip(int elements = 20)
{
    Case one{"strip", shapes::grid(elements, elements / 4, 100.0, 25.0), {}, {}};
    one.constraints.fixed = {
        region("root", one.mesh, [](const Vector3& p) { return p.x() < 1e-6; })};
    one.constraints.handles = {
        region("tip", one.mesh, [](const Vector3& p) { return p.x() > 100.0 - 1e-6; })};
    one.targets.handles = {RigidMotion{{0.0, 0.0, 10.0}, Vector3::Zero(), Vector3::Zero()}};
    return one;
}

inline Deformation solve(const Case& one)
{
    return SurfaceDeformer(one.mesh, one.constraints).deform(one.targets);
}

}  // namespace sheetmorph::surface::cases
