// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/base/progress.h"
#include "sheetmorph/surface/steel/shell_system.h"

namespace sheetmorph
{

//! What to minimise, and by when to give up.
struct ShellTask
{
    const SurfaceTargets& targets;
    double size = 1.0;       //!< mm, of the part
    double thickness = 1.0;  //!< mm
    Progress progress = {};
};

//! Moves a shell to its minimum: Newton's method with mixed stresses (Garcea and Magisano), whose
//! geometric stiffness takes the stresses that the step before has predicted; where that does not
//! help, the tangent of tension alone with a line search. If the sheet does not settle, it begins
//! again ten and thirty times thinner than its size before it is as thin as it is.
//! \throws Cancelled if the progress callback asks for it
Convergence minimise_shell(ShellSystem& shell, const ShellTask& task);

}  // namespace sheetmorph
