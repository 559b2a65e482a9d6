// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/sparse_cholesky.h"

#include <vector>

namespace sheetmorph
{

//! Which unknown each vertex takes its value from: one a free vertex, one a rigid body.
struct Unknowns
{
    static constexpr int known = -1;

    std::vector<int> of_vertex;  //!< (n) 0..count-1, or known
    int count = 0;

    //! S (n, count) of u = S y + offset.
    SparseMatrix basis() const;

    //! (count, 3) mean of each unknown's vertices.
    //! \param vertices  (n, 3)
    Points places(const Points& vertices) const;
};

}  // namespace sheetmorph
