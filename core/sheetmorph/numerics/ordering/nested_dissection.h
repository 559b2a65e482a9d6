// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <Eigen/SparseCore>
#include <vector>

namespace sheetmorph::numerics
{

//! Rows of a matrix in an order of elimination, cut into nodes of a tree: rows of two nodes are
//! coupled only if one node is above the other. Children come before their parents, and every
//! subtree is one range of nodes.
struct SeparatorTree
{
    std::vector<int> order;   //!< (n) rows, node after node
    std::vector<int> first;   //!< (nodes + 1) where each node's rows begin in `order`
    std::vector<int> parent;  //!< (nodes) -1 for the root
    std::vector<int> lowest;  //!< (nodes) the subtree of a node is lowest .. node

    int size() const { return static_cast<int>(parent.size()); }

    //! Whether `node` is in the subtree of `above`.
    bool is_below(int node, int above) const
    {
        return lowest[static_cast<std::size_t>(above)] <= node && node <= above;
    }

    //! The lowest node that has both in its subtree.
    int common(int a, int b) const;
};

//! For matrices of surfaces with many unknowns: halves the points across their longest side until
//! few are left, and eliminates the two halves before what separates them.
//! \param matrix  (n, n), symmetric, both triangles
//! \param places  (n, 3) where the rows lie
SeparatorTree nested_dissection(const Eigen::SparseMatrix<double>& matrix, const Points& places);

}  // namespace sheetmorph::numerics
