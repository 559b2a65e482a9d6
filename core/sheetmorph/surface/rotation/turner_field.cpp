// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/rotation/turner_field.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

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
    std::vector<double> farthest(responses.turners().size(), 0.0);
    for (std::size_t k = 0; k < farthest.size(); ++k)
    {
        const Turner& turner = responses.turners()[k];
        if (!turner.turns || turner.vertices.empty())
            continue;
        const Eigen::RowVector3d own = logs.row(turner.vertices.front());
        for (SparseMatrix::InnerIterator entry(responses.weights(), static_cast<Eigen::Index>(k));
             entry; ++entry)
            farthest[k] = std::max(farthest[k], (logs.row(entry.row()) - own).norm());
    }
    return farthest;
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
    const Points field = logs;
    const SparseMatrix& weights = responses.weights();
    for (Eigen::Index k = 0; k < weights.cols(); ++k)
    {
        const Turner& turner = responses.turners()[at(k)];
        if (!turner.turns || turner.vertices.empty())
            continue;
        const Vector3 reference = field.row(turner.vertices.front()).transpose();
        const Vector3 log = log_near(states[at(k)].rotation, reference);
        for (SparseMatrix::InnerIterator entry(weights, k); entry; ++entry)
            logs.row(entry.row()) += entry.value() * (log.transpose() - field.row(entry.row()));
    }
}

}  // namespace sheetmorph
