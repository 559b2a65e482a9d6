// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front_kernel.h"

#include <Eigen/Core>
#include <vector>

namespace sheetmorph
{

//! Triangular solves that read the factor once each way, at the speed of the memory; large factors
//! on two threads, each with its own subtrees of the elimination tree.
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
    struct Buffers
    {
        RightSides& x;
        RightSides& above;  // takes what one thread adds to rows above the subtrees
        RightSides& w;      // (widest, 4)
    };
    void forward(const Nodes& nodes, Buffers buffers) const;
    void backward(const Nodes& nodes, Buffers buffers) const;
    void share_subtrees();

    FrontList factor_;
    Nodes mine_;                // fronts of one thread, ascending
    Nodes theirs_;              // of the other; empty where one thread does
    Nodes top_;                 // above both
    std::vector<char> is_top_;  // (slots)
    int widest_ = 0;            // most rows of a front
};

}  // namespace sheetmorph
