// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace sheetmorph
{

//! The largest number accepted, of a coordinate in mm or pixels or of a direction: no sheet is
//! larger, and what is computed from them (areas, volumes, squares of both) stays finite.
constexpr double largest_number = 1e30;

//! Whether all entries are finite numbers and small enough to compute with.
template <typename Derived>
bool are_numbers(const Eigen::MatrixBase<Derived>& entries)
{
    return (entries.array().abs() <= largest_number).all();
}

}  // namespace sheetmorph
