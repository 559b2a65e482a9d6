// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace sheetmorph
{

//! The largest coordinate, in mm or pixels, or component of a direction. From the range of doubles,
//! 1.8e308: squares of areas (1e120) and of volumes (1e180) stay finite.
constexpr double largest_number = 1e30;

//! Whether all entries are finite and small enough to compute with.
template <typename Derived>
bool are_numbers(const Eigen::MatrixBase<Derived>& entries)
{
    return (entries.array().abs() <= largest_number).all();
}

}  // namespace sheetmorph
