// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/base/progress.h"
#include "sheetmorph/surface/steel/shell_system.h"

namespace sheetmorph::surface
{

//! Input of minimise_shell().
struct ShellTask
{
    const SurfaceTargets& targets;
    double size = 1.0;       //!< mm, of the part
    double thickness = 1.0;  //!< mm
    Progress progress = {};
};

//! Moves a shell to its minimum by newton_minimum(). The first model uses mixed stresses (Garcea
//! and Magisano): its geometric stiffness contains the stresses that the previous step predicted.
//! If it fails, the second model includes the largest share of compression for which the tangent is
//! positive definite. Near a saddle point the sheet moves along its first buckling mode.
//! \throws Cancelled on request of the progress callback
Convergence minimise_shell(ShellSystem& shell, const ShellTask& task);

}  // namespace sheetmorph::surface
