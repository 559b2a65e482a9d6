// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front_kernel.h"

#include <Eigen/Core>
#include <vector>

namespace sheetmorph
{

//! Triangular solves that read the factor once each way, at the speed of the memory; of large
//! factors some shares at the same time, each subtrees of the elimination tree.
class FrontSolver
{
public:
    using RightSides = Eigen::Matrix<double, Eigen::Dynamic, right_sides_at_once, Eigen::RowMajor>;

    explicit FrontSolver(FrontList factor);

    const FrontList& factor() const { return factor_; }

    //! \param x  (slots, 4) right sides in, solutions out
    void solve(RightSides& x) const;

private:
    using Nodes = std::vector<int>;
    const Front& front(int index) const { return *factor_.fronts[static_cast<std::size_t>(index)]; }
    void forward(const Nodes& nodes, RightSides& x, RightSides* above) const;
    void backward(const Nodes& nodes, RightSides& x) const;
    void share_subtrees();

    FrontList factor_;
    std::vector<Nodes> shares_;  // fronts, ascending; one share where they are few
    Nodes top_;                  // above all shares
    std::vector<int> top_rows_;  // slots of the fronts above
    std::vector<int> top_row_;   // (slots) row among these or -1
    int widest_ = 0;             // most rows of a front
};

}  // namespace sheetmorph
