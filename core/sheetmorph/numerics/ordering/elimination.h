// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/ordering/nested_dissection.h"

#include <memory>

namespace sheetmorph::numerics
{

using SparseMatrix = Eigen::SparseMatrix<double>;

//! S^T M S of a whole symmetric matrix M, where S has at most one entry 1 per row: rows of one
//! unknown are added, rows without an unknown are left out.
struct MergedMatrix
{
    std::shared_ptr<const SparseMatrix> whole;  //!< M (n, n), both triangles
    std::vector<int> unknown_of;                //!< (n) 0 .. count - 1; negative for no unknown
    int count = 0;
};

//! Every row is an unknown of its own.
MergedMatrix unmerged(std::shared_ptr<const SparseMatrix> whole);

//! The node of a tree of the whole matrix at which each unknown is eliminated: the lowest one with
//! all its rows below it. A slot identifies an unknown: the place of its first row in the order of
//! the tree. Slots stay the same when other unknowns appear or disappear.
class Elimination
{
public:
    Elimination(MergedMatrix matrix, std::shared_ptr<const SeparatorTree> tree);

    const MergedMatrix& matrix() const { return matrix_; }
    const SeparatorTree& tree() const { return *tree_; }
    int slots() const { return static_cast<int>(tree_->order.size()); }

    //! Rows of the whole matrix of an unknown: [begin, end).
    const int* rows_begin(int unknown) const { return rows_.data() + index(unknown, rows_start_); }
    const int* rows_end(int unknown) const
    {
        return rows_.data() + index(unknown + 1, rows_start_);
    }

    //! Unknowns of a node, in their order: [begin, end).
    const int* own_begin(int node) const { return order_.data() + index(node, own_start_); }
    const int* own_end(int node) const { return order_.data() + index(node + 1, own_start_); }

    int slot_of(int unknown) const { return slot_of_[static_cast<std::size_t>(unknown)]; }

    //! The rank of an unknown in the order of elimination.
    int rank_of(int unknown) const { return rank_of_[static_cast<std::size_t>(unknown)]; }
    int rank_of_slot(int slot) const { return rank_of_slot_[static_cast<std::size_t>(slot)]; }
    int slot_of_rank(int rank) const { return slot_of(order_[static_cast<std::size_t>(rank)]); }

    //! The first rank after those of a node.
    int rank_after(int node) const { return own_start_[static_cast<std::size_t>(node) + 1]; }

    //! (nodes) whether the columns of a node, and all below them, are as in an earlier elimination.
    std::vector<char> unchanged_nodes(const Elimination& earlier) const;

private:
    static std::size_t index(int k, const std::vector<int>& starts)
    {
        return static_cast<std::size_t>(starts[static_cast<std::size_t>(k)]);
    }
    void collect_rows();
    void find_nodes();
    void sort_by_node();
    std::vector<char> same_unknowns(const Elimination& earlier) const;

    MergedMatrix matrix_;
    std::shared_ptr<const SeparatorTree> tree_;
    std::vector<int> rows_, rows_start_;  // by unknown
    std::vector<int> slot_of_;            // by unknown
    std::vector<int> node_of_;            // by unknown
    std::vector<int> order_, own_start_;  // unknowns by node
    std::vector<int> rank_of_;            // by unknown
    std::vector<int> rank_of_slot_;
};

}  // namespace sheetmorph::numerics
