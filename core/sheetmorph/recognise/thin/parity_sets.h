// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <numeric>
#include <vector>

namespace sheetmorph::recognise
{

//! Union-find over 0..n-1 that also records on which of two sides every member is.
class ParitySets
{
public:
    explicit ParitySets(int count)
        : parent_(static_cast<std::size_t>(count)), flip_(static_cast<std::size_t>(count), 0)
    {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    //! The root of a member's set.
    int root(int member) const
    {
        while (parent(member) != member)
            member = parent(member);
        return member;
    }

    //! 0 if the member is on the side of its root, else 1.
    int side(int member) const
    {
        int flips = 0;
        for (; parent(member) != member; member = parent(member))
            flips ^= flip_[static_cast<std::size_t>(member)];
        return flips;
    }

    //! Joins the sets of a and b, on the same side if `flip` is 0, on opposite sides if it is 1.
    //! Has no effect if they already share a set.
    void join(int a, int b, int flip)
    {
        const int root_a = root(a);
        const int root_b = root(b);
        if (root_a == root_b)
            return;
        flip_[static_cast<std::size_t>(root_b)] = static_cast<char>(side(a) ^ side(b) ^ flip);
        parent_[static_cast<std::size_t>(root_b)] = root_a;
    }

private:
    int parent(int member) const { return parent_[static_cast<std::size_t>(member)]; }

    std::vector<int> parent_;
    std::vector<char> flip_;
};

}  // namespace sheetmorph::recognise
