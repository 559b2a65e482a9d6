// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/products/row_space.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace sheetmorph::numerics
{

namespace
{

// Rows of the basis found at a time. From dense_products.cpp: a multiple of the rows of a tile.
constexpr Eigen::Index block = 24;

// Every row enters this many random sums: a sparse sign sketch, for which Martinsson and Tropp,
// Randomized Numerical Linear Algebra, 2020, section 9.2, recommend 8. There are more sums than the
// rank can be, so that no direction is lost by chance.
constexpr int sums_of_row = 8;
constexpr Eigen::Index spare = 2 * block;

// Return the next random number (splitmix64).
std::uint64_t next(std::uint64_t& state)
{
    std::uint64_t bits = state += 0x9e3779b97f4a7c15;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
    return bits ^ (bits >> 31);
}

// Return (count, k) sums of rows with random signs.
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

//! Orthonormal rows, extended block by block.
class Basis
{
public:
    Basis(Eigen::Index most, Eigen::Index columns) : rows_(most, columns), columns_(columns, most)
    {
    }

    Eigen::Index count() const { return count_; }
    Weights found() const { return rows_.topRows(count_); }

    //! Extend the basis by the rows' components orthogonal to it that are longer than `least`.
    //! \returns whether the basis had room for them
    bool extend(Weights& rows, double least)
    {
        for (int time = 0; time < 2; ++time)  // the second pass removes the rounding of the first
            project_out(rows);
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
    void project_out(Weights& rows) const
    {
        Weights products = Weights::Zero(rows.rows(), count_);
        add_product(rows, rows_.topRows(count_), 1.0, products);
        add_product(products, columns_.leftCols(count_), -1.0, rows);
    }

    Weights rows_, columns_;  // and its transpose
    Eigen::Index count_ = 0;
};

}  // namespace

Weights row_space(const ProductFactors& product, Eigen::Index most, double tolerance)
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
        if (!basis.extend(rows, least))
            return Weights(0, width);
        if (basis.count() == before && !are_few)
            break;  // random sums have nothing beyond the basis
    }
    return basis.found();
}

}  // namespace sheetmorph::numerics
