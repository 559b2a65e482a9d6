// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/features/feature_responses.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/surface/features/turner_weights.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace sheetmorph::surface
{

namespace
{

constexpr int none = -1;
// Columns per substitution, a multiple of the right-hand sides of a register, and substitutions
// before the memory is checked. Chosen, not measured.
constexpr Eigen::Index block = 24;
constexpr Eigen::Index blocks_at_once = 4;
// Limit on the memory of responses. Chosen: 512 MiB; a computer with 4 GiB has room for it.
constexpr double most_bytes = 512.0 * 1048576;
constexpr Eigen::Index few_slopes = 8;  // fewest worth a thread: some ten microseconds

// Numbers of the responses that the constructor computes; more wait for the first drag. Chosen, not
// measured: estimated at 10 ns a number, 10 ms.
constexpr double few_numbers = 1e6;

// Error of live responses, relative to the size. From the accuracy of a frame, 1e-6: 3 columns for
// each of up to 60 features add up to it in the worst case.
constexpr double miss_a_size = 5e-9;

// Relative to the stiffness of a rigid sheet. From rounding: differences of such stiffnesses are
// exact to 1e-16 times a condition of 1e6.
constexpr double unfelt = 1e-10;

// Relative to the size. From mesh::exactness(): a shorter shift is rounding.
constexpr double no_shift = 1e-12;

// Relative to the stiffest rotation, of the factor's diagonal. From `unfelt`, which is its square.
constexpr double least_pivot = 1e-5;

}  // namespace

FeatureResponses::FeatureResponses(const RotationFieldInput& input,
                                   const numerics::ConstrainedMinimiser& minimiser,
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
    offsets_ = direct_moves();
    turned_rows_ = turned_rows();
    find_stiffness();
    factor_at_rest();
    responses_ = numerics::ResponseFields(mesh_.points(), count_);
    if (static_cast<double>(count_) * mesh_.vertex_count() <= few_numbers)
        fields();
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

numerics::SparseMatrix FeatureResponses::direct_moves() const
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
    numerics::SparseMatrix moves(mesh_.vertex_count(), count_);
    // A vertex listed twice in a feature moves once.
    moves.setFromTriplets(entries.begin(), entries.end(),
                          [](double, double latest) { return latest; });
    return moves;
}

// Rotations of the rest rows around the rotating bodies, by column.
numerics::SparseMatrix FeatureResponses::turned_rows() const
{
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t row = 0; row < operators_.row_vertices.size(); ++row)
        for (auto entry = weights_.at_vertex(operators_.row_vertices[row]); entry; ++entry)
            for (int b = 0; b < 3 && columns_[at(entry.col())].turn != none; ++b)
                entries.emplace_back(row, columns_[at(entry.col())].turn + b,
                                     entry.value() * operators_.rest_rows(row, b));
    numerics::SparseMatrix turned(operators_.rest_rows.rows(), count_);
    turned.setFromTriplets(entries.begin(), entries.end());
    return turned;
}

// The targets of the sheet for columns first, first + 1, ...
numerics::ConstrainedMinimiser::Targets FeatureResponses::asked_of(Eigen::Index first,
                                                                   Eigen::Index count) const
{
    numerics::ConstrainedMinimiser::Targets asked;
    asked.rows = Eigen::MatrixXd(turned_rows_.middleCols(first, count));
    asked.offset = Eigen::MatrixXd(offsets_.middleCols(first, count));
    asked.constraints =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(constraints_.points.size()), count);
    return asked;
}

// Sets the stiffness of entries to zero to which the sheet yields fully; rounding must not
// determine them.
void FeatureResponses::find_stiffness()
{
    stiffness_ = minimiser_.energies(turned_rows_, offsets_);
    stiffness_ = 0.5 * (stiffness_ + stiffness_.transpose()).eval();
    const numerics::SparseMatrix asked = operators_.rows * offsets_ - turned_rows_;
    const double stiffest = Eigen::VectorXd(operators_.stiffness->diagonal()).maxCoeff();
    const double by_rounding = stiffest * std::pow(no_shift * mesh_.size(), 2);
    for (Eigen::Index k = 0; k < count_; ++k)
    {
        double unyielding = 0.0;
        for (numerics::SparseMatrix::InnerIterator entry(asked, k); entry; ++entry)
            unyielding += operators_.weights(entry.row()) * entry.value() * entry.value();
        if (stiffness_(k, k) > std::max(unfelt * unyielding, by_rounding))
            continue;
        stiffness_.row(k).setZero();
        stiffness_.col(k).setZero();
        unfelt_.push_back(static_cast<int>(k));
    }
}

