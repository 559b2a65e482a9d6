// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/front_builder.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/numerics/cholesky/dense_cholesky.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

constexpr int none = -1;

// Memory of so many updates is kept for the next ones.
constexpr std::size_t most_spare = 6;

Eigen::Map<Weights> square(Update& update, int rows)
{
    return {update.data(), rows, rows};
}

}  // namespace

FrontBuilder::FrontBuilder(FrontWork& work)
    : work_(work),
      elimination_(work.elimination),
      tree_(elimination_.tree()),
      local_(at(elimination_.slots()), none)
{
}

void FrontBuilder::build(int node)
{
    auto front = std::make_shared<Front>();
    front->columns = static_cast<int>(elimination_.own_end(node) - elimination_.own_begin(node));
    collect_rows(node, *front);
    front->entries.reset(new double[front->rows.size() * at(front->columns)]());
    Update update = zero_update(*front);
    add_entries(node, *front);
    for (const int child : children(node))
        add_update(child, *front, update);
    forget_rows(*front);
    factorise_columns(front->panel(), inverse_blocks_);
    subtract_own_product(front->panel().bottomRows(front->below()), square(update, front->below()));
    work_.updates[at(node)] = std::move(update);
    work_.factor.fronts[at(node)] = std::move(front);
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
        const Front& front = work_.front(below);
        const auto first = std::partition_point(
            front.rows.begin(), front.rows.end(),
            [&](int slot) { return elimination_.rank_of_slot(slot) < beyond; });
        const auto count = front.rows.end() - first;
        if (count == 0)
            continue;
        Weights product = Weights::Zero(count, count);
        subtract_own_product(front.panel().bottomRows(count), product);
        for (Eigen::Index i = 0; i < count; ++i)
            for (Eigen::Index j = 0; j <= i; ++j)
                sum(local_[at(first[i])], local_[at(first[j])]) += product(i, j);
    }
    forget_rows(top);
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
        local_[at(front.rows[at(row)])] = row - from;
}

void FrontBuilder::forget_rows(const Front& front)
{
    for (const int slot : front.rows)
        local_[at(slot)] = none;
}

// use(unknown, other, value) for all entries in the columns of a node's unknowns.
template <typename Use>
void FrontBuilder::for_entries(int node, const Use& use) const
{
    const MergedMatrix& matrix = elimination_.matrix();
    for (const int* own = elimination_.own_begin(node); own != elimination_.own_end(node); ++own)
        for (const int* row = elimination_.rows_begin(*own); row != elimination_.rows_end(*own);
             ++row)
            for (SparseMatrix::InnerIterator entry(*matrix.whole, *row); entry; ++entry)
                if (const int other = matrix.unknown_of[at(static_cast<int>(entry.row()))];
                    other >= 0)
                    use(*own, other, entry.value());
}

void FrontBuilder::add_rank(int rank, int after)
{
    const int slot = elimination_.slot_of_rank(rank);
    if (rank < after || local_[at(slot)] != none)
        return;
    local_[at(slot)] = 0;
    ranks_.push_back(rank);
}

// Own unknowns, then all later ones that they or the children are coupled with.
void FrontBuilder::collect_rows(int node, Front& front)
{
    for (const int* own = elimination_.own_begin(node); own != elimination_.own_end(node); ++own)
    {
        local_[at(elimination_.slot_of(*own))] = front.height();
        front.rows.push_back(elimination_.slot_of(*own));
    }
    ranks_.clear();
    const int after = elimination_.rank_after(node);
    for (const int child : children(node))
        for (int row = work_.front(child).columns; row < work_.front(child).height(); ++row)
            add_rank(elimination_.rank_of_slot(work_.front(child).rows[at(row)]), after);
    for_entries(node,
                [&](int, int other, double) { add_rank(elimination_.rank_of(other), after); });
    std::sort(ranks_.begin(), ranks_.end());
    for (const int rank : ranks_)
        front.rows.push_back(elimination_.slot_of_rank(rank));
    number_rows(front, 0);
}

void FrontBuilder::add_entries(int node, Front& front)
{
    for_entries(node,
                [&](int unknown, int other, double value)
                {
                    const int column = local_[at(elimination_.slot_of(unknown))];
                    const int row = local_[at(elimination_.slot_of(other))];
                    if (row >= column)
                        front.panel()(row, column) += value;
                });
}

void FrontBuilder::add_update(int child, const Front& front, Update& update)
{
    Update taken = std::move(work_.updates[at(child)]);
    const Front& from = work_.front(child);
    const int count = from.below();
    targets_.resize(at(count));
    for (int i = 0; i < count; ++i)
        targets_[at(i)] = local_[at(from.rows[at(from.columns + i)])];
    const int own = static_cast<int>(
        std::lower_bound(targets_.begin(), targets_.end(), front.columns) - targets_.begin());
    for (int i = 0; i < count; ++i)
    {
        const double* source = taken.data() + static_cast<Eigen::Index>(i) * count;
        double* const left =
            front.entries.get() + static_cast<std::ptrdiff_t>(targets_[at(i)]) * front.columns;
        for (int j = 0; j < std::min(own, i + 1); ++j)
            left[targets_[at(j)]] += source[j];
        if (i < own)
            continue;
        double* const right =
            update.data()
            + static_cast<Eigen::Index>(targets_[at(i)] - front.columns) * front.below()
            - front.columns;
        for (int j = own; j <= i; ++j)
            right[targets_[at(j)]] += source[j];
    }
    if (spare_.size() < most_spare)
        spare_.push_back(std::move(taken));
}

// The smallest spare memory that has room for it, or fresh one.
Update FrontBuilder::zero_update(const Front& front)
{
    const std::size_t size = at(front.below()) * at(front.below());
    auto best = spare_.end();
    for (auto one = spare_.begin(); one != spare_.end(); ++one)
        if (one->capacity() >= size && (best == spare_.end() || one->capacity() < best->capacity()))
            best = one;
    Update update;
    if (best != spare_.end())
    {
        update.swap(*best);
        spare_.erase(best);
    }
    update.assign(size, 0.0);
    return update;
}

}  // namespace sheetmorph
