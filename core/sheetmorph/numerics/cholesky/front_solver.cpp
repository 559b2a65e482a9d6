// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/front_solver.h"

#include "sheetmorph/base/index.h"

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
constexpr double smallest_share = 0.26;

}  // namespace

FrontSolver::FrontSolver(FrontList factor)
    : factor_(std::move(factor)), is_top_(at(factor_.slots), 0)
{
    for (const auto& own : factor_.fronts)
        widest_ = std::max(widest_, own->height());
    if (factor_.count() >= entries_for_two_threads && std::thread::hardware_concurrency() > 1)
        share_subtrees();
    else
    {
        mine_.resize(factor_.fronts.size());
        std::iota(mine_.begin(), mine_.end(), 0);
    }
}

// Large subtrees are opened from the root down; what is left goes to the thread with less to do.
void FrontSolver::share_subtrees()
{
    const auto count = static_cast<int>(factor_.fronts.size());
    const std::vector<int>& parent = factor_.parent;
    std::vector<double> below(at(count), 0.0);
    for (int s = 0; s < count; ++s)
    {
        below[at(s)] += front(s).count();
        if (parent[at(s)] >= 0)
            below[at(parent[at(s)])] += below[at(s)];
    }
    const double limit = smallest_share * factor_.count();
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
            for (int row = 0; row < front(s).columns; ++row)
                is_top_[at(front(s).rows[at(row)])] = 1;
    }
}

// What a front takes off rows above all subtrees goes to `above`.
void FrontSolver::forward(const Nodes& nodes, Buffers buffers) const
{
    auto& [x, above, w] = buffers;
    for (const int s : nodes)
    {
        const Front& own = front(s);
        const int* rows = own.rows.data();
        for (int k = 0; k < own.columns; ++k)
            w.row(k) = x.row(rows[k]);
        w.middleRows(own.columns, own.below()).setZero();
        run_forward(own, w.data());
        for (int k = 0; k < own.columns; ++k)
            x.row(rows[k]) = w.row(k);
        for (int k = own.columns; k < own.height(); ++k)
            (is_top_[at(rows[k])] ? above : x).row(rows[k]) += w.row(k);
    }
}

void FrontSolver::backward(const Nodes& nodes, Buffers buffers) const
{
    auto& [x, above, w] = buffers;
    for (auto s = nodes.rbegin(); s != nodes.rend(); ++s)
    {
        const Front& own = front(*s);
        const int* rows = own.rows.data();
        for (int k = 0; k < own.height(); ++k)
            w.row(k) = x.row(rows[k]);
        run_backward(own, w.data());
        for (int k = 0; k < own.columns; ++k)
            x.row(rows[k]) = w.row(k);
    }
}

void FrontSolver::solve(RightSides& x) const
{
    RightSides w(widest_, right_sides_at_once);
    const Buffers own{x, x, w};
    if (theirs_.empty())
    {
        forward(mine_, own);
        backward(mine_, own);
        return;
    }
    RightSides above = RightSides::Zero(factor_.slots, right_sides_at_once);
    RightSides other_w(widest_, right_sides_at_once);
    const Buffers others{x, above, other_w};
    std::thread helper([&] { forward(theirs_, others); });
    forward(mine_, own);
    helper.join();
    for (const int s : top_)
        for (int k = 0; k < front(s).columns; ++k)
            x.row(front(s).rows[at(k)]) += above.row(front(s).rows[at(k)]);
    forward(top_, own);
    backward(top_, own);
    helper = std::thread([&] { backward(theirs_, others); });
    backward(mine_, own);
    helper.join();
}

}  // namespace sheetmorph
