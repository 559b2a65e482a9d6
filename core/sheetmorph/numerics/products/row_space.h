// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/products/dense_products.h"

namespace sheetmorph::numerics
{

//! T = left right^T, which is never formed.
struct ProductFactors
{
    const Weights& left;   //!< (r, k)
    const Weights& right;  //!< (n, k)
};

//! Return an orthonormal basis Q (s, n) of the row space of a product T (r, n) of low numerical
//! rank s: T Q^T Q is T to about `tolerance` of its norm. A randomised range finder (Halko,
//! Martinsson, Tropp 2011) with a fixed seed: equal products have equal bases.
//! \param most  the largest s; a product of a larger rank has no rows in its result
Weights row_space(const ProductFactors& product, Eigen::Index most, double tolerance);

}  // namespace sheetmorph::numerics
