// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/base/threads/stopping.h"
#include "sheetmorph/numerics/ordering/elimination.h"

namespace sheetmorph::numerics
{

//! Slots of the rows of one front, in the order of elimination. Fronts of several factors may share
//! them.
using FrontRows = std::shared_ptr<const std::vector<int>>;

//! The symbolic factorisation: the rows of every front. It depends on the pattern of a matrix, not
//! on its values.
class FrontPattern
{
public:
    //! \param earlier  of the same whole matrix and tree; unchanged fronts share its rows
    explicit FrontPattern(Elimination elimination, const FrontPattern* earlier = nullptr);

    const Elimination& elimination() const { return elimination_; }
    const SeparatorTree& tree() const { return elimination_.tree(); }

    const FrontRows& rows(int node) const { return rows_[static_cast<std::size_t>(node)]; }

    //! Whether the node and all nodes below it are as in the earlier pattern, values included.
    bool is_unchanged(int node) const { return is_unchanged_[static_cast<std::size_t>(node)] != 0; }

    //! Unchanged subtrees below changed nodes.
    const std::vector<int>& unchanged_subtrees() const { return unchanged_; }

    //! Calls visit(worker, node) for all changed nodes, children before their parents. Subtrees run
    //! in parallel, each with its own worker.
    template <typename NewWorker, typename Visit>
    void for_changed(const NewWorker& new_worker, const Visit& visit) const
    {
        parallel_items(static_cast<Eigen::Index>(subtrees_.size()),
                       [&](Eigen::Index k)
                       {
                           const int root = subtrees_[static_cast<std::size_t>(k)];
                           auto worker = new_worker();
                           for (int node = tree().lowest[static_cast<std::size_t>(root)];
                                node <= root; ++node)
                               if (!is_unchanged(node))
                               {
                                   look_for_stop();
                                   visit(worker, node);
                               }
                       });
        auto worker = new_worker();
        for (const int node : top_)
        {
            look_for_stop();
            visit(worker, node);
        }
    }

private:
    void plan();

    Elimination elimination_;
    std::vector<char> is_unchanged_;
    std::vector<int> unchanged_;  // subtrees below changed nodes
    std::vector<int> subtrees_;   // with changed nodes
    std::vector<int> top_;        // nodes above these subtrees, children first
    std::vector<FrontRows> rows_;
};

}  // namespace sheetmorph::numerics
