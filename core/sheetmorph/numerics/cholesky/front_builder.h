// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front.h"
#include "sheetmorph/numerics/elimination.h"

namespace sheetmorph
{

//! What a subtree takes off the rows above it: (below, below) contiguous, lower triangle.
using Update = std::vector<double>;

//! A factor on its way, which all builders share.
struct FrontWork
{
    const Elimination& elimination;
    FrontList& factor;
    std::vector<char> is_kept;    //!< fronts taken over
    std::vector<Update> updates;  //!< by node, where the node above waits for it

    const SeparatorTree& tree() const { return elimination.tree(); }
    const Front& front(int node) const { return *factor.fronts[static_cast<std::size_t>(node)]; }
};

//! Builds fronts one after the other; every thread has its own.
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
    void forget_rows(const Front& front);
    void collect_rows(int node, Front& front);
    void add_rank(int rank, int after);
    void add_entries(int node, Front& front);
    void add_update(int child, const Front& front, Update& update);
    Update zero_update(const Front& front);

    template <typename Use>
    void for_entries(int node, const Use& use) const;

    FrontWork& work_;
    const Elimination& elimination_;
    const SeparatorTree& tree_;
    std::vector<int> local_;  // by slot: row of the front in hand
    std::vector<int> ranks_, targets_;
    Weights inverse_blocks_;
    std::vector<Update> spare_;  // memory of updates that were taken in
};

}  // namespace sheetmorph
