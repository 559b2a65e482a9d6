// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/ordering/elimination.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/stopping.h"

#include <algorithm>
#include <numeric>

namespace sheetmorph::numerics
{

namespace
{

constexpr int none = -1;

// Sorts 0 .. keys.size() - 1 stably by keys 0 .. count - 1. Returns where each key begins.
std::vector<int> sorted_by(const std::vector<int>& keys, int count, std::vector<int>& order)
{
    std::vector<int> start(at(count) + 1, 0);
    for (const int key : keys)
        if (key >= 0)
            ++start[at(key) + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    order.resize(at(start.back()));
    std::vector<int> next(start.begin(), start.end() - 1);
    for (std::size_t k = 0; k < keys.size(); ++k)
        if (keys[k] >= 0)
            order[at(next[at(keys[k])]++)] = static_cast<int>(k);
    return start;
}

}  // namespace

MergedMatrix unmerged(std::shared_ptr<const SparseMatrix> whole)
{
    std::vector<int> own(at(whole->rows()));
    std::iota(own.begin(), own.end(), 0);
    const int count = static_cast<int>(whole->rows());
    return {std::move(whole), std::move(own), count};
}

Elimination::Elimination(MergedMatrix matrix, std::shared_ptr<const SeparatorTree> tree)
    : matrix_(std::move(matrix)), tree_(std::move(tree))
{
    collect_rows();
    find_nodes();
    sort_by_node();
}

void Elimination::collect_rows()
{
    rows_start_ = sorted_by(matrix_.unknown_of, matrix_.count, rows_);
    std::vector<int> place(tree_->order.size());
    for (std::size_t slot = 0; slot < place.size(); ++slot)
        place[at(tree_->order[slot])] = static_cast<int>(slot);
    slot_of_.resize(at(matrix_.count));
    for (int unknown = 0; unknown < matrix_.count; ++unknown)
        slot_of_[at(unknown)] = place[at(*rows_begin(unknown))];
}

// With any tree, coupled unknowns end up one above the other: an unknown that moves up stays above
// all that was below it.
void Elimination::find_nodes()
{
    std::vector<int> node_of_row(tree_->order.size());
    for (int node = 0; node < tree_->size(); ++node)
        for (int slot = tree_->first[at(node)]; slot < tree_->first[at(node) + 1]; ++slot)
            node_of_row[at(tree_->order[at(slot)])] = node;
    node_of_.assign(at(matrix_.count), none);
    for (std::size_t row = 0; row < node_of_row.size(); ++row)
        if (const int unknown = matrix_.unknown_of[row]; unknown >= 0)
        {
            int& node = node_of_[at(unknown)];
            node = node == none ? node_of_row[row] : tree_->common(node, node_of_row[row]);
        }
    for (bool is_lifted = true; is_lifted;)
    {
        look_for_stop();
        is_lifted = false;
        for (Eigen::Index column = 0; column < matrix_.whole->outerSize(); ++column)
        {
            const int unknown = matrix_.unknown_of[at(column)];
            if (unknown < 0)
                continue;
            int& node = node_of_[at(unknown)];
            for (SparseMatrix::InnerIterator entry(*matrix_.whole, column); entry; ++entry)
            {
                const int other = matrix_.unknown_of[at(entry.row())];
                if (other < 0 || node_of_[at(other)] <= node
                    || tree_->is_below(node, node_of_[at(other)]))
                    continue;
                node = tree_->common(node, node_of_[at(other)]);
                is_lifted = true;
            }
        }
    }
}

void Elimination::sort_by_node()
{
    own_start_ = sorted_by(node_of_, tree_->size(), order_);
    look_for_stop();
    for (int node = 0; node < tree_->size(); ++node)
        std::sort(order_.begin() + own_start_[at(node)], order_.begin() + own_start_[at(node) + 1],
                  [this](int a, int b) { return slot_of(a) < slot_of(b); });
    rank_of_.resize(at(matrix_.count));
    rank_of_slot_.assign(tree_->order.size(), none);
    for (int rank = 0; rank < matrix_.count; ++rank)
    {
        const int unknown = order_[at(rank)];
        rank_of_[at(unknown)] = rank;
        rank_of_slot_[at(slot_of(unknown))] = rank;
    }
}

// Unknowns with the same rows, eliminated at the same node.
std::vector<char> Elimination::same_unknowns(const Elimination& earlier) const
{
    std::vector<char> is_same(at(matrix_.count), 0);
    for (int unknown = 0; unknown < matrix_.count; ++unknown)
    {
        const int before = earlier.matrix_.unknown_of[at(*rows_begin(unknown))];
        is_same[at(unknown)] = before >= 0 && node_of_[at(unknown)] == earlier.node_of_[at(before)]
                               && std::equal(rows_begin(unknown), rows_end(unknown),
                                             earlier.rows_begin(before), earlier.rows_end(before));
    }
    return is_same;
}

std::vector<char> Elimination::unchanged_nodes(const Elimination& earlier) const
{
    std::vector<char> is_unchanged(at(tree_->size()), 1);
    if (earlier.matrix_.whole != matrix_.whole || earlier.tree_ != tree_)
        return std::vector<char>(at(tree_->size()), 0);
    const std::vector<char> is_same = same_unknowns(earlier);
    const auto is_row_same = [&](Eigen::Index row)
    {
        const int now = matrix_.unknown_of[at(row)];
        return now >= 0 ? is_same[at(now)] != 0 : earlier.matrix_.unknown_of[at(row)] < 0;
    };
    const auto is_column_same = [&](int unknown)
    {
        for (const int* row = rows_begin(unknown); row != rows_end(unknown); ++row)
            for (SparseMatrix::InnerIterator entry(*matrix_.whole, *row); entry; ++entry)
                if (!is_row_same(entry.row()))
                    return false;
        return true;
    };
    for (int node = 0; node < tree_->size(); ++node)
    {
        char& own = is_unchanged[at(node)];
        own = own
              && own_end(node) - own_begin(node) == earlier.own_end(node) - earlier.own_begin(node)
              && std::all_of(own_begin(node), own_end(node), is_column_same);
        if (const int parent = tree_->parent[at(node)]; parent >= 0 && !own)
            is_unchanged[at(parent)] = 0;
    }
    return is_unchanged;
}

}  // namespace sheetmorph::numerics
