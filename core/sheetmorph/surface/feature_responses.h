// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/constrained_minimiser.h"
#include "sheetmorph/surface/joints.h"
#include "sheetmorph/surface/rotation_field.h"
#include "sheetmorph/surface/sizes.h"

namespace sheetmorph
{

//! The energy of one pose in the entries of the turners' motions, everything else minimised:
//! sum_x rho_x^T G rho_x + 2 g_x^T rho_x + constant, with rho_x (c) for coordinate x.
struct ReducedEnergy
{
    Eigen::MatrixXd stiffness;  //!< G (c, c)
    Eigen::MatrixXd slope;      //!< g (c, 3)
};

//! Where a turner's entries are among the c: rotation minus identity at `turn` + 0, 1, 2 (entry
//! [x, b] in row turn + b, column x), displacement of its centre at `shift`; -1: it has none.
struct TurnerColumns
{
    int turn = -1;
    int shift = -1;
};

//! How the sheet answers each entry of the turners' motions (mathematics.md, section 4): computed
//! once, true for every pose.
class FeatureResponses
{
public:
    //! \param shapes  of the resizable form features
    FeatureResponses(const RotationFieldInput& input, const ConstrainedMinimiser& minimiser,
                     std::vector<Turner> turners, const FeatureShapes& shapes);

    const std::vector<Turner>& turners() const { return turners_; }
    const std::vector<TurnerColumns>& columns() const { return columns_; }

    //! (n, turners) turner_weights().
    const SparseMatrix& weights() const { return weights_; }

    //! Every size as at rest.
    SizeChanges no_sizes() const { return SizeChanges(constraints_.features.size()); }

    //! \param base  the minimum of the pose with every turner unmoved, and what it was asked for
    ReducedEnergy energy(const ConstrainedMinimiser::Targets& asked,
                         const ConstrainedMinimiser::Solution& base,
                         const SizeChanges& sizes) const;

    //! (n, 3) change of the sheet for entries rho (c, 3); nothing where the responses would take
    //! more memory than they are worth: solve again instead.
    std::optional<Eigen::MatrixXd> displacements(const Eigen::MatrixXd& rho,
                                                 const SizeChanges& sizes) const;

private:
    struct Resizing
    {
        int feature;
        int turn;   // column of the turner it belongs to
        int first;  // of its six: three grow, three round
    };

    void number_columns(const FeatureShapes& shapes);
    SparseMatrix direct_moves(const FeatureShapes& shapes) const;
    ConstrainedMinimiser::Targets asked_of(Eigen::Index first, Eigen::Index count) const;
    void respond();
    Eigen::MatrixXd slopes(const ConstrainedMinimiser::Balance& left) const;
    SparseMatrix expansion(const SizeChanges& sizes) const;

    const TriangleMesh& mesh_;
    const SurfaceConstraints& constraints_;
    const VertexRoles& roles_;
    const SurfaceOperators& operators_;
    const ConstrainedMinimiser& minimiser_;
    std::vector<Turner> turners_;
    std::vector<TurnerColumns> columns_;
    std::vector<Resizing> resizings_;
    int count_ = 0;     // c
    int extended_ = 0;  // c and the columns of sizes
    SparseMatrix weights_;
    SparseMatrix offsets_;       // (n, extended) what the columns move directly
    Eigen::MatrixXd responses_;  // (n, extended) Phi
    Eigen::MatrixXd stiffness_;  // (extended, extended)
};

}  // namespace sheetmorph
