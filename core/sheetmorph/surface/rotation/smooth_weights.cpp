// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/rotation/smooth_weights.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/parallel.h"

#include <algorithm>
#include <utility>

namespace sheetmorph::surface
{

namespace
{

constexpr std::size_t together = 48;           // groups per substitution; chosen, not measured
constexpr Eigen::Index least_weighted = 2048;  // fewest for a thread; chosen, not measured
constexpr int none = -1;

double smoothed(double weight, double faded)
{
    const double w = std::clamp((weight - faded) / (1.0 - faded), 0.0, 1.0);
    return w * w * (3.0 - 2.0 * w);
}

std::vector<int> owners(Eigen::Index vertex_count, const std::vector<VertexIds>& groups)
{
    std::vector<int> owner(at(vertex_count), none);
    for (std::size_t k = 0; k < groups.size(); ++k)
        for (const int vertex : groups[k])
            owner[at(vertex)] = static_cast<int>(k);
    return owner;
}

//! The columns of the groups before normalisation.
struct Columns
{
    numerics::SparseMatrix weights;
    Eigen::VectorXd given;  // by vertex: sum of the weights before smoothing
    Eigen::VectorXd sums;   // by vertex: sum of the smoothed weights
    WeightCount count;

    Columns(Eigen::Index vertices, Eigen::Index groups, const WeightCount& how)
        : weights(vertices, groups),
          given(Eigen::VectorXd::Zero(vertices)),
          sums(Eigen::VectorXd::Zero(vertices)),
          count(how)
    {
    }

    void add(Eigen::Index vertex, Eigen::Index group, double weight)
    {
        given(vertex) += weight;
        const double share = weight > count.least ? smoothed(weight, count.faded) : 0.0;
        if (share == 0.0)
            return;
        sums(vertex) += share;
        weights.insertBack(vertex, group) = share;
    }

    void normalise()
    {
        weights.finalize();
        for (Eigen::Index i = 0; count.has_rest && i < given.size(); ++i)
            sums(i) += smoothed(1.0 - given(i), count.faded);
        for (Eigen::Index k = 0; k < weights.cols(); ++k)
            for (numerics::SparseMatrix::InnerIterator entry(weights, k); entry; ++entry)
                entry.valueRef() /= sums(entry.row());
    }
};

}  // namespace

Eigen::MatrixXd pull_of(const WeightedSheet& sheet, const VertexIds* groups, Eigen::Index count)
{
    Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(sheet.unknowns.count, count);
    for (Eigen::Index k = 0; k < count; ++k)
        for (const int vertex : groups[k])
            for (numerics::SparseMatrix::InnerIterator entry(sheet.harmonic, vertex); entry;
                 ++entry)
                if (const int unknown = sheet.unknowns.of_vertex[at(entry.row())];
                    unknown != Unknowns::known)
                    pull(unknown, k) += entry.value();
    return pull;
}

SmoothWeights::SmoothWeights(const WeightedSheet& sheet, const std::vector<VertexIds>& groups,
                             const WeightCount& count)
{
    const Eigen::Index vertex_count = sheet.harmonic.rows();
    const std::vector<int> owner = owners(vertex_count, groups);
    Columns columns(vertex_count, static_cast<Eigen::Index>(groups.size()), count);
    for (std::size_t first = 0; first < groups.size(); first += together)
    {
        const auto wide = static_cast<Eigen::Index>(std::min(together, groups.size() - first));
        const Eigen::MatrixXd pulled =
            sheet.factor.solve(pull_of(sheet, groups.data() + first, wide));
        for (Eigen::Index k = 0; k < wide; ++k)
        {
            const Eigen::Index group = static_cast<Eigen::Index>(first) + k;
            columns.weights.startVec(group);
            for (Eigen::Index i = 0; i < vertex_count; ++i)
                if (owner[at(i)] == static_cast<int>(group))
                    columns.add(i, group, 1.0);
                else if (const int unknown = sheet.unknowns.of_vertex[at(i)];
                         unknown != Unknowns::known)
                    columns.add(i, group, -pulled(unknown, k));
        }
    }
    columns.normalise();
    by_vertex_ = columns.weights;
}

void SmoothWeights::fill_tied(const std::vector<Tie>& ties)
{
    if (!ties.empty())
        by_vertex_ = numerics::SparseMatrix(tie_basis(vertices(), ties)
                                            * numerics::SparseMatrix(by_vertex_));
}

double SmoothWeights::sum(Eigen::Index vertex) const
{
    double all = 0.0;
    for (auto entry = at_vertex(vertex); entry; ++entry)
        all += entry.value();
    return all;
}

Points SmoothWeights::times(const Points& values) const
{
    Points found(vertices(), 3);
    const auto weigh = [&](Eigen::Index begin, Eigen::Index end)
    {
        for (Eigen::Index i = begin; i < end; ++i)
        {
            Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
            for (auto entry = at_vertex(i); entry; ++entry)
                sum += entry.value() * values.row(entry.col());
            found.row(i) = sum;
        }
    };
    parallel_ranges(vertices(), least_weighted, weigh);
    return found;
}

}  // namespace sheetmorph::surface
