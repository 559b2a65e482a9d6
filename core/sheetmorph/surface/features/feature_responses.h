// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/numerics/cholesky/dense_cholesky.h"
#include "sheetmorph/numerics/constrained_minimiser.h"
#include "sheetmorph/numerics/response/response_fields.h"
#include "sheetmorph/surface/bodies/joints.h"
#include "sheetmorph/surface/rotation/rotation_field.h"
#include "sheetmorph/surface/rotation/smooth_weights.h"

#include <atomic>
#include <mutex>

namespace sheetmorph::surface
{

//! The energy of one pose as a function of the entries of the rotating bodies' motions, minimised
//! over the sheet:
//! sum_x rho_x^T G rho_x + 2 g_x^T rho_x + constant, with rho_x (c) for coordinate x.
struct ReducedEnergy
{
    numerics::Weights stiffness;  //!< G (c, c), symmetric
    Eigen::MatrixXd slope;        //!< g (c, 3)
};

//! Positions of a rotating body's entries among the c. Rotation minus identity is at `turn` + 0, 1,
//! 2 (entry [x, b] in row turn + b, column x); the displacement of its centre is at `shift`. -1:
//! none.
struct TurnerColumns
{
    int turn = -1;
    int shift = -1;
};

//! Responses of the sheet to each entry of the rotating bodies' motions (mathematics.md, section
//! 4). They are computed once and valid for every pose. The reduced energy is available
//! immediately. The displacement fields serve only live frames; they are computed on first use, or
//! immediately if they are small.
class FeatureResponses
{
public:
    FeatureResponses(const RotationFieldInput& input,
                     const numerics::ConstrainedMinimiser& minimiser, std::vector<Turner> turners);

    const std::vector<Turner>& turners() const { return turners_; }
    const std::vector<TurnerColumns>& columns() const { return columns_; }

    //! (n, rotating bodies), see turner_weights().
    const SmoothWeights& weights() const { return weights_; }

    //! \param asked  the targets for which `base` was computed
    //! \param base   the minimum of the pose with all rotating bodies unmoved
    ReducedEnergy energy(const numerics::ConstrainedMinimiser::Targets& asked,
                         const numerics::ConstrainedMinimiser::Solution& base) const;

    //! The two parts of energy(): the stiffness is the same for every pose; the slopes (c, k) are
    //! linear in `base`.
    const numerics::Weights& stiffness() const { return stiffness_; }
    Eigen::MatrixXd slopes(const numerics::ConstrainedMinimiser::Targets& asked,
                           const numerics::ConstrainedMinimiser::Solution& base) const;

    //! Factor of the energy's second derivative at rest, (c, c). nullptr unless all rotating bodies
    //! only rotate, or if it is nearly singular.
    const numerics::DenseCholesky* at_rest() const { return at_rest_ ? &*at_rest_ : nullptr; }

    //! The displacement fields (n, c) with live accuracy; nullptr if they would take too much
    //! memory, then solve instead. Computed at the first call; a second thread waits.
    //! \throws Cancelled on request of the progress callback; completed columns are kept
    const numerics::ResponseFields* fields(const Progress& progress = Progress()) const;

    //! (n, 3) change of the sheet for entries rho (c, 3); nothing before fields() was called.
    std::optional<Eigen::MatrixXd> displacements(const Eigen::MatrixXd& rho) const;

private:
    void number_columns();
    numerics::SparseMatrix direct_moves() const;
    numerics::SparseMatrix turned_rows() const;
    numerics::ConstrainedMinimiser::Targets asked_of(Eigen::Index first, Eigen::Index count) const;
    void find_stiffness();
    void factor_at_rest();
    void respond(Eigen::Index first) const;
    Eigen::MatrixXd slopes(const numerics::ConstrainedMinimiser::Balance& left) const;

    const mesh::TriangleMesh& mesh_;
    const SurfaceConstraints& constraints_;
    const VertexRoles& roles_;
    const SurfaceOperators& operators_;
    const numerics::ConstrainedMinimiser& minimiser_;
    std::vector<Turner> turners_;
    std::vector<TurnerColumns> columns_;
    int count_ = 0;  // number of entries, c
    SmoothWeights weights_;
    numerics::SparseMatrix offsets_;      // (n, c) direct displacements of the columns
    numerics::SparseMatrix turned_rows_;  // (r, c)
    numerics::Weights stiffness_;         // (c, c)
    std::vector<int> unfelt_;             // columns without effect on the energy
    std::optional<numerics::DenseCholesky> at_rest_;
    mutable std::mutex responding_;
    mutable numerics::ResponseFields responses_;  // (n, c) Phi; the columns computed so far
    mutable std::atomic<bool> is_responded_{false};
};

}  // namespace sheetmorph::surface
