// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/base/progress.h"
#include "sheetmorph/surface/steel/shell_system.h"

namespace sheetmorph::surface
{

//! What to minimise, and by when to give up.
struct ShellTask
{
    const SurfaceTargets& targets;
    double size = 1.0;       //!< mm, of the part
    double thickness = 1.0;  //!< mm
    Progress progress = {};
};

//! Moves a shell to its minimum by newton_minimum(). The first model has mixed stresses (Garcea and
//! Magisano): its geometric stiffness takes the stresses that the step before has predicted. Where
//! it does not help, as much of the compression counts as leaves the tangent positive definite, and
//! near a saddle the sheet moves along its first buckling mode.
//! \throws Cancelled if the progress callback asks for it
Convergence minimise_shell(ShellSystem& shell, const ShellTask& task);

}  // namespace sheetmorph::surface
