// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/front_pattern.h"

#include "sheetmorph/base/index.h"

#include <algorithm>

namespace sheetmorph::numerics
{

namespace
{

// Largest share of all rows in a subtree that is one task. Chosen, not measured: at least 16 tasks
// keep eight threads busy. With more tasks, more updates stay in memory until the last one ends.
constexpr double task_share = 1.0 / 16.0;

//! Collects the rows of fronts, one after the other; every thread has its own.
class RowCollector
{
public:
    RowCollector(const Elimination& elimination, std::vector<FrontRows>& rows)
        : elimination_(elimination), rows_(rows), last_seen_(at(elimination.slots()), -1)
    {
    }

    // Collects the own unknowns, then all later ones that are coupled with them or with the
    // children.
    void collect(int node)
    {
        const MergedMatrix& matrix = elimination_.matrix();
        const SeparatorTree& tree = elimination_.tree();
        ranks_.clear();
        for (int child = node - 1; child >= tree.lowest[at(node)];
             child = tree.lowest[at(child)] - 1)
            for (const int slot : *rows_[at(child)])
                add(node, slot, elimination_.rank_of_slot(slot));
        const int* const begin = elimination_.own_begin(node);
        const int* const end = elimination_.own_end(node);
        for (const int* own = begin; own != end; ++own)
            for (const int* row = elimination_.rows_begin(*own); row != elimination_.rows_end(*own);
                 ++row)
                for (SparseMatrix::InnerIterator entry(*matrix.whole, *row); entry; ++entry)
                    if (const int other = matrix.unknown_of[at(entry.row())]; other >= 0)
                        add(node, elimination_.slot_of(other), elimination_.rank_of(other));
        std::sort(ranks_.begin(), ranks_.end());
        auto rows = std::make_shared<std::vector<int>>();
        rows->reserve(at(end - begin) + ranks_.size());
        for (const int* own = begin; own != end; ++own)
            rows->push_back(elimination_.slot_of(*own));
        for (const int rank : ranks_)
            rows->push_back(elimination_.slot_of_rank(rank));
        rows_[at(node)] = std::move(rows);
    }

private:
    void add(int node, int slot, int rank)
    {
        if (rank < elimination_.rank_after(node) || last_seen_[at(slot)] == node)
            return;
        last_seen_[at(slot)] = node;
        ranks_.push_back(rank);
    }

    const Elimination& elimination_;
    std::vector<FrontRows>& rows_;
    std::vector<int> last_seen_;  // by slot: the last node that contains it
    std::vector<int> ranks_;
};

}  // namespace

FrontPattern::FrontPattern(Elimination elimination, const FrontPattern* earlier)
    : elimination_(std::move(elimination)), rows_(at(tree().size()))
{
    is_unchanged_ = earlier != nullptr ? elimination_.unchanged_nodes(earlier->elimination_)
                                       : std::vector<char>(rows_.size(), 0);
    plan();
    for (std::size_t node = 0; node < rows_.size(); ++node)
        if (is_unchanged_[node] != 0)
            rows_[node] = earlier->rows_[node];
    for_changed([this] { return RowCollector(elimination_, rows_); },
                [](RowCollector& collector, int node) { collector.collect(node); });
}

void FrontPattern::plan()
{
    const auto rows = [this](int node)
    { return tree().first[at(node) + 1] - tree().first[at(tree().lowest[at(node)])]; };
    const double limit = task_share * static_cast<double>(tree().order.size());
    for (int node = tree().size() - 1; node >= 0; --node)
    {
        const int parent = tree().parent[at(node)];
        if (is_unchanged(node))
        {
            if (parent >= 0 && !is_unchanged(parent))
                unchanged_.push_back(node);
        }
        else if (rows(node) > limit)
            top_.push_back(node);
        else if (parent < 0 || rows(parent) > limit)
            subtrees_.push_back(node);
    }
    std::reverse(top_.begin(), top_.end());
    const auto has_more = [&](int a, int b) { return rows(a) > rows(b); };
    std::sort(unchanged_.begin(), unchanged_.end(), has_more);
    std::sort(subtrees_.begin(), subtrees_.end(), has_more);
}

}  // namespace sheetmorph::numerics
