// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/products/dense_products.h"

namespace sheetmorph::numerics
{

//! The factors of a product whose rows lie in few directions.
struct ProductFactors
{
    const Weights& left;   //!< (r, k)
    const Weights& right;  //!< (n, k)
};

//! An orthonormal basis Q (s, n) of the directions that the rows of T = left right^T lie in:
//! T Q^T Q is T to `tolerance` of its size. Found from random sums of the rows (randomised range
//! finder, Halko, Martinsson and Tropp 2011), always the same ones.
//! \param most  no rows are returned where more directions would be needed
Weights shared_rows(const ProductFactors& product, Eigen::Index most, double tolerance);

}  // namespace sheetmorph::numerics
