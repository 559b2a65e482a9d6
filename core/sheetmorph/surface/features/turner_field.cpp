// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/features/turner_field.h"

#include "sheetmorph/base/angles.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/threads/parallel.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

namespace sheetmorph::surface
{

namespace
{

// Fewest vertices for a thread. Chosen, not measured.
constexpr Eigen::Index least_blended = 2048;

bool turns_sheet(const Turner& turner)
{
    return turner.turns && !turner.vertices.empty();
}

// Stiffness that constrains a feature to the field's rotation, relative to its own, as a function
// of the largest angle between field and feature (radians): a smooth step from 0 to 4.
double hold(double angle)
{
    // Chosen: full stiffness before half a turn, where the rotation of a body becomes ambiguous,
    // and none at the rotations of usual drags, so that a body keeps its six degrees of freedom.
    constexpr double begins = 75.0 / 180.0 * pi;
    constexpr double complete = 150.0 / 180.0 * pi;
    const double t = std::clamp((angle - begins) / (complete - begins), 0.0, 1.0);
    return 4.0 * t * t * (3.0 - 2.0 * t);
}

}  // namespace

std::vector<double> farthest_turns(const FeatureResponses& responses, const Points& logs)
{
    const std::vector<Turner>& turners = responses.turners();
    Eigen::ArrayXd squares = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(turners.size()));
    std::mutex joining;
    const auto look = [&](Eigen::Index begin, Eigen::Index end)
    {
        Eigen::ArrayXd largest = Eigen::ArrayXd::Zero(squares.size());
        for (Eigen::Index i = begin; i < end; ++i)
            for (auto entry = responses.weights().at_vertex(i); entry; ++entry)
                if (const Turner& turner = turners[at(entry.col())]; turns_sheet(turner))
                {
                    const auto turn = logs.row(i) - logs.row(turner.vertices.front());
                    largest(entry.col()) = std::max(largest(entry.col()), turn.squaredNorm());
                }
        const std::lock_guard<std::mutex> lock(joining);
        squares = squares.max(largest);
    };
    parallel_ranges(responses.weights().vertices(), least_blended, look);
    std::vector<double> all(turners.size());
    Eigen::Map<Eigen::ArrayXd>(all.data(), squares.size()) = squares.sqrt();
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
    const SmoothWeights& weights = responses.weights();
    const auto blend = [&](Eigen::Index begin, Eigen::Index end)
    {
        for (Eigen::Index i = begin; i < end; ++i)
        {
            const Eigen::RowVector3d field = logs.row(i);
            for (auto entry = weights.at_vertex(i); entry; ++entry)
                if (const auto& log = turned[at(entry.col())])
                    logs.row(i) += entry.value() * (*log - field);
        }
    };
    parallel_ranges(weights.vertices(), least_blended, blend);
}

}  // namespace sheetmorph::surface
