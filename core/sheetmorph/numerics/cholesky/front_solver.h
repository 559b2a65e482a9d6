// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front_kernel.h"

#include <Eigen/Core>
#include <vector>

namespace sheetmorph::numerics
{

//! Triangular solves that read the factor once each way for all right sides, at the speed of the
//! memory; of large factors some shares at the same time, each subtrees of the elimination tree.
class FrontSolver
{
public:
    //! (slots, few_sides or many_sides)
    using RightSides = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    using Groups = std::vector<RightSides>;

    explicit FrontSolver(FrontList factor);

    const FrontList& factor() const { return factor_; }

    //! To change values, never the rows.
    FrontList& factor() { return factor_; }

    //! \param x  right sides in, solutions out; all groups of one width
    void solve(Groups& x) const;

private:
    using Nodes = std::vector<int>;
    const Front& front(int index) const { return *factor_.fronts[static_cast<std::size_t>(index)]; }
    void forward(const Nodes& nodes, Groups& x, Groups* above) const;
    void backward(const Nodes& nodes, Groups& x) const;
    std::size_t room_of(const Groups& groups) const;
    void share_subtrees();

    FrontList factor_;
    std::vector<Nodes> shares_;  // fronts, ascending; one share where they are few
    Nodes top_;                  // above all shares
    std::vector<int> top_rows_;  // slots of the fronts above
    std::vector<int> top_row_;   // (slots) row among these or -1
    int widest_ = 0;             // most columns of a front
};

}  // namespace sheetmorph::numerics
