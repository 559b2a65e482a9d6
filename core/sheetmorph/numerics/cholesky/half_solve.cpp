// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/half_solve.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/numerics/cholesky/dense_cholesky.h"
#include "sheetmorph/numerics/cholesky/front_kernel.h"

namespace sheetmorph::numerics
{

namespace
{

// Largest share of the factor in a subtree that is one task. Chosen as in front_pattern.cpp.
constexpr double task_share = 1.0 / 16.0;

using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

//! The columns that reach a front, their values on its rows, and the products of their own rows.
struct Reached
{
    std::vector<int> columns;    // ascending
    std::vector<double> values;  // (groups, rows, sides)
    Weights product;             // of the own rows, negative; lower triangle
};

class HalfSolve
{
public:
    HalfSolve(const FrontList& factor, const SparseRows& right)
        : factor_(factor),
          right_(right),
          sides_(has_many_sides() ? many_sides : few_sides),
          children_(factor.fronts.size()),
          reached_(factor.fronts.size())
    {
        for (std::size_t f = 0; f < children_.size(); ++f)
            if (const int parent = factor_.parent[f]; parent >= 0)
                children_[at(parent)].push_back(static_cast<int>(f));
    }

    Weights product()
    {
        std::vector<int> top;
        const std::vector<std::vector<int>> tasks = subtrees(top);
        parallel_items(static_cast<Eigen::Index>(tasks.size()),
                       [&](Eigen::Index task)
                       {
                           Scratch scratch(*this);
                           for (const int f : tasks[at(task)])
                               solve(f, scratch);
                       });
        Scratch scratch(*this);
        for (const int f : top)
            solve(f, scratch);
        return sum();
    }

private:
    // By slot and by column: row and column of the current front.
    struct Scratch
    {
        explicit Scratch(const HalfSolve& whole)
            : rows(at(whole.factor_.slots), 0), columns(at(whole.right_.cols()), 0)
        {
        }
        std::vector<int> rows, columns;
    };

    const Front& front(int f) const { return *factor_.fronts[at(f)]; }

    // Fronts of independent subtrees, children first, and the fronts above them.
    std::vector<std::vector<int>> subtrees(std::vector<int>& top) const
    {
        const auto count = static_cast<int>(factor_.fronts.size());
        std::vector<double> below(at(count), 0.0);
        for (int f = 0; f < count; ++f)
        {
            below[at(f)] += front(f).count();
            if (const int parent = factor_.parent[at(f)]; parent >= 0)
                below[at(parent)] += below[at(f)];
        }
        std::vector<std::vector<int>> tasks;
        std::vector<int> task(at(count), -1);
        for (int f = count - 1; f >= 0; --f)
        {
            const int parent = factor_.parent[at(f)];
            if (parent >= 0 && task[at(parent)] >= 0)
                task[at(f)] = task[at(parent)];
            else if (below[at(f)] <= task_share * factor_.count())
            {
                task[at(f)] = static_cast<int>(tasks.size());
                tasks.emplace_back();
            }
        }
        for (int f = 0; f < count; ++f)
            (task[at(f)] >= 0 ? tasks[at(task[at(f)])] : top).push_back(f);
        return tasks;
    }

    double& value(Reached& reached, const Front& own, int row, int column) const
    {
        const std::size_t group = at(column / sides_) * at(own.height()) * at(sides_);
        return reached.values[group + at(row * sides_ + column % sides_)];
    }

    void solve(int f, Scratch& scratch)
    {
        const Front& own = front(f);
        Reached& reached = reached_[at(f)];
        find_columns(f, reached);
        if (!reached.columns.empty())
        {
            for (int row = 0; row < own.height(); ++row)
                scratch.rows[at(own.rows()[at(row)])] = row;
            for (std::size_t k = 0; k < reached.columns.size(); ++k)
                scratch.columns[at(reached.columns[k])] = static_cast<int>(k);
            gather(f, scratch);
            finish(own, reached);
        }
        for (const int child : children_[at(f)])
            std::vector<double>().swap(reached_[at(child)].values);
    }

    void find_columns(int f, Reached& reached) const
    {
        for (const int child : children_[at(f)])
            if (front(child).below() > 0)
                reached.columns.insert(reached.columns.end(), reached_[at(child)].columns.begin(),
                                       reached_[at(child)].columns.end());
        for (int row = 0; row < front(f).columns; ++row)
            for (SparseRows::InnerIterator entry(right_, front(f).rows()[at(row)]); entry; ++entry)
                reached.columns.push_back(static_cast<int>(entry.col()));
        make_set(reached.columns);
    }

    void gather(int f, const Scratch& scratch)
    {
        const Front& own = front(f);
        Reached& reached = reached_[at(f)];
        const std::size_t groups = (reached.columns.size() + at(sides_) - 1) / at(sides_);
        reached.values.assign(groups * at(own.height()) * at(sides_), 0.0);
        for (int row = 0; row < own.columns; ++row)
            for (SparseRows::InnerIterator entry(right_, own.rows()[at(row)]); entry; ++entry)
                value(reached, own, row, scratch.columns[at(entry.col())]) += entry.value();
        for (const int child : children_[at(f)])
        {
            const Front& from = front(child);
            Reached& passed = reached_[at(child)];
            for (std::size_t k = 0; k < passed.columns.size(); ++k)
                for (int row = from.columns; row < from.height(); ++row)
                    value(reached, own, scratch.rows[at(from.rows()[at(row)])],
                          scratch.columns[at(passed.columns[k])]) +=
                        value(passed, from, row, static_cast<int>(k));
        }
    }

    void finish(const Front& own, Reached& reached) const
    {
        const auto count = static_cast<Eigen::Index>(reached.columns.size());
        parallel_ranges((count + sides_ - 1) / sides_, least_groups(own),
                        [&](Eigen::Index begin, Eigen::Index end)
                        {
                            for (Eigen::Index group = begin; group < end; ++group)
                                run_forward(
                                    own, sides_,
                                    &value(reached, own, 0, static_cast<int>(group) * sides_));
                        });
        Weights solved(count, own.columns);
        for (int column = 0; column < count; ++column)
            for (int row = 0; row < own.columns; ++row)
                solved(column, row) = value(reached, own, row, column);
        reached.product.setZero(count, count);
        subtract_own_product(solved, reached.product);
    }

    // Fewest groups of a range.
    static Eigen::Index least_groups(const Front& own)
    {
        // Entries of the factor that a range reads. Chosen, not measured: each serves four or eight
        // right-hand sides. Estimated at 1 ns an entry, a range takes 100 microseconds, three times
        // as long as waking a thread.
        constexpr double least_entries = 1e5;
        return static_cast<Eigen::Index>(least_entries / (own.count() + 1.0)) + 1;
    }

    Weights sum() const
    {
        Weights all = Weights::Zero(right_.cols(), right_.cols());
        for (const Reached& reached : reached_)
            for (Eigen::Index i = 0; i < reached.product.rows(); ++i)
                for (Eigen::Index j = 0; j <= i; ++j)
                    all(reached.columns[at(i)], reached.columns[at(j)]) -= reached.product(i, j);
        return all;
    }

    const FrontList& factor_;
    const SparseRows& right_;
    const int sides_;
    std::vector<std::vector<int>> children_;
    std::vector<Reached> reached_;
};

}  // namespace

Weights half_solved_product(const FrontList& factor, const SparseRows& right)
{
    return HalfSolve(factor, right).product();
}

}  // namespace sheetmorph::numerics
