// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/grid_cholesky.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace sheetmorph::cad
{

Eigen::MatrixXd GridMatrix::times(const Eigen::MatrixXd& values) const
{
    Eigen::MatrixXd found = Eigen::MatrixXd::Zero(values.rows(), values.cols());
    const double* product = products.data();
    for (int place = 0; place < rows * columns; ++place)
        for (int k = 0; k < across; ++k)
            for (int l = 0; l < across; ++l, ++product)
                if (*product != 0.0)
                    found.row(place) +=
                        *product * values.row(place + (k - reach) * columns + l - reach);
    for (const Eigen::Triplet<double>& tie : ties)
    {
        found.row(tie.row()) += tie.value() * values.row(tie.col());
        if (tie.row() != tie.col())
            found.row(tie.col()) += tie.value() * values.row(tie.row());
    }
    return found;
}

double GridMatrix::largest() const
{
    constexpr int here = reach * across + reach;
    double found = 0.0;
    for (int place = 0; place < rows * columns; ++place)
        found = std::max(found, products[static_cast<std::size_t>(place * across * across + here)]);
    return found;
}

GridCholesky::GridCholesky(const GridMatrix& matrix, double shift)
    : matrix_(matrix),
      shift_(shift),
      local_(static_cast<std::size_t>(matrix.rows * matrix.columns), -1)
{
    const Rectangle inner = without_border();
    std::vector<Change> before;
    if (inner.rows > 0 && inner.columns > 0)
        before.push_back(eliminate(inner));
    Block border;
    add_places(border.places, {0, 0, matrix.rows, matrix.columns}, inner);
    border.own = static_cast<Eigen::Index>(border.places.size());
    if (border.own > 0)
        eliminate(std::move(border), before, true);
}

// Rows and columns that are tied to distant ones come last.
GridCholesky::Rectangle GridCholesky::without_border() const
{
    const int in_rows = matrix_.is_tied[0] ? GridMatrix::border : 0;
    const int in_columns = matrix_.is_tied[1] ? GridMatrix::border : 0;
    return {in_rows, in_columns, matrix_.rows - 2 * in_rows, matrix_.columns - 2 * in_columns};
}

void GridCholesky::add_places(std::vector<int>& places, const Rectangle& area,
                              const Rectangle& but) const
{
    const auto is_in = [](int at, int first, int count)
    { return at >= first && at < first + count; };
    for (int row = std::max(area.row, 0); row < std::min(area.row + area.rows, matrix_.rows); ++row)
        for (int column = std::max(area.column, 0);
             column < std::min(area.column + area.columns, matrix_.columns); ++column)
            if (!is_in(row, but.row, but.rows) || !is_in(column, but.column, but.columns))
                places.push_back(row * matrix_.columns + column);
}

GridCholesky::Change GridCholesky::eliminate(const Rectangle& area)
{
    // Chosen, not measured: blocks of 8 by 8 places are small dense matrices of 64 rows.
    constexpr int reach = GridMatrix::reach, most = 8;
    Block block;
    std::vector<Change> before;
    Rectangle strip = area;
    if (std::max(area.rows, area.columns) > most)
    {
        const bool is_by_rows = area.rows >= area.columns;
        const auto first_of = [&](Rectangle& one) -> int&
        { return is_by_rows ? one.row : one.column; };
        const auto count_of = [&](Rectangle& one) -> int&
        { return is_by_rows ? one.rows : one.columns; };
        Rectangle low = area, high = area;
        count_of(low) = (count_of(strip) - reach) / 2;
        first_of(strip) += count_of(low);
        count_of(strip) = reach;
        first_of(high) = first_of(strip) + reach;
        count_of(high) -= count_of(low) + reach;
        before.push_back(eliminate(low));
        before.push_back(eliminate(high));
    }
    add_places(block.places, strip, {});
    block.own = static_cast<Eigen::Index>(block.places.size());
    add_places(
        block.places,
        {area.row - reach, area.column - reach, area.rows + 2 * reach, area.columns + 2 * reach},
        area);
    return eliminate(std::move(block), before, false);
}

GridCholesky::Change GridCholesky::eliminate(Block block, const std::vector<Change>& before,
                                             bool has_ties)
{
    if (!is_definite_)
        return {};
    const auto count = static_cast<Eigen::Index>(block.places.size());
    for (Eigen::Index i = 0; i < count; ++i)
        local_[static_cast<std::size_t>(block.places[static_cast<std::size_t>(i)])] =
            static_cast<int>(i);
    Eigen::MatrixXd front = Eigen::MatrixXd::Zero(count, count);
    add_products(front, block);
    if (has_ties)
        add_ties(front);
    for (const Change& change : before)
        add_change(front, change);
    for (const int place : block.places)
        local_[static_cast<std::size_t>(place)] = -1;

    const Eigen::Index own = block.own, others = count - own;
    Eigen::Ref<Eigen::MatrixXd> corner = front.topLeftCorner(own, own);
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(corner);
    is_definite_ = factor.info() == Eigen::Success;
    auto below = front.bottomLeftCorner(others, own);
    corner.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
    Change change;
    change.places.assign(block.places.begin() + own, block.places.end());
    change.matrix = front.bottomRightCorner(others, others);
    change.matrix.selfadjointView<Eigen::Lower>().rankUpdate(below, -1.0);
    block.factor = front.leftCols(own);
    blocks_.push_back(std::move(block));
    return change;
}

void GridCholesky::add_products(Eigen::MatrixXd& front, const Block& block) const
{
    constexpr int reach = GridMatrix::reach, across = GridMatrix::across;
    for (Eigen::Index i = 0; i < block.own; ++i)
    {
        const int place = block.places[static_cast<std::size_t>(i)];
        const double* product =
            matrix_.products.data() + static_cast<std::ptrdiff_t>(place) * across * across;
        for (int k = 0; k < across; ++k)
            for (int l = 0; l < across; ++l, ++product)
            {
                if (*product == 0.0)
                    continue;
                const int other = place + (k - reach) * matrix_.columns + l - reach;
                if (const int j = local_[static_cast<std::size_t>(other)]; j >= i)
                    front(j, i) += *product;
            }
        front(i, i) += shift_;
    }
}

void GridCholesky::add_ties(Eigen::MatrixXd& front) const
{
    for (const Eigen::Triplet<double>& tie : matrix_.ties)
    {
        const int i = local_[static_cast<std::size_t>(tie.row())];
        const int j = local_[static_cast<std::size_t>(tie.col())];
        front(std::max(i, j), std::min(i, j)) += tie.value();
    }
}

void GridCholesky::add_change(Eigen::MatrixXd& front, const Change& change) const
{
    const auto count = static_cast<Eigen::Index>(change.places.size());
    for (Eigen::Index b = 0; b < count; ++b)
        for (Eigen::Index a = b; a < count; ++a)
        {
            const int i =
                local_[static_cast<std::size_t>(change.places[static_cast<std::size_t>(a)])];
            const int j =
                local_[static_cast<std::size_t>(change.places[static_cast<std::size_t>(b)])];
            front(std::max(i, j), std::min(i, j)) += change.matrix(a, b);
        }
}

Eigen::MatrixXd GridCholesky::solve(const Eigen::MatrixXd& right) const
{
    Eigen::MatrixXd found = right;
    const auto gathered = [&](const Block& block)
    {
        Eigen::MatrixXd values(static_cast<Eigen::Index>(block.places.size()), right.cols());
        for (Eigen::Index i = 0; i < values.rows(); ++i)
            values.row(i) = found.row(block.places[static_cast<std::size_t>(i)]);
        return values;
    };
    const auto scatter = [&](const Block& block, const Eigen::MatrixXd& values)
    {
        for (Eigen::Index i = 0; i < values.rows(); ++i)
            found.row(block.places[static_cast<std::size_t>(i)]) = values.row(i);
    };
    for (const Block& block : blocks_)
    {
        Eigen::MatrixXd values = gathered(block);
        auto own = values.topRows(block.own);
        const Eigen::Index others = values.rows() - block.own;
        block.factor.topRows(block.own).triangularView<Eigen::Lower>().solveInPlace(own);
        values.bottomRows(others) -= block.factor.bottomRows(others) * own;
        scatter(block, values);
    }
    for (auto block = blocks_.rbegin(); block != blocks_.rend(); ++block)
    {
        Eigen::MatrixXd values = gathered(*block);
        auto own = values.topRows(block->own);
        const Eigen::Index others = values.rows() - block->own;
        own -= block->factor.bottomRows(others).transpose() * values.bottomRows(others);
        block->factor.topRows(block->own)
            .triangularView<Eigen::Lower>()
            .transpose()
            .solveInPlace(own);
        scatter(*block, values);
    }
    return found;
}

}  // namespace sheetmorph::cad
