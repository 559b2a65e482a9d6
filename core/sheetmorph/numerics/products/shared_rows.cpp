// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/products/shared_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace sheetmorph::numerics
{

namespace
{

// Directions that are looked for at a time: a multiple of the rows of a tile of a dense product.
constexpr Eigen::Index block = 24;

// Of so many sums each row is part, and so many sums are more than there can be directions: else
// one that is left out of the sums by chance would be lost.
constexpr int sums_of_row = 8;
constexpr Eigen::Index spare = 2 * block;

// A reproducible random number (splitmix64).
std::uint64_t next(std::uint64_t& state)
{
    std::uint64_t bits = state += 0x9e3779b97f4a7c15;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
    return bits ^ (bits >> 31);
}

// (count, k) sums of rows with random signs.
Weights random_sums(const Weights& rows, Eigen::Index count)
{
    Weights sums = Weights::Zero(count, rows.cols());
    std::uint64_t state = 1;
    for (Eigen::Index row = 0; row < rows.rows(); ++row)
        for (int k = 0; k < sums_of_row; ++k)
        {
            const std::uint64_t bits = next(state);
            const auto to =
                static_cast<Eigen::Index>((bits >> 1) % static_cast<std::uint64_t>(count));
            if ((bits & 1) != 0)
                sums.row(to) += rows.row(row);
            else
                sums.row(to) -= rows.row(row);
        }
    return sums;
}

//! Orthonormal rows that grow.
class Basis
{
public:
    Basis(Eigen::Index most, Eigen::Index columns) : rows_(most, columns), columns_(columns, most)
    {
    }

    Eigen::Index count() const { return count_; }
    Weights found() const { return rows_.topRows(count_); }

    //! Takes in what rows have beyond the basis, except what is shorter than `least`.
    //! \returns whether there was room for it
    bool take_in(Weights& rows, double least)
    {
        for (int time = 0; time < 2; ++time)  // once leaves rounding of what was taken away
            subtract_shares(rows);
        const Eigen::Index before = count_;
        for (Eigen::Index row = 0; row < rows.rows(); ++row)
        {
            for (int time = 0; time < 2; ++time)
                for (Eigen::Index other = before; other < count_; ++other)
                    rows.row(row) -= rows.row(row).dot(rows_.row(other)) * rows_.row(other);
            const double length = rows.row(row).norm();
            if (length <= least)
                continue;
            if (count_ == rows_.rows())
                return false;
            rows_.row(count_) = rows.row(row) / length;
            columns_.col(count_) = rows_.row(count_).transpose();
            ++count_;
        }
        return true;
    }

private:
    void subtract_shares(Weights& rows) const
    {
        Weights shares = Weights::Zero(rows.rows(), count_);
        add_product(rows, rows_.topRows(count_), 1.0, shares);
        add_product(shares, columns_.leftCols(count_), -1.0, rows);
    }

    Weights rows_, columns_;  // the same, transposed
    Eigen::Index count_ = 0;
};

}  // namespace

Weights shared_rows(const ProductFactors& product, Eigen::Index most, double tolerance)
{
    const Eigen::Index width = product.right.rows();
    const Eigen::Index count = std::min(product.left.cols(), width) + spare;
    const bool are_few = product.left.rows() <= count;
    const Weights sums = are_few ? product.left : random_sums(product.left, count);
    Basis basis(std::min(most, sums.rows()), width);
    double least = 0.0;
    for (Eigen::Index first = 0; first < sums.rows(); first += block)
    {
        Weights rows = Weights::Zero(std::min(block, sums.rows() - first), width);
        add_product(sums.middleRows(first, rows.rows()), product.right, 1.0, rows);
        if (first == 0)
            least = tolerance * rows.rowwise().norm().maxCoeff();
        const Eigen::Index before = basis.count();
        if (!basis.take_in(rows, least))
            return Weights(0, width);
        if (basis.count() == before && !are_few)
            break;  // sums of all rows have nothing more
    }
    return basis.found();
}

}  // namespace sheetmorph::numerics
