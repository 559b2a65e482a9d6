// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/constrained_minimiser.h"
#include "sheetmorph/surface/operators/unknowns.h"
#include "sheetmorph/surface/rotation/rotation_field.h"

namespace sheetmorph
{

//! Refines a linear answer for large rotations. A smooth ARAP: from the linear answer on, every
//! vertex takes the rotation that fits its edges and its rest rows best (polar factor), then the
//! sheet minimises
//!   sum_r w_r |(D p)_r - R_at(r) (D p_hat)_r|^2 + s sum_ij w_ij |p_i - p_j - (R_i + R_j) / 2
//!   (p_hat_i - p_hat_j)|^2
//! with the same unknowns, on one factor of its own; both steps lower the same energy, so it
//! converges (Sorkine and Alexa 2007). s = 100 / size^2: what bends wider than a tenth of the size
//! is governed by stretch.
class Refinement
{
public:
    //! \param problem  of the linear answer: unknowns and constraints
    Refinement(const RotationFieldInput& input, const QuadraticProblem& problem);

    //! \param asked   offset and constraint targets of the linear answer
    //! \param u       (n, 3) the linear answer's displacements
    //! \returns       how it ended; u (n, 3): the refined ones
    Convergence refine(const ConstrainedMinimiser::Targets& asked, Eigen::MatrixXd& u) const;

private:
    struct Edge
    {
        int a, b;
        double weight;
    };

    // R - I of the rotations nearest to how the sheet turned, by vertex.
    std::vector<Matrix3> fitted_changes(const Points& positions) const;
    Eigen::MatrixXd turned(const std::vector<Matrix3>& changes) const;

    const TriangleMesh& mesh_;
    double size_;  // mm, of what has triangles
    const SurfaceOperators& operators_;
    std::vector<Edge> edges_;
    std::unique_ptr<ConstrainedMinimiser> minimiser_;
};

}  // namespace sheetmorph
