// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/front_builder.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/stopping.h"
#include "sheetmorph/numerics/cholesky/dense_cholesky.h"

#include <algorithm>

namespace sheetmorph::numerics
{

namespace
{

// Number of updates whose memory is kept for the next ones. Chosen, not measured: more would keep
// memory that only few later updates fit.
constexpr std::size_t most_spare = 6;

Eigen::Map<Weights> square(Update& update, int rows)
{
    return {update.entries.get(), rows, rows};
}

}  // namespace

FrontBuilder::FrontBuilder(FrontWork& work)
    : work_(work),
      elimination_(work.pattern.elimination()),
      tree_(work.pattern.tree()),
      local_(at(elimination_.slots()), 0)
{
}

void FrontBuilder::build(int node)
{
    Front& front = *work_.factor.fronts[at(node)];
    std::fill_n(front.entries.get(), front.rows().size() * at(front.columns), 0.0);
    Update update = zero_update(front);
    number_rows(front, 0);
    add_entries(node, front);
    for (const int child : children(node))
        add_update(child, front, update);
    factorise_columns(front.panel(), inverse_blocks_);
    subtract_own_product(front.panel().bottomRows(front.below()), square(update, front.below()));
    work_.updates[at(node)] = std::move(update);
}

void FrontBuilder::gather(int node)
{
    const Front& top = work_.front(node);
    Update update = zero_update(top);
    auto sum = square(update, top.below());
    number_rows(top, top.columns);
    const int beyond = elimination_.rank_after(node);
    for (int below = tree_.lowest[at(node)]; below <= node; ++below)
    {
        look_for_stop();
        const Front& front = work_.front(below);
        const auto first = std::partition_point(
            front.rows().begin(), front.rows().end(),
            [&](int slot) { return elimination_.rank_of_slot(slot) < beyond; });
        const auto count = front.rows().end() - first;
        if (count == 0)
            continue;
        Weights product = Weights::Zero(count, count);
        subtract_own_product(front.panel().bottomRows(count), product);
        for (Eigen::Index i = 0; i < count; ++i)
            for (Eigen::Index j = 0; j <= i; ++j)
                sum(local_[at(first[i])], local_[at(first[j])]) += product(i, j);
    }
    work_.updates[at(node)] = std::move(update);
}

std::vector<int> FrontBuilder::children(int node) const
{
    std::vector<int> found;
    for (int child = node - 1; child >= tree_.lowest[at(node)]; child = tree_.lowest[at(child)] - 1)
        found.push_back(child);
    return found;
}

void FrontBuilder::number_rows(const Front& front, int from)
{
    for (int row = from; row < front.height(); ++row)
        local_[at(front.rows()[at(row)])] = row - from;
}

// Adds all entries on and below the diagonal, in the columns of the node's unknowns.
void FrontBuilder::add_entries(int node, Front& front)
{
    const std::vector<int>& unknown_of = elimination_.matrix().unknown_of;
    Eigen::Map<Weights> panel = front.panel();
    for (const int* own = elimination_.own_begin(node); own != elimination_.own_end(node); ++own)
    {
        const int column = local_[at(elimination_.slot_of(*own))];
        const int rank = elimination_.rank_of(*own);
        for (const int* row = elimination_.rows_begin(*own); row != elimination_.rows_end(*own);
             ++row)
            for (SparseMatrix::InnerIterator entry(work_.values, *row); entry; ++entry)
                if (const int other = unknown_of[at(entry.row())];
                    other >= 0 && elimination_.rank_of(other) >= rank)
                    panel(local_[at(elimination_.slot_of(other))], column) += entry.value();
    }
}

void FrontBuilder::add_update(int child, const Front& front, Update& update)
{
    Update taken = std::move(work_.updates[at(child)]);
    const Front& from = work_.front(child);
    const int count = from.below();
    targets_.resize(at(count));
    for (int i = 0; i < count; ++i)
        targets_[at(i)] = local_[at(from.rows()[at(from.columns + i)])];
    const int own = static_cast<int>(
        std::lower_bound(targets_.begin(), targets_.end(), front.columns) - targets_.begin());
    for (int i = 0; i < count; ++i)
    {
        const double* source = taken.entries.get() + static_cast<Eigen::Index>(i) * count;
        double* const left =
            front.entries.get() + static_cast<std::ptrdiff_t>(targets_[at(i)]) * front.columns;
        for (int j = 0; j < std::min(own, i + 1); ++j)
            left[targets_[at(j)]] += source[j];
        if (i < own)
            continue;
        double* const right =
            update.entries.get()
            + static_cast<Eigen::Index>(targets_[at(i)] - front.columns) * front.below()
            - front.columns;
        for (int j = own; j <= i; ++j)
            right[targets_[at(j)]] += source[j];
    }
    if (spare_.size() < most_spare)
        spare_.push_back(std::move(taken));
}

// Returns an update of zeros, in the smallest spare memory that suffices or in new memory.
Update FrontBuilder::zero_update(const Front& front)
{
    const std::size_t rows = at(front.below());
    auto best = spare_.end();
    for (auto one = spare_.begin(); one != spare_.end(); ++one)
        if (one->room >= rows * rows && (best == spare_.end() || one->room < best->room))
            best = one;
    Update update;
    if (best != spare_.end())
    {
        update = std::move(*best);
        spare_.erase(best);
    }
    else
        update = {std::unique_ptr<double[]>(new double[rows * rows]), rows * rows};
    for (std::size_t row = 0; row < rows; ++row)
        std::fill_n(update.entries.get() + row * rows, row + 1, 0.0);
    return update;
}

}  // namespace sheetmorph::numerics