const numerics::ResponseFields* FeatureResponses::fields(const Progress& progress) const
{
    const std::lock_guard<std::mutex> lock(responding_);
    while (responses_.columns() < count_ && responses_.bytes() <= most_bytes)
    {
        const Eigen::Index first = responses_.columns();
        progress.report(static_cast<double>(first) / count_, "responses of features");
        respond(first);
    }
    is_responded_ = responses_.bytes() <= most_bytes;
    return is_responded_ ? &responses_ : nullptr;
}

// Computes the next columns, several blocks in parallel.
void FeatureResponses::respond(Eigen::Index first) const
{
    const Eigen::Index left = (count_ - first + block - 1) / block;
    std::vector<Eigen::MatrixXd> answers(at(std::min(blocks_at_once, left)));
    const auto answer = [&](Eigen::Index k)
    {
        const Eigen::Index begin = first + k * block;
        answers[at(k)] = minimiser_.minimum(asked_of(begin, std::min(block, count_ - begin)), 0).u;
    };
    parallel_items(static_cast<Eigen::Index>(answers.size()), answer);
    for (const Eigen::MatrixXd& columns : answers)
        responses_.append(columns,
                          Eigen::VectorXd::Constant(columns.cols(), miss_a_size * mesh_.size()));
}

// Two rotating bodies contribute 2 (tr G_kl - G_kl^T), see TurnExpansion.
void FeatureResponses::factor_at_rest()
{
    numerics::Weights matrix(count_, count_);
    for (const TurnerColumns& one : columns_)
        for (const TurnerColumns& other : columns_)
        {
            if (one.turn == none || one.shift != none || other.turn == none || other.shift != none)
                return;
            const Matrix3 both = stiffness_.block<3, 3>(one.turn, other.turn);
            matrix.block<3, 3>(one.turn, other.turn) =
                2.0 * (both.trace() * Matrix3::Identity() - both.transpose());
        }
    const double stiffest = std::sqrt(matrix.diagonal().cwiseAbs().maxCoeff());
    try
    {
        at_rest_.emplace(std::move(matrix));
        if (at_rest_->smallest_pivot() < least_pivot * stiffest)
            at_rest_.reset();
    }
    catch (const SolverError&)
    {
        // Not positive definite.
    }
}

// Psi^T W residual without Psi: phi^T B^T W residual is offset^T forces. The forces vanish on all
// free unknowns, and phi moves no constrained point.
Eigen::MatrixXd FeatureResponses::slopes(const numerics::ConstrainedMinimiser::Balance& left) const
{
    const numerics::Weights weighted =
        operators_.weights.asDiagonal() * left.residual;  // rows contiguous
    Eigen::MatrixXd found(count_, left.forces.cols());
    const auto find = [&](Eigen::Index begin, Eigen::Index end)
    {
        const Eigen::Index count = end - begin;
        found.middleRows(begin, count) =
            offsets_.middleCols(begin, count).transpose() * left.forces
            - turned_rows_.middleCols(begin, count).transpose() * weighted;
    };
    parallel_ranges(count_, few_slopes, find);
    for (const int column : unfelt_)
        found.row(column).setZero();
    return found;
}

ReducedEnergy FeatureResponses::energy(const numerics::ConstrainedMinimiser::Targets& asked,
                                       const numerics::ConstrainedMinimiser::Solution& base) const
{
    return {stiffness_, slopes(asked, base)};
}

Eigen::MatrixXd FeatureResponses::slopes(const numerics::ConstrainedMinimiser::Targets& asked,
                                         const numerics::ConstrainedMinimiser::Solution& base) const
{
    return slopes(minimiser_.balance(asked, base));
}

std::optional<Eigen::MatrixXd> FeatureResponses::displacements(const Eigen::MatrixXd& rho) const
{
    if (!is_responded_)
        return std::nullopt;
    return Eigen::MatrixXd(responses_.times(rho));
}

}  // namespace sheetmorph::surface
