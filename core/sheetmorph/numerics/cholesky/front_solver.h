// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front_kernel.h"

#include <Eigen/Core>
#include <vector>

namespace sheetmorph::numerics
{

//! Triangular solves that read the factor once in each direction for all right-hand sides, at the
//! bandwidth of the memory. Several threads read large factors, each a share of the subtrees of the
//! elimination tree.
class FrontSolver
{
public:
    //! (slots, few_sides or many_sides)
    using RightSides = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    using Groups = std::vector<RightSides>;

    explicit FrontSolver(FrontList factor);

    const FrontList& factor() const { return factor_; }

    //! Access to change values, never rows.
    FrontList& factor() { return factor_; }

    //! \param x  right-hand sides on input, solutions on output; all groups of one width
    void solve(Groups& x) const;

private:
    using Nodes = std::vector<int>;
    const Front& front(int index) const { return *factor_.fronts[static_cast<std::size_t>(index)]; }
    void forward(const Nodes& nodes, Groups& x, Groups* above) const;
    void backward(const Nodes& nodes, Groups& x) const;
    std::size_t room_of(const Groups& groups) const;
    void share_subtrees();

    FrontList factor_;
    std::vector<Nodes> shares_;  // fronts, ascending; a single share if they are few
    Nodes top_;                  // fronts above all shares
    std::vector<int> top_rows_;  // slots of these fronts
    std::vector<int> top_row_;   // (slots) row among these; -1 for none
    int widest_ = 0;             // most columns of a front
};

}  // namespace sheetmorph::numerics
