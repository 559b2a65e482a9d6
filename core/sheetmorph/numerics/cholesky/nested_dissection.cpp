// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/nested_dissection.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/parallel.h"
#include "sheetmorph/numerics/halving.h"

#include <algorithm>
#include <numeric>

namespace sheetmorph
{

namespace
{

// Sets this small are eliminated as they come: their fill is one dense block.
constexpr std::ptrdiff_t smallest_set = 12;

// From so many rows on the halves of a set are cut at the same time.
constexpr std::ptrdiff_t large_set = 20000;

// What separates two halves ends here in the order; it begins where the set before it ends.
struct Set
{
    int end;
    int parent;
};

class Dissection
{
public:
    Dissection(const Eigen::SparseMatrix<double>& matrix, const Points& places)
        : matrix_(matrix), places_(places), order_(at(matrix.rows())), is_right_(order_.size(), 0)
    {
        std::iota(order_.begin(), order_.end(), 0);
    }

    SeparatorTree run() { return tree_of(dissect_large(order_.begin(), order_.end())); }

private:
    using Place = std::vector<int>::iterator;

    Set set_of(Place end, int parent) { return {static_cast<int>(end - order_.begin()), parent}; }

    // Half of the sets, whose root is below the first of all.
    static void append(const std::vector<Set>& half, std::vector<Set>& all)
    {
        const int before = static_cast<int>(all.size());
        for (Set set : half)
        {
            set.parent = set.parent < 0 ? 0 : set.parent + before;
            all.push_back(set);
        }
    }

    // As dissect(); no vertex of one half touches one of the other.
    std::vector<Set> dissect_large(Place begin, Place end)
    {
        if (end - begin < large_set)
            return dissect(begin, end);
        const std::pair<Place, Place> right_half = cut(begin, end);
        std::vector<Set> left, right;
        parallel_pair([&] { left = dissect_large(begin, right_half.first); },
                      [&] { right = dissect_large(right_half.first, right_half.second); });
        std::vector<Set> all = {set_of(end, -1)};
        append(right, all);
        append(left, all);
        return all;
    }

    // All sets in begin .. end, every one before those below it. Not recursive, so that a
    // degenerate set cannot exhaust the stack.
    std::vector<Set> dissect(Place first, Place last)
    {
        struct Open
        {
            Place begin;
            Place end;
            int parent;
        };
        std::vector<Set> sets;
        std::vector<Open> open = {{first, last, -1}};
        while (!open.empty())
        {
            const auto [begin, end, parent] = open.back();
            open.pop_back();
            const int index = static_cast<int>(sets.size());
            if (end - begin <= smallest_set)
            {
                if (begin != end)
                    sets.push_back(set_of(end, parent));
                continue;
            }
            const auto [coupled, right_end] = cut(begin, end);
            sets.push_back(set_of(end, parent));
            open.push_back({begin, coupled, index});
            open.push_back({coupled, right_end, index});
        }
        return sets;
    }

    // left, separator, right -> left, right, separator; where right begins and ends.
    std::pair<Place, Place> cut(Place begin, Place end)
    {
        const Place middle = begin + (end - begin) / 2;
        halve(begin, middle, end, places_);
        for (Place place = middle; place != end; ++place)
            is_right_[at(*place)] = 1;
        const Place coupled = std::stable_partition(
            begin, middle, [this](int unknown) { return !touches_right(unknown); });
        for (Place place = middle; place != end; ++place)
            is_right_[at(*place)] = 0;
        return {coupled, std::rotate(coupled, middle, end)};
    }

    bool touches_right(int unknown) const
    {
        for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix_, unknown); entry; ++entry)
            if (is_right_[at(entry.row())] != 0)
                return true;
        return false;
    }

    // Sets in reverse are nodes: children before parents, subtrees together.
    SeparatorTree tree_of(const std::vector<Set>& sets)
    {
        const int count = static_cast<int>(sets.size());
        SeparatorTree tree;
        tree.first.push_back(0);
        for (int node = 0; node < count; ++node)
        {
            const Set& set = sets[at(count - 1 - node)];
            tree.first.push_back(set.end);
            tree.parent.push_back(set.parent < 0 ? -1 : count - 1 - set.parent);
            tree.lowest.push_back(node);
        }
        for (int node = 0; node < count; ++node)
            if (const int parent = tree.parent[at(node)]; parent >= 0)
                tree.lowest[at(parent)] = std::min(tree.lowest[at(parent)], tree.lowest[at(node)]);
        tree.order = std::move(order_);
        return tree;
    }

    const Eigen::SparseMatrix<double>& matrix_;
    const Points& places_;
    std::vector<int> order_;
    std::vector<char> is_right_;
};

}  // namespace

int SeparatorTree::common(int a, int b) const
{
    while (!is_below(b, a))
        a = parent[at(a)];
    return a;
}

SeparatorTree nested_dissection(const Eigen::SparseMatrix<double>& matrix, const Points& places)
{
    return Dissection(matrix, places).run();
}

}  // namespace sheetmorph
