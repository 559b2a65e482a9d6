// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/base/progress.h"
#include "sheetmorph/surface/steel/shell_movers.h"

namespace sheetmorph::surface
{

//! mm: what is given, or a hundredth of the size where that is 0. The size is the diagonal of the
//! flat rectangle whose area is spread as the sheet's is, so that no axis and no facet counts.
double sheet_thickness(double given, const mesh::TriangleMesh& mesh);

//! A part as a sheet of steel: a geometrically nonlinear thin shell that hardly stretches
//! (mathematics.md, section 9), from the linear answer on. Refined parts of the other energies are
//! the same shell, a third of their size thick.
class SteelAnswer
{
public:
    SteelAnswer(const mesh::TriangleMesh& rest, const SurfaceConstraints& constraints);

    struct Shape
    {
        Points positions;    //!< (n, 3) mm
        Points logs;         //!< (n, 3) rotations of the vertices (2.6)
        BodyMotions bodies;  //!< whole motions
        Convergence convergence = {};
        double energy = 0.0;  //!< over E h, mm^2, of what is not known
    };

    //! \param pose  the linear answer: known vertices are where they have to be
    //! \throws Cancelled if the progress callback asks for it
    Shape solve(const ShellPose& pose, const Progress& progress) const;

private:
    Points measured_logs(const ShellPose& pose, const Points& positions,
                         const BodyMotions& bodies) const;

    ShellMesh mesh_;
    double size_;
    double thickness_;
    double poisson_;
};

}  // namespace sheetmorph::surface
