// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/front_solver.h"

#include "sheetmorph/base/index.h"

#include "sheetmorph/base/threads/parallel.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace sheetmorph::numerics
{

namespace
{

// Entries of a factor; smaller ones are solved on one thread. Chosen, not measured: 4 MB, estimated
// at 0.2 ms to read. Waking a thread takes 30 microseconds, twice per solve.
constexpr double fewest_entries = 5e5;

// One thread reads the fronts above the shares. Chosen: with eight shares, these fronts would
// include one more level of large ones.
constexpr int share_count = 4;

// Largest share of all entries in a subtree that is not divided further. From share_count: a
// quarter, with a margin of 1 % so that rounding does not divide four equal quarters.
constexpr double largest_subtree = 0.26;

int sides_of(const FrontSolver::Groups& groups)
{
    return static_cast<int>(groups.front().cols());
}

std::vector<double*> places_of(FrontSolver::Groups& groups)
{
    std::vector<double*> places;
    for (FrontSolver::RightSides& group : groups)
        places.push_back(group.data());
    return places;
}

}  // namespace

FrontSolver::FrontSolver(FrontList factor)
    : factor_(std::move(factor)), top_row_(at(factor_.slots), -1)
{
    for (const auto& own : factor_.fronts)
        widest_ = std::max(widest_, own->columns);
    if (factor_.count() >= fewest_entries)
    {
        share_subtrees();
        return;
    }
    shares_.emplace_back(factor_.fronts.size());
    std::iota(shares_.front().begin(), shares_.front().end(), 0);
}

// Opens large subtrees from the root down, and gives each remaining one to the smallest share.
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
    const double limit = largest_subtree * factor_.count();
    shares_.resize(share_count);
    std::vector<Nodes*> owner(at(count), &top_);
    std::array<double, share_count> load{};
    for (int s = count - 1; s >= 0; --s)
    {
        const int up = parent[at(s)];
        if (up >= 0 && owner[at(up)] != &top_)
            owner[at(s)] = owner[at(up)];
        else if (below[at(s)] <= limit)
        {
            const auto least = std::min_element(load.begin(), load.end());
            owner[at(s)] = &shares_[static_cast<std::size_t>(least - load.begin())];
            *least += below[at(s)];
        }
    }
    for (int s = 0; s < count; ++s)
    {
        owner[at(s)]->push_back(s);
        for (int row = 0; row < front(s).columns && owner[at(s)] == &top_; ++row)
        {
            const int slot = front(s).rows()[at(row)];
            top_row_[at(slot)] = static_cast<int>(top_rows_.size());
            top_rows_.push_back(slot);
        }
    }
}

// Contributions of fronts to rows above all shares go to `above`, if it exists.
void FrontSolver::forward(const Nodes& nodes, Groups& groups, Groups* above) const
{
    std::vector<double> scratch(room_of(groups));
    FrontRun run{factor_, nodes, sides_of(groups), places_of(groups), scratch.data(), {}, {}};
    if (above != nullptr && !top_rows_.empty())
    {
        run.top_row = top_row_.data();
        run.above = places_of(*above);
    }
    run_forward(run);
}

void FrontSolver::backward(const Nodes& nodes, Groups& groups) const
{
    std::vector<double> scratch(room_of(groups));
    run_backward({factor_, nodes, sides_of(groups), places_of(groups), scratch.data(), {}, {}});
}

std::size_t FrontSolver::room_of(const Groups& groups) const
{
    return at(widest_) * at(groups.front().cols());
}

void FrontSolver::solve(Groups& x) const
{
    const auto count = static_cast<Eigen::Index>(shares_.size());
    const auto share = [this](Eigen::Index k) -> const Nodes&
    { return shares_[static_cast<std::size_t>(k)]; };
    const RightSides nothing =
        RightSides::Zero(static_cast<Eigen::Index>(top_rows_.size()), x.front().cols());
    std::vector<Groups> above(shares_.size(), Groups(x.size(), nothing));
    parallel_items(
        count, [&](Eigen::Index k) { forward(share(k), x, &above[static_cast<std::size_t>(k)]); });
    for (const Groups& part : above)
        for (std::size_t g = 0; g < x.size(); ++g)
            for (std::size_t row = 0; row < top_rows_.size(); ++row)
                x[g].row(top_rows_[row]) += part[g].row(static_cast<Eigen::Index>(row));
    forward(top_, x, nullptr);
    backward(top_, x);
    parallel_items(count, [&](Eigen::Index k) { backward(share(k), x); });
}

}  // namespace sheetmorph::numerics
