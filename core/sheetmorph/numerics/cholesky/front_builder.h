// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front.h"

namespace sheetmorph::numerics
{

//! What a subtree takes off the rows above it: (below, below) contiguous; above the diagonal
//! undefined.
struct Update
{
    std::unique_ptr<double[]> entries;
    std::size_t room = 0;
};

//! A factor on its way, which all builders share.
struct FrontWork
{
    const FrontPattern& pattern;
    const SparseMatrix& values;
    FrontList& factor;
    std::vector<Update> updates;  //!< by node, where the node above waits for it

    const Front& front(int node) const { return *factor.fronts[static_cast<std::size_t>(node)]; }
};

//! Computes the values of fronts one after the other; every thread has its own.
class FrontBuilder
{
public:
    explicit FrontBuilder(FrontWork& work);

    //! The node's front and its update; its children are done.
    void build(int node);

    //! The update of a subtree whose fronts were taken over.
    void gather(int node);

private:
    std::vector<int> children(int node) const;
    void number_rows(const Front& front, int from);
    void add_entries(int node, Front& front);
    void add_update(int child, const Front& front, Update& update);
    Update zero_update(const Front& front);

    FrontWork& work_;
    const Elimination& elimination_;
    const SeparatorTree& tree_;
    std::vector<int> local_;  // by slot: row of the front in hand, if it has the slot
    std::vector<int> targets_;
    Weights inverse_blocks_;
    std::vector<Update> spare_;  // memory of updates that were taken in
};

}  // namespace sheetmorph::numerics
