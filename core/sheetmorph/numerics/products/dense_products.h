// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::numerics
{

//! A dense matrix whose rows are contiguous, such as an (n, m) array of weights.
using Weights = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

//! A part of such a matrix, with contiguous rows.
using WeightsView = Eigen::Ref<const Weights, 0, Eigen::OuterStride<>>;
using WeightsTarget = Eigen::Ref<Weights, 0, Eigen::OuterStride<>>;

//! result += factor * left * right^T, with the widest instructions of the processor.
//! \param left   (r, k)
//! \param right  (s, k)
//! \param result (r, s), must not overlap the others
void add_product(const WeightsView& left, const WeightsView& right, double factor,
                 WeightsTarget result);

//! add_product() for the lower triangle of a square result; undefined above it.
void add_lower_product(const WeightsView& left, const WeightsView& right, double factor,
                       WeightsTarget result);

//! left * right for three columns, in one pass over `left` at the bandwidth of the memory.
//! \param left   (r, k)
//! \param right  (k, 3)
Points narrow_product(const Weights& left, const Points& right);

}  // namespace sheetmorph::numerics
