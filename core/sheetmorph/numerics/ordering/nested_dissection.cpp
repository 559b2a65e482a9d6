// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/ordering/nested_dissection.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/base/threads/stopping.h"
#include "sheetmorph/numerics/ordering/halving.h"
#include "sheetmorph/numerics/ordering/vertex_cover.h"

#include <algorithm>
#include <numeric>

namespace sheetmorph::numerics
{

namespace
{

// Smaller sets are not divided. Chosen: an interior vertex has about 6 neighbours (18 for the
// energy), so the fill of 12 vertices is one dense block in any order.
constexpr std::ptrdiff_t smallest_set = 12;

// From this many rows on, two threads cut the halves; from halving.cpp.
constexpr std::ptrdiff_t large_set = 20000;

constexpr int unnumbered = -1;

using SparseMatrix = Eigen::SparseMatrix<double>;

// A separator: it ends here in the order and begins where the set before it ends.
struct Set
{
    int end;
    int parent;
};

class Dissection
{
public:
    Dissection(const SparseMatrix& matrix, const Points& places)
        : matrix_(matrix), places_(places), order_(at(matrix.rows())), mark_(order_.size(), 0)
    {
        std::iota(order_.begin(), order_.end(), 0);
    }

    SeparatorTree run() { return tree_of(dissect_large(order_.begin(), order_.end())); }

private:
    using Place = std::vector<int>::iterator;

    Set set_of(Place end, int parent) { return {static_cast<int>(end - order_.begin()), parent}; }

    // Appends the sets of one half, whose root is below the first set of all.
    static void append(const std::vector<Set>& half, std::vector<Set>& all)
    {
        const int before = static_cast<int>(all.size());
        for (Set set : half)
        {
            set.parent = set.parent < 0 ? 0 : set.parent + before;
            all.push_back(set);
        }
    }

    // As dissect(), with both halves in parallel, because no vertex of one touches the other.
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

    // Reorders (left, right) to (left, right, separator). Returns where right begins and ends. The
    // separator takes rows of both halves: the fewest that touch all entries between them.
    std::pair<Place, Place> cut(Place begin, Place end)
    {
        look_for_stop();
        const Place middle = begin + (end - begin) / 2;
        halve(begin, middle, end, places_);
        const std::vector<int> separator = separator_of(begin, middle, end);
        for (const int row : separator)
            mark_[at(row)] = 1;
        const auto is_apart = [this](int row) { return mark_[at(row)] == 0; };
        const Place left_end = std::stable_partition(begin, middle, is_apart);
        const Place right_end = std::stable_partition(middle, end, is_apart);
        for (const int row : separator)
            mark_[at(row)] = 0;
        return {left_end, std::rotate(left_end, middle, right_end)};
    }

    std::vector<int> separator_of(Place begin, Place middle, Place end)
    {
        BipartiteGraph graph;
        std::vector<int> left, right;  // rows of the graph's vertices
        std::for_each(middle, end, [this](int row) { mark_[at(row)] = unnumbered; });
        std::for_each(begin, middle,
                      [&](int row)
                      {
                          for (SparseMatrix::InnerIterator entry(matrix_, row); entry; ++entry)
                              if (int& mark = mark_[at(entry.row())]; mark != 0)
                              {
                                  if (mark == unnumbered)
                                  {
                                      right.push_back(static_cast<int>(entry.row()));
                                      mark = static_cast<int>(right.size());
                                  }
                                  graph.right.push_back(mark - 1);
                              }
                          if (at(graph.first.back()) == graph.right.size())
                              return;
                          left.push_back(row);
                          graph.first.push_back(static_cast<int>(graph.right.size()));
                      });
        std::for_each(middle, end, [this](int row) { mark_[at(row)] = 0; });
        graph.right_count = static_cast<int>(right.size());
        const VertexCover cover = smallest_vertex_cover(graph);
        std::vector<int> separator;
        for (std::size_t k = 0; k < left.size(); ++k)
            if (cover.left[k] != 0)
                separator.push_back(left[k]);
        for (std::size_t k = 0; k < right.size(); ++k)
            if (cover.right[k] != 0)
                separator.push_back(right[k]);
        return separator;
    }

    // In reverse order, sets are nodes: children before parents, and subtrees together.
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

    const SparseMatrix& matrix_;
    const Points& places_;
    std::vector<int> order_;
    std::vector<int> mark_;  // of the rows of the current set
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

}  // namespace sheetmorph::numerics
