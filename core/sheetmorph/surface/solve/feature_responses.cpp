// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/solve/feature_responses.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/parallel.h"
#include "sheetmorph/surface/rotation/turner_weights.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace sheetmorph
{

namespace
{

constexpr int none = -1;
constexpr Eigen::Index block = 24;  // columns solved together
constexpr Eigen::Index blocks_at_once = 4;
constexpr double most_bytes = 512.0 * 1048576;  // of responses worth keeping
constexpr int refinements = 1;
constexpr Eigen::Index least_turned = 50000;  // rows of columns that are worth a thread
constexpr double miss_a_size = 5e-9;          // of the responses of live frames

}  // namespace

FeatureResponses::FeatureResponses(const RotationFieldInput& input, const StitchArms& arms,
                                   const ConstrainedMinimiser& minimiser,
                                   std::vector<Turner> turners)
    : mesh_(input.mesh),
      constraints_(input.constraints),
      roles_(input.roles),
      operators_(input.operators),
      minimiser_(minimiser),
      turners_(std::move(turners)),
      weights_(turner_weights(input, turners_))
{
    number_columns();
    offsets_ = direct_moves(arms);
    respond();
}

void FeatureResponses::number_columns()
{
    for (const Turner& turner : turners_)
    {
        TurnerColumns columns;
        if (turner.is_turned())
            columns.turn = std::exchange(count_, count_ + 3);
        if (turner.is_bound)
            columns.shift = count_++;
        columns_.push_back(columns);
    }
}

SparseMatrix FeatureResponses::direct_moves(const StitchArms& arms) const
{
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t k = 0; k < turners_.size(); ++k)
    {
        if (turners_[k].body < 0)
            continue;
        const Vector3& centre = roles_.bodies[at(turners_[k].body)].centre;
        for (const int vertex : turners_[k].vertices)
        {
            for (int b = 0; b < 3; ++b)
                entries.emplace_back(vertex, columns_[k].turn + b,
                                     mesh_.points()(vertex, b) - centre(b));
            if (turners_[k].is_bound)
                entries.emplace_back(vertex, columns_[k].shift, 1.0);
        }
    }
    using WeightRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
    const WeightRows weights(weights_);
    arms.for_each(
        [&](int vertex, const Vector3& arm)
        {
            for (WeightRows::InnerIterator entry(weights, vertex); entry; ++entry)
                for (int b = 0; b < 3 && columns_[at(entry.col())].turn != none; ++b)
                    entries.emplace_back(vertex, columns_[at(entry.col())].turn + b,
                                         entry.value() * arm(b));
        });
    SparseMatrix moves(mesh_.vertex_count(), count_);
    // A vertex listed twice in a feature moves once.
    moves.setFromTriplets(entries.begin(), entries.end(),
                          [](double, double latest) { return latest; });
    return moves;
}

// What columns first, first + 1, ... ask of the sheet: turners turn the rest rows around them.
ConstrainedMinimiser::Targets FeatureResponses::asked_of(Eigen::Index first,
                                                         Eigen::Index count) const
{
    ConstrainedMinimiser::Targets asked;
    asked.rows = Eigen::MatrixXd::Zero(operators_.rest_rows.rows(), count);
    asked.offset = Eigen::MatrixXd(offsets_.middleCols(first, count));
    asked.constraints =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(constraints_.points.size()), count);
    for (std::size_t k = 0; k < turners_.size(); ++k)
        for (int b = 0; b < 3 && columns_[k].turn != none; ++b)
        {
            const Eigen::Index column = columns_[k].turn + b - first;
            if (column < 0 || column >= count)
                continue;
            const Eigen::VectorXd weight = weights_.col(static_cast<Eigen::Index>(k));
            for (Eigen::Index row = 0; row < asked.rows.rows(); ++row)
                asked.rows(row, column) =
                    weight(operators_.row_vertices[at(row)]) * operators_.rest_rows(row, b);
        }
    return asked;
}

void FeatureResponses::respond()
{
    responses_.emplace(mesh_.points(), count_);
    stiffness_.resize(count_, count_);
    for (Eigen::Index first = 0; first < count_; first += blocks_at_once * block)
    {
        const Eigen::Index left = (count_ - first + block - 1) / block;
        std::vector<Eigen::MatrixXd> answers(at(std::min(blocks_at_once, left)));
        parallel_items(static_cast<Eigen::Index>(answers.size()),
                       [&](Eigen::Index k) { answers[at(k)] = answer(first + k * block); });
        for (const Eigen::MatrixXd& answer : answers)
            if (responses_)
                responses_->append(
                    answer, Eigen::VectorXd::Constant(answer.cols(), miss_a_size * mesh_.size()));
        if (responses_ && responses_->bytes() > most_bytes)
            responses_.reset();
    }
    stiffness_ = 0.5 * (stiffness_ + stiffness_.transpose()).eval();
}

// Of the next columns, and their part of the stiffness.
Eigen::MatrixXd FeatureResponses::answer(Eigen::Index first)
{
    const Eigen::Index count = std::min(block, count_ - first);
    const ConstrainedMinimiser::Targets asked = asked_of(first, count);
    ConstrainedMinimiser::Solution answer = minimiser_.minimum(asked, refinements);
    stiffness_.middleCols(first, count) = slopes(minimiser_.balance(asked, answer));
    return std::move(answer.u);
}

// Psi^T W residual without Psi: phi^T B^T W residual is offset^T forces, since forces vanish on
// all that the sheet can move and phi moves no constrained point.
Eigen::MatrixXd FeatureResponses::slopes(const ConstrainedMinimiser::Balance& left) const
{
    Eigen::MatrixXd slopes = offsets_.transpose() * left.forces;
    const auto turn_columns = [&](Eigen::Index begin, Eigen::Index end)
    {
        Points moments(mesh_.vertex_count(), 3);
        for (Eigen::Index column = begin; column < end; ++column)
        {
            moments.setZero();
            for (Eigen::Index row = 0; row < left.residual.rows(); ++row)
                moments.row(operators_.row_vertices[at(row)]) += operators_.weights(row)
                                                                 * left.residual(row, column)
                                                                 * operators_.rest_rows.row(row);
            const Eigen::MatrixXd turned = weights_.transpose() * moments;
            for (std::size_t k = 0; k < turners_.size(); ++k)
                if (columns_[k].turn != none)
                    slopes.block<3, 1>(columns_[k].turn, column) -=
                        turned.row(static_cast<Eigen::Index>(k)).transpose();
        }
    };
    parallel_ranges(slopes.cols(), 1 + least_turned / std::max(1, mesh_.vertex_count()),
                    turn_columns);
    return slopes;
}

ReducedEnergy FeatureResponses::energy(const ConstrainedMinimiser::Targets& asked,
                                       const ConstrainedMinimiser::Solution& base) const
{
    return {stiffness_, slopes(asked, base)};
}

Eigen::MatrixXd FeatureResponses::slopes(const ConstrainedMinimiser::Targets& asked,
                                         const ConstrainedMinimiser::Solution& base) const
{
    return slopes(minimiser_.balance(asked, base));
}

std::optional<Eigen::MatrixXd> FeatureResponses::displacements(const Eigen::MatrixXd& rho) const
{
    if (!responses_)
        return std::nullopt;
    return Eigen::MatrixXd(responses_->times(rho));
}

}  // namespace sheetmorph
