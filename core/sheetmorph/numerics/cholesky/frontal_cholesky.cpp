// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/frontal_cholesky.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/parallel.h"
#include "sheetmorph/numerics/cholesky/front_builder.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

// A subtree of at most this share of all rows is one task: what each takes off the rows above it is
// kept until all are done.
constexpr double task_share = 1.0 / 16.0;

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

// run(builder, node) for all nodes.
template <typename Run>
void run_all(const std::vector<int>& nodes, FrontWork& work, const Run& run)
{
    parallel_items(static_cast<Eigen::Index>(nodes.size()),
                   [&](Eigen::Index k)
                   {
                       FrontBuilder builder(work);
                       run(builder, nodes[static_cast<std::size_t>(k)]);
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
    FrontBuilder builder(work);
    for (const int node : plan.top)
        builder.build(node);
    return factor;
}

}  // namespace sheetmorph
