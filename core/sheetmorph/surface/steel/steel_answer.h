// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/base/progress.h"
#include "sheetmorph/surface/steel/shell_movers.h"

namespace sheetmorph::surface
{

//! Thickness in mm: the given one, or a hundredth of the size if that is 0. The size is the
//! diagonal of the flat rectangle with the same covariance of its area as the sheet. It depends
//! neither on the axes nor on the facets.
double sheet_thickness(double given, const mesh::TriangleMesh& mesh);

//! A part as a sheet of steel: a geometrically nonlinear, nearly inextensible thin shell
//! (mathematics.md, section 9), solved from the linear result. Refined parts of the other energies
//! are the same shell with a thickness of a twentieth of their size.
class SteelAnswer
{
public:
    SteelAnswer(const mesh::TriangleMesh& rest, const SurfaceConstraints& constraints);

    struct Shape
    {
        Points positions;    //!< (n, 3) mm
        Points logs;         //!< (n, 3) rotations of the vertices (2.6)
        BodyMotions bodies;  //!< full motions
        Convergence convergence = {};
        double energy = 0.0;  //!< divided by E h, mm^2, of the elements that can move
    };

    //! \param pose  the linear result; prescribed vertices are at their targets
    //! \throws Cancelled on request of the progress callback
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
