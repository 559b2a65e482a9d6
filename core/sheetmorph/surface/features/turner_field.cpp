// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/features/turner_field.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/threads/parallel.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sheetmorph
{

namespace
{

// Fewest for which another thread is worth its start.
constexpr Eigen::Index least_turners = 16;
constexpr Eigen::Index least_blended = 2048;

bool turns_sheet(const Turner& turner)
{
    return turner.turns && !turner.vertices.empty();
}

// How much a feature is held at the field's rotation, by the largest turn of the field between it
// and what lies around it.
double hold(double angle)
{
    constexpr double begins = 75.0 / 180.0 * 3.14159265358979323846;
    constexpr double complete = 150.0 / 180.0 * 3.14159265358979323846;
    const double t = std::clamp((angle - begins) / (complete - begins), 0.0, 1.0);
    return 4.0 * t * t * (3.0 - 2.0 * t);
}

}  // namespace

std::vector<double> farthest_turns(const FeatureResponses& responses, const Points& logs)
{
    const auto farthest = [&](std::size_t k)
    {
        double square = 0.0;
        if (!turns_sheet(responses.turners()[k]))
            return square;
        const Eigen::RowVector3d own = logs.row(responses.turners()[k].vertices.front());
        for (SparseMatrix::InnerIterator entry(responses.weights(), static_cast<Eigen::Index>(k));
             entry; ++entry)
            square = std::max(square, (logs.row(entry.row()) - own).squaredNorm());
        return std::sqrt(square);
    };
    std::vector<double> all(responses.turners().size());
    const auto take = [&](Eigen::Index begin, Eigen::Index end)
    {
        for (std::size_t k = at(begin); k < at(end); ++k)
            all[k] = farthest(k);
    };
    parallel_ranges(responses.weights().cols(), least_turners, take);
    return all;
}

bool hold_far_turned(const FeatureResponses& responses, const std::vector<double>& farthest,
                     const Joints& start, ReducedEnergy& energy)
{
    bool is_held = false;
    for (std::size_t k = 0; k < farthest.size(); ++k)
    {
        const Turner& turner = responses.turners()[k];
        const double amount = turner.turns && turner.body >= 0 ? hold(2.0 * farthest[k]) : 0.0;
        if (amount == 0.0)
            continue;
        is_held = true;
        const int column = responses.columns()[k].turn;
        const Matrix3 stiffness = amount * energy.stiffness.block<3, 3>(column, column);
        const Matrix3 wanted = start.states()[k].rotation - Matrix3::Identity();
        energy.stiffness.block<3, 3>(column, column) += stiffness;
        energy.slope.middleRows<3>(column) -= stiffness * wanted.transpose();
    }
    return is_held;
}

void blend_logs(const FeatureResponses& responses, const std::vector<BodyState>& states,
                Points& logs)
{
    std::vector<std::optional<Eigen::RowVector3d>> turned(states.size());
    for (std::size_t k = 0; k < turned.size(); ++k)
        if (const Turner& turner = responses.turners()[k]; turns_sheet(turner))
        {
            const Vector3 field = logs.row(turner.vertices.front()).transpose();
            turned[k] = log_near(states[k].rotation, field).transpose();
        }
    const WeightsByVertex& weights = responses.weights_by_vertex();
    const auto blend = [&](Eigen::Index begin, Eigen::Index end)
    {
        for (Eigen::Index i = begin; i < end; ++i)
        {
            const Eigen::RowVector3d field = logs.row(i);
            for (WeightsByVertex::InnerIterator entry(weights, i); entry; ++entry)
                if (const auto& log = turned[at(entry.col())])
                    logs.row(i) += entry.value() * (*log - field);
        }
    };
    parallel_ranges(weights.rows(), least_blended, blend);
}

}  // namespace sheetmorph
