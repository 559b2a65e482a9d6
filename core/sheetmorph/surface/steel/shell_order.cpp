// SPDX-License-Identifier: LGPL-2.1-or-later
// The elimination order of a shell's unknowns.
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/stopping.h"
#include "sheetmorph/surface/steel/shell_system.h"

#include <algorithm>
#include <numeric>

namespace sheetmorph::surface
{

using Kind = ShellMover::Kind;

void ShellSystem::find_things()
{
    look_for_stop();
    const auto place = [this](int vertex) -> Vector3
    { return part_.rest.points().row(vertex).transpose(); };
    for (std::size_t i = 0; i < movers_.vertices.size(); ++i)
        if (movers_.vertices[i].kind == Kind::open)
            things_.push_back({movers_.vertices[i].index, 3, place(static_cast<int>(i))});
    for (std::size_t e = 0; e < movers_.edges.size(); ++e)
        if (movers_.edges[e].kind == Kind::open)
            things_.push_back({movers_.edges[e].index, 1,
                               0.5 * (place(mesh_.edges[e][0]) + place(mesh_.edges[e][1]))});
    std::vector<char> is_listed(at(joints_.freedoms()), 0);
    for (std::size_t k = 0; k < joints_.states().size(); ++k)
        for (const JointLevel& level : joints_.levels(k))
            if (!level.axes.empty() && is_listed[at(level.first)] == 0)
            {
                is_listed[at(level.first)] = 1;
                things_.push_back({movers_.open + level.first, static_cast<int>(level.axes.size()),
                                   joints_.states()[k].centre});
            }
    std::sort(things_.begin(), things_.end(),
              [](const Thing& a, const Thing& b) { return a.first < b.first; });
    std::vector<int> thing_of;
    for (std::size_t k = 0; k < things_.size(); ++k)
        thing_of.insert(thing_of.end(), at(things_[k].count), static_cast<int>(k));
    for (Freedom& freedom : freedoms_)
        for (const int column : freedom.columns)
            if (const int thing = thing_of[at(column)];
                freedom.things.empty() || freedom.things.back() != thing)
                freedom.things.push_back(thing);
}

// Entries of 1 where an element couples two blocks of unknowns.
numerics::SparseMatrix ShellSystem::coupled_things() const
{
    look_for_stop();
    std::vector<int> first(things_.size() + 2, 0);  // first element of each block, shifted by one
    for (const Freedom& freedom : freedoms_)
        for (const int thing : freedom.things)
            ++first[at(thing) + 2];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<int> elements(at(first.back()));
    for (std::size_t e = 0; e < freedoms_.size(); ++e)
        for (const int thing : freedoms_[e].things)
            elements[at(first[at(thing) + 1]++)] = static_cast<int>(e);
    const auto count = static_cast<int>(things_.size());
    std::vector<int> last(things_.size(), -1), rows;
    numerics::SparseMatrix found(count, count);
    std::vector<int> starts = {0};
    for (int thing = 0; thing < count; ++thing)
    {
        const std::size_t begin = rows.size();
        rows.push_back(thing);
        last[at(thing)] = thing;
        for (int k = first[at(thing)]; k < first[at(thing) + 1]; ++k)
            for (const int other : freedoms_[at(elements[at(k)])].things)
                if (last[at(other)] != thing)
                {
                    last[at(other)] = thing;
                    rows.push_back(other);
                }
        std::sort(rows.begin() + static_cast<std::ptrdiff_t>(begin), rows.end());
        check_count(rows.size());
        starts.push_back(static_cast<int>(rows.size()));
    }
    found.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
    std::copy(starts.begin(), starts.end(), found.outerIndexPtr());
    std::copy(rows.begin(), rows.end(), found.innerIndexPtr());
    std::fill(found.valuePtr(), found.valuePtr() + rows.size(), 1.0);
    return found;
}

// Keeps the unknowns of a block together.
void ShellSystem::find_tree(const numerics::SparseMatrix& coupled)
{
    look_for_stop();
    Points places(static_cast<Eigen::Index>(things_.size()), 3);
    for (std::size_t k = 0; k < things_.size(); ++k)
        places.row(static_cast<Eigen::Index>(k)) = things_[k].place.transpose();
    const numerics::SeparatorTree cut = numerics::nested_dissection(coupled, places);
    numerics::SeparatorTree tree{{}, {0}, cut.parent, cut.lowest};
    for (int node = 0; node < cut.size(); ++node)
    {
        for (int k = cut.first[at(node)]; k < cut.first[at(node) + 1]; ++k)
        {
            const Thing& thing = things_[at(cut.order[at(k)])];
            for (int column = 0; column < thing.count; ++column)
                tree.order.push_back(thing.first + column);
        }
        tree.first.push_back(static_cast<int>(tree.order.size()));
    }
    tree_ = std::make_shared<const numerics::SeparatorTree>(std::move(tree));
}

}  // namespace sheetmorph::surface
