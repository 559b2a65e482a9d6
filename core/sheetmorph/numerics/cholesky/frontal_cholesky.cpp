// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/frontal_cholesky.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/parallel.h"
#include "sheetmorph/numerics/cholesky/front_builder.h"

#include <algorithm>
#include <atomic>

namespace sheetmorph
{

namespace
{

constexpr int most_threads = 2;

// A subtree of at most this share of all rows is one task: what each takes off the rows above it is
// kept until all are done.
constexpr double task_share = 1.0 / 7.0;

// From so many rows on a second thread is worth its start.
constexpr int rows_for_two_threads = 5000;

//! What there is to do. Pieces of one list do not wait for each other.
struct Plan
{
    std::vector<int> gathered;  // subtrees that were taken over, below what was not
    std::vector<int> built;     // subtrees with something to build
    std::vector<int> top;       // what is above them, children first
};

Plan plan_of(const FrontWork& work)
{
    const SeparatorTree& tree = work.tree();
    const auto rows = [&](int node)
    { return tree.first[at(node) + 1] - tree.first[at(tree.lowest[at(node)])]; };
    const double limit = task_share * static_cast<double>(tree.order.size());
    Plan plan;
    for (int node = tree.size() - 1; node >= 0; --node)
    {
        const int parent = tree.parent[at(node)];
        if (work.is_kept[at(node)])
        {
            if (parent >= 0 && !work.is_kept[at(parent)])
                plan.gathered.push_back(node);
        }
        else if (rows(node) > limit)
            plan.top.push_back(node);
        else if (parent < 0 || rows(parent) > limit)
            plan.built.push_back(node);
    }
    std::reverse(plan.top.begin(), plan.top.end());
    const auto has_more = [&](int a, int b) { return rows(a) > rows(b); };
    std::sort(plan.gathered.begin(), plan.gathered.end(), has_more);
    std::sort(plan.built.begin(), plan.built.end(), has_more);
    return plan;
}

// run(builder, node) for all nodes, on several threads as they come free.
template <typename Run>
void run_all(const std::vector<int>& nodes, FrontWork& work, const Run& run)
{
    std::atomic<std::size_t> next{0};
    const bool is_small = work.elimination.slots() < rows_for_two_threads;
    parallel_ranges(static_cast<Eigen::Index>(4 * nodes.size()), is_small ? 1 : most_threads,
                    [&](Eigen::Index, Eigen::Index)
                    {
                        FrontBuilder builder(work, 1);
                        for (std::size_t k = next++; k < nodes.size(); k = next++)
                            run(builder, nodes[k]);
                    });
}

}  // namespace

FrontList frontal_cholesky(const Elimination& elimination, const EarlierFactor* earlier)
{
    const SeparatorTree& tree = elimination.tree();
    const std::size_t count = at(tree.size());
    FrontList factor{elimination.slots(), {}, tree.parent};
    factor.fronts.resize(count);
    FrontWork work{elimination, factor, std::vector<char>(count, 0), std::vector<Update>(count)};
    if (earlier != nullptr)
        work.is_kept = elimination.unchanged_nodes(earlier->elimination);
    for (std::size_t node = 0; node < count; ++node)
        if (work.is_kept[node])
            factor.fronts[node] = earlier->fronts.fronts[node];
    const Plan plan = plan_of(work);
    run_all(plan.gathered, work, [](FrontBuilder& builder, int node) { builder.gather(node); });
    run_all(plan.built, work,
            [&](FrontBuilder& builder, int top)
            {
                for (int node = tree.lowest[at(top)]; node <= top; ++node)
                    if (!work.is_kept[at(node)])
                        builder.build(node);
            });
    FrontBuilder builder(work, most_threads);
    for (const int node : plan.top)
        builder.build(node);
    return factor;
}

}  // namespace sheetmorph
