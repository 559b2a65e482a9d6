// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front.h"

namespace sheetmorph::numerics
{

//! The contribution of a subtree to the rows above it, (below, below), contiguous; undefined above
//! the diagonal.
struct Update
{
    std::unique_ptr<double[]> entries;
    std::size_t room = 0;
};

//! The state of a factorisation, which all builders share.
struct FrontWork
{
    const FrontPattern& pattern;
    const SparseMatrix& values;
    FrontList& factor;
    std::vector<Update> updates;  //!< by node, until the node above uses it

    const Front& front(int node) const { return *factor.fronts[static_cast<std::size_t>(node)]; }
};

//! Computes the values of fronts one after the other; every thread has its own.
class FrontBuilder
{
public:
    explicit FrontBuilder(FrontWork& work);

    //! Computes the node's front and its update. Its children must be complete.
    void build(int node);

    //! Computes the update of a subtree whose fronts come from an earlier factor.
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
    std::vector<int> local_;  // by slot: row of the current front, if it has the slot
    std::vector<int> targets_;
    Weights inverse_blocks_;
    std::vector<Update> spare_;  // memory of used updates
};

}  // namespace sheetmorph::numerics
