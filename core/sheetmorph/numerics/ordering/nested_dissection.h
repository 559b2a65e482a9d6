// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <Eigen/SparseCore>
#include <vector>

namespace sheetmorph::numerics
{

//! The rows of a matrix in an order of elimination, divided into the nodes of a tree. Rows of two
//! nodes are coupled only if one node is above the other. Children come before their parents, and
//! every subtree is a range of nodes.
struct SeparatorTree
{
    std::vector<int> order;   //!< (n) rows, node after node
    std::vector<int> first;   //!< (nodes + 1) where each node's rows begin in `order`
    std::vector<int> parent;  //!< (nodes) -1 for the root
    std::vector<int> lowest;  //!< (nodes) the subtree of a node is the range lowest .. node

    int size() const { return static_cast<int>(parent.size()); }

    //! Whether `node` is in the subtree of `above`.
    bool is_below(int node, int above) const
    {
        return lowest[static_cast<std::size_t>(above)] <= node && node <= above;
    }

    //! The lowest node with both in its subtree.
    int common(int a, int b) const;
};

//! For matrices of surfaces with many unknowns. Halves the points across their longest side until
//! few are left, and eliminates two halves before their separator.
//! \param matrix  (n, n), symmetric, both triangles
//! \param places  (n, 3) positions of the rows
SeparatorTree nested_dissection(const Eigen::SparseMatrix<double>& matrix, const Points& places);

}  // namespace sheetmorph::numerics
