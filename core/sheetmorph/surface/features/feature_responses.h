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

//! The energy of one pose in the entries of the turners' motions, everything else minimised:
//! sum_x rho_x^T G rho_x + 2 g_x^T rho_x + constant, with rho_x (c) for coordinate x.
struct ReducedEnergy
{
    numerics::Weights stiffness;  //!< G (c, c), symmetric
    Eigen::MatrixXd slope;        //!< g (c, 3)
};

//! Where a turner's entries are among the c: rotation minus identity at `turn` + 0, 1, 2 (entry
//! [x, b] in row turn + b, column x), displacement of its centre at `shift`; -1: it has none.
struct TurnerColumns
{
    int turn = -1;
    int shift = -1;
};

//! How the sheet answers each entry of the turners' motions (mathematics.md, section 4): computed
//! once, true for every pose. What the energy asks of them is there at once; where the sheet goes,
//! which live frames alone read, is worked out when it is first asked for, unless it takes little.
class FeatureResponses
{
public:
    FeatureResponses(const RotationFieldInput& input,
                     const numerics::ConstrainedMinimiser& minimiser, std::vector<Turner> turners);

    const std::vector<Turner>& turners() const { return turners_; }
    const std::vector<TurnerColumns>& columns() const { return columns_; }

    //! (n, turners) turner_weights().
    const SmoothWeights& weights() const { return weights_; }

    //! \param base  the minimum of the pose with every turner unmoved, and what it was asked for
    ReducedEnergy energy(const numerics::ConstrainedMinimiser::Targets& asked,
                         const numerics::ConstrainedMinimiser::Solution& base) const;

    //! The two parts of it: the stiffness is that of every pose, a slope (c, k) is linear in base.
    const numerics::Weights& stiffness() const { return stiffness_; }
    Eigen::MatrixXd slopes(const numerics::ConstrainedMinimiser::Targets& asked,
                           const numerics::ConstrainedMinimiser::Solution& base) const;

    //! Of the second derivative of the energy at rest, (c, c), where every turner turns and does
    //! nothing else; else, or where it is as good as singular, nothing.
    const numerics::DenseCholesky* at_rest() const { return at_rest_ ? &*at_rest_ : nullptr; }

    //! (n, c) to live accuracy; nothing where the responses would take more memory than they are
    //! worth: solve again instead. Works them out at the first call; a second thread waits.
    //! \throws Cancelled if the progress callback asks for it; what is done is kept for the next
    //! call
    const numerics::ResponseFields* fields(const Progress& progress = Progress()) const;

    //! (n, 3) change of the sheet for entries rho (c, 3), where fields() were asked for.
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
    int count_ = 0;  // c
    SmoothWeights weights_;
    numerics::SparseMatrix offsets_;      // (n, c) what the columns move directly
    numerics::SparseMatrix turned_rows_;  // (r, c)
    numerics::Weights stiffness_;         // (c, c)
    std::vector<int> unfelt_;             // columns that the energy does not feel
    std::optional<numerics::DenseCholesky> at_rest_;
    mutable std::mutex responding_;
    mutable numerics::ResponseFields responses_;  // (n, c) Phi, as far as it is worked out
    mutable std::atomic<bool> is_responded_{false};
};

}  // namespace sheetmorph::surface
