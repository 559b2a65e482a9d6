// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace sheetmorph
{

//! Union-find over 0..n-1; the root of a set is its smallest member.
class DisjointSets
{
public:
    explicit DisjointSets(int count) : parent_(static_cast<std::size_t>(count))
    {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    int root(int member)
    {
        while (parent(member) != member)
        {
            parent(member) = parent(parent(member));
            member = parent(member);
        }
        return member;
    }

    void join(int a, int b)
    {
        const int root_a = root(a);
        const int root_b = root(b);
        parent(std::max(root_a, root_b)) = std::min(root_a, root_b);
    }

private:
    int& parent(int member) { return parent_[static_cast<std::size_t>(member)]; }

    std::vector<int> parent_;
};

}  // namespace sheetmorph
