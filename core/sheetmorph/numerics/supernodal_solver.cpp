// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/supernodal_solver.h"

#include <algorithm>
#include <numeric>
#include <thread>

namespace sheetmorph
{

namespace
{

// Below so many entries a second thread's start costs more than it saves.
constexpr double entries_for_two_threads = 2e6;

// A subtree is split until it is at most this share of all entries.
constexpr double smallest_share = 0.05;

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

}  // namespace

SupernodalSolver::SupernodalSolver(const SupernodalFactor& factor)
    : factor_(factor), is_top_(at(factor.size), 0)
{
    for (int s = 0; s < factor.supernodes; ++s)
        widest_ = std::max(widest_, node(s).rows);
    const double entries = factor.supernodes > 0 ? factor.entry_start[factor.supernodes] : 0.0;
    if (entries >= entries_for_two_threads && std::thread::hardware_concurrency() > 1)
        share_subtrees();
    else
    {
        mine_.resize(at(factor.supernodes));
        std::iota(mine_.begin(), mine_.end(), 0);
    }
}

Supernode SupernodalSolver::node(int index) const
{
    return {factor_.entries + factor_.entry_start[index],
            factor_.row_start[index + 1] - factor_.row_start[index],
            factor_.first[index + 1] - factor_.first[index]};
}

// The supernode that the first row below each belongs to; -1 for roots.
std::vector<int> SupernodalSolver::parents() const
{
    std::vector<int> of_column(at(factor_.size));
    for (int s = 0; s < factor_.supernodes; ++s)
        std::fill(of_column.begin() + factor_.first[s], of_column.begin() + factor_.first[s + 1],
                  s);
    std::vector<int> parent(at(factor_.supernodes), -1);
    for (int s = 0; s < factor_.supernodes; ++s)
        if (node(s).rows > node(s).columns)
            parent[at(s)] = of_column[at(factor_.rows[factor_.row_start[s] + node(s).columns])];
    return parent;
}

// Large subtrees are opened from the root down; what is left goes to the thread with less to do.
void SupernodalSolver::share_subtrees()
{
    const int count = factor_.supernodes;
    const std::vector<int> parent = parents();
    std::vector<double> below(at(count), 0.0);
    for (int s = 0; s < count; ++s)
    {
        below[at(s)] += static_cast<double>(node(s).rows) * node(s).columns;
        if (parent[at(s)] >= 0)
            below[at(parent[at(s)])] += below[at(s)];
    }
    const double limit = smallest_share * factor_.entry_start[count];
    std::vector<Nodes*> owner(at(count), &top_);
    double load[2] = {0.0, 0.0};
    for (int s = count - 1; s >= 0; --s)
    {
        const int up = parent[at(s)];
        if (up >= 0 && owner[at(up)] != &top_)
            owner[at(s)] = owner[at(up)];
        else if (below[at(s)] <= limit)
        {
            const bool is_mine = load[0] <= load[1];
            owner[at(s)] = is_mine ? &mine_ : &theirs_;
            load[is_mine ? 0 : 1] += below[at(s)];
        }
    }
    for (int s = 0; s < count; ++s)
    {
        owner[at(s)]->push_back(s);
        if (owner[at(s)] == &top_)
            std::fill(is_top_.begin() + factor_.first[s], is_top_.begin() + factor_.first[s + 1],
                      1);
    }
}

// What a node takes off rows above all subtrees goes to `above`.
void SupernodalSolver::forward(const Nodes& nodes, Buffers buffers) const
{
    auto& [x, above, w] = buffers;
    for (const int s : nodes)
    {
        const Supernode own = node(s);
        const int* rows = factor_.rows + factor_.row_start[s];
        w.topRows(own.columns) = x.middleRows(factor_.first[s], own.columns);
        w.middleRows(own.columns, own.rows - own.columns).setZero();
        run_forward(own, w.data());
        x.middleRows(factor_.first[s], own.columns) = w.topRows(own.columns);
        for (int k = own.columns; k < own.rows; ++k)
            (is_top_[at(rows[k])] ? above : x).row(rows[k]) += w.row(k);
    }
}

void SupernodalSolver::backward(const Nodes& nodes, Buffers buffers) const
{
    auto& [x, above, w] = buffers;
    for (auto s = nodes.rbegin(); s != nodes.rend(); ++s)
    {
        const Supernode own = node(*s);
        const int* rows = factor_.rows + factor_.row_start[*s];
        w.topRows(own.columns) = x.middleRows(factor_.first[*s], own.columns);
        for (int k = own.columns; k < own.rows; ++k)
            w.row(k) = x.row(rows[k]);
        run_backward(own, w.data());
        x.middleRows(factor_.first[*s], own.columns) = w.topRows(own.columns);
    }
}

void SupernodalSolver::solve(RightSides& x) const
{
    RightSides w(widest_, right_sides_at_once);
    const Buffers own{x, x, w};
    if (theirs_.empty())
    {
        forward(mine_, own);
        backward(mine_, own);
        return;
    }
    RightSides above = RightSides::Zero(factor_.size, right_sides_at_once);
    RightSides other_w(widest_, right_sides_at_once);
    const Buffers others{x, above, other_w};
    std::thread helper([&] { forward(theirs_, others); });
    forward(mine_, own);
    helper.join();
    for (const int s : top_)
        for (int column = factor_.first[s]; column < factor_.first[s + 1]; ++column)
            x.row(column) += above.row(column);
    forward(top_, own);
    backward(top_, own);
    helper = std::thread([&] { backward(theirs_, others); });
    backward(mine_, own);
    helper.join();
}

}  // namespace sheetmorph
