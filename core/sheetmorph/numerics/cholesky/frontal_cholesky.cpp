// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/frontal_cholesky.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/numerics/cholesky/front_builder.h"

namespace sheetmorph::numerics
{

FrontList new_fronts(const FrontPattern& pattern, const FrontList* earlier)
{
    const Elimination& elimination = pattern.elimination();
    FrontList factor{elimination.slots(), {}, pattern.tree().parent};
    for (int node = 0; node < pattern.tree().size(); ++node)
    {
        if (pattern.is_unchanged(node))
        {
            factor.fronts.push_back(earlier->fronts[at(node)]);
            continue;
        }
        auto front = std::make_shared<Front>();
        front->columns = static_cast<int>(elimination.own_end(node) - elimination.own_begin(node));
        front->shared_rows = pattern.rows(node);
        front->entries.reset(new double[front->rows().size() * at(front->columns)]);
        factor.fronts.push_back(std::move(front));
    }
    return factor;
}

void factorise_fronts(const FrontPattern& pattern, const SparseMatrix& values, FrontList& factor)
{
    FrontWork work{pattern, values, factor, std::vector<Update>(factor.fronts.size())};
    const std::vector<int>& unchanged = pattern.unchanged_subtrees();
    parallel_items(static_cast<Eigen::Index>(unchanged.size()),
                   [&](Eigen::Index k) { FrontBuilder(work).gather(unchanged[at(k)]); });
    pattern.for_changed([&work] { return FrontBuilder(work); },
                        [](FrontBuilder& builder, int node) { builder.build(node); });
}

}  // namespace sheetmorph::numerics
