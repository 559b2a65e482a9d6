// SPDX-License-Identifier: LGPL-2.1-or-later
// The order in which a shell's unknowns are eliminated.
#include "sheetmorph/base/index.h"
#include "sheetmorph/surface/steel/shell_system.h"

namespace sheetmorph
{

using Kind = ShellMover::Kind;

ShellSystem::Things ShellSystem::things() const
{
    const auto place = [this](int vertex) -> Vector3
    { return part_.rest.points().row(vertex).transpose(); };
    Things found;
    for (std::size_t i = 0; i < movers_.vertices.size(); ++i)
        if (movers_.vertices[i].kind == Kind::open)
            found.push_back({movers_.vertices[i].index, 3, place(static_cast<int>(i))});
    for (std::size_t e = 0; e < movers_.edges.size(); ++e)
        if (movers_.edges[e].kind == Kind::open)
            found.push_back({movers_.edges[e].index, 1,
                             0.5 * (place(mesh_.edges[e][0]) + place(mesh_.edges[e][1]))});
    std::vector<char> is_listed(at(joints_.freedoms()), 0);
    for (std::size_t k = 0; k < joints_.states().size(); ++k)
        for (const JointLevel& level : joints_.levels(k))
            if (!level.axes.empty() && is_listed[at(level.first)] == 0)
            {
                is_listed[at(level.first)] = 1;
                found.push_back({movers_.open + level.first, static_cast<int>(level.axes.size()),
                                 joints_.states()[k].centre});
            }
    return found;
}

// Which things some element couples.
SparseMatrix ShellSystem::coupled(const Things& things) const
{
    std::vector<int> thing_of(at(unknowns()), 0);
    for (std::size_t k = 0; k < things.size(); ++k)
        for (int column = 0; column < things[k].count; ++column)
            thing_of[at(things[k].first + column)] = static_cast<int>(k);
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<int> last(things.size(), -1);
    for (int k = 0; k < static_cast<int>(things.size()); ++k)
        for (SparseMatrix::InnerIterator entry(*matrix_, things[at(k)].first); entry; ++entry)
        {
            const int other = thing_of[at(static_cast<int>(entry.row()))];
            if (last[at(other)] != k)
                entries.emplace_back(other, k, 1.0);
            last[at(other)] = k;
        }
    const auto count = static_cast<Eigen::Index>(things.size());
    SparseMatrix found(count, count);
    found.setFromTriplets(entries.begin(), entries.end());
    return found;
}

// The unknowns of one thing stay together.
void ShellSystem::find_tree()
{
    const Things all = things();
    Points places(static_cast<Eigen::Index>(all.size()), 3);
    for (std::size_t k = 0; k < all.size(); ++k)
        places.row(static_cast<Eigen::Index>(k)) = all[k].place.transpose();
    const SeparatorTree cut = nested_dissection(coupled(all), places);
    SeparatorTree tree{{}, {0}, cut.parent, cut.lowest};
    for (int node = 0; node < cut.size(); ++node)
    {
        for (int k = cut.first[at(node)]; k < cut.first[at(node) + 1]; ++k)
        {
            const Thing& thing = all[at(cut.order[at(k)])];
            for (int column = 0; column < thing.count; ++column)
                tree.order.push_back(thing.first + column);
        }
        tree.first.push_back(static_cast<int>(tree.order.size()));
    }
    tree_ = std::make_shared<const SeparatorTree>(std::move(tree));
}

}  // namespace sheetmorph
