// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/supernodal_kernel.h"

#include <Eigen/Core>
#include <vector>

namespace sheetmorph
{

//! A supernodal factor L L^T as CHOLMOD lays it out; all of it outlives the solver.
struct SupernodalFactor
{
    int size;                //!< n
    int supernodes;          //!< s
    const int* first;        //!< (s + 1) first column of each supernode
    const int* row_start;    //!< (s + 1) where its row indices begin in `rows`
    const int* entry_start;  //!< (s + 1) where its entries begin in `entries`
    const int* rows;
    const double* entries;
};

//! Triangular solves that read the factor once each way, at the speed of the memory; large factors
//! on two threads, each with its own subtrees of the elimination tree.
class SupernodalSolver
{
public:
    using RightSides = Eigen::Matrix<double, Eigen::Dynamic, right_sides_at_once, Eigen::RowMajor>;

    explicit SupernodalSolver(const SupernodalFactor& factor);

    //! \param x  (n, 4) in the factor's order: right sides in, solutions out
    void solve(RightSides& x) const;

private:
    using Nodes = std::vector<int>;
    Supernode node(int index) const;
    struct Buffers
    {
        RightSides& x;
        RightSides& above;  // takes what one thread adds to rows above the subtrees
        RightSides& w;      // (widest, 4)
    };
    void forward(const Nodes& nodes, Buffers buffers) const;
    void backward(const Nodes& nodes, Buffers buffers) const;
    std::vector<int> parents() const;
    void share_subtrees();

    SupernodalFactor factor_;
    Nodes mine_;                // supernodes of one thread, ascending
    Nodes theirs_;              // of the other; empty where one thread does
    Nodes top_;                 // above both
    std::vector<char> is_top_;  // (n) by column
    int widest_ = 0;            // most rows of a supernode
};

}  // namespace sheetmorph
