// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/nested_dissection.h"

#include <algorithm>
#include <numeric>

namespace sheetmorph
{

namespace
{

// Sets this small are eliminated as they come: their fill is one dense block.
constexpr std::ptrdiff_t smallest_set = 16;

class Dissection
{
public:
    Dissection(const Eigen::SparseMatrix<double>& matrix, const Points& places)
        : matrix_(matrix),
          places_(places),
          order_(static_cast<std::size_t>(matrix.rows())),
          is_right_(order_.size(), 0)
    {
        std::iota(order_.begin(), order_.end(), 0);
    }

    std::vector<int> run()
    {
        // Not recursive, so that a degenerate set cannot exhaust the stack.
        std::vector<std::pair<Place, Place>> open = {{order_.begin(), order_.end()}};
        while (!open.empty())
        {
            const auto [begin, end] = open.back();
            open.pop_back();
            if (end - begin <= smallest_set)
                continue;
            const Place middle = halve(begin, end);
            for (Place place = middle; place != end; ++place)
                is_right_[static_cast<std::size_t>(*place)] = 1;
            const Place coupled = std::stable_partition(
                begin, middle, [this](int unknown) { return !touches_right(unknown); });
            for (Place place = middle; place != end; ++place)
                is_right_[static_cast<std::size_t>(*place)] = 0;
            // left, separator, right -> left, right, separator
            const Place right_end = std::rotate(coupled, middle, end);
            open.emplace_back(begin, coupled);
            open.emplace_back(coupled, right_end);
        }
        return std::move(order_);
    }

private:
    using Place = std::vector<int>::iterator;

    // By a plane across the longest side of the box around the set.
    Place halve(Place begin, Place end)
    {
        Eigen::RowVector3d low = places_.row(*begin), high = low;
        for (Place place = begin; place != end; ++place)
        {
            low = low.cwiseMin(places_.row(*place));
            high = high.cwiseMax(places_.row(*place));
        }
        Eigen::Index axis = 0;
        (high - low).maxCoeff(&axis);
        const Place middle = begin + (end - begin) / 2;
        std::nth_element(begin, middle, end,
                         [this, axis](int a, int b)
                         {
                             const double first = places_(a, axis), second = places_(b, axis);
                             return first < second || (first == second && a < b);
                         });
        return middle;
    }

    bool touches_right(int unknown) const
    {
        for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix_, unknown); entry; ++entry)
            if (is_right_[static_cast<std::size_t>(entry.row())] != 0)
                return true;
        return false;
    }

    const Eigen::SparseMatrix<double>& matrix_;
    const Points& places_;
    std::vector<int> order_;
    std::vector<char> is_right_;
};

}  // namespace

std::vector<int> nested_dissection(const Eigen::SparseMatrix<double>& matrix, const Points& places)
{
    return Dissection(matrix, places).run();
}

}  // namespace sheetmorph
