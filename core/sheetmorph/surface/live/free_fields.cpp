// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/live/free_fields.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/surface/rotation/turner_field.h"
#include "sheetmorph/surface/solve/reduced_minimum.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

// Radians: Newton's steps square what is left, so that less than 1e-9 is.
constexpr double live_precision = 1e-5;

}  // namespace

FreeFields::FreeFields(const FeatureResponses* responses, const Eigen::MatrixXd& weights)
    : responses_(responses), weights_(weights)
{
    if (responses == nullptr)
        return;
    const SparseMatrix& own = responses->weights();
    left_ = Eigen::VectorXd::Ones(own.rows()) - own * Eigen::VectorXd::Ones(own.cols());
    spread_ = Eigen::MatrixXd::Zero(own.cols(), weights.cols());
    for (Eigen::Index k = 0; k < own.cols(); ++k)
        for (SparseMatrix::InnerIterator entry(own, k); entry; ++entry)
        {
            const int first = responses->turners()[at(k)].vertices.front();
            spread_.row(k) =
                spread_.row(k).cwiseMax((weights.row(entry.row()) - weights.row(first)).cwiseAbs());
        }
    const auto count = 3 * static_cast<Eigen::Index>(responses->turners().size());
    stiffness_.resize(count, count);
    slopes_.resize(count, 0);
}

bool FreeFields::is_possible(const PlacementInput& part, const FeatureResponses* responses)
{
    if (responses == nullptr)
        return true;
    const auto is_plain = [&](const Turner& turner)
    {
        return turner.body >= 0 && turner.turns && !turner.is_bound
               && part.roles.bodies[at(turner.body)].handle < 0;
    };
    const std::vector<Turner>& turners = responses->turners();
    return std::all_of(turners.begin(), turners.end(), is_plain) && responses->fields() != nullptr;
}

bool FreeFields::turns(int body) const
{
    if (responses_ == nullptr)
        return false;
    const std::vector<Turner>& turners = responses_->turners();
    return std::any_of(turners.begin(), turners.end(),
                       [body](const Turner& turner) { return turner.body == body; });
}

void FreeFields::append(const ConstrainedMinimiser::Targets& asked,
                        const ConstrainedMinimiser::Solution& answer)
{
    if (responses_ == nullptr)
        return;
    const ReducedEnergy energy = responses_->energy(asked, answer);
    stiffness_ = energy.stiffness;
    slopes_.conservativeResize(Eigen::NoChange, slopes_.cols() + energy.slope.cols());
    slopes_.rightCols(energy.slope.cols()) = energy.slope;
}

ResponseFields FreeFields::fields(Eigen::Index rows, Eigen::Index further) const
{
    return responses_ == nullptr ? ResponseFields(rows, further) : *responses_->fields();
}

// Exact where it matters: below the angle at which features begin to be held, a bound will do.
std::vector<double> FreeFields::farthest(const std::vector<Vector3>& logs) const
{
    std::vector<double> bounds(at(spread_.rows()), 0.0);
    for (Eigen::Index k = 0; k < spread_.rows(); ++k)
        for (std::size_t s = 0; s < logs.size(); ++s)
            bounds[at(k)] += spread_(k, static_cast<Eigen::Index>(s)) * logs[s].norm();
    if (logs.size() == 1 || *std::max_element(bounds.begin(), bounds.end()) < 0.6)
        return bounds;
    Points field = Points::Zero(weights_.rows(), 3);
    for (std::size_t s = 0; s < logs.size(); ++s)
        field += weights_.col(static_cast<Eigen::Index>(s)) * logs[s].transpose();
    return farthest_turns(*responses_, field);
}

std::optional<Eigen::MatrixXd> FreeFields::turn(const Pose& pose, const Eigen::MatrixXd& fields,
                                                BodyMotions& bodies,
                                                std::vector<BodyState>& states) const
{
    if (responses_ == nullptr)
        return Eigen::MatrixXd(0, 3);
    const std::vector<Turner>& turners = responses_->turners();
    ReducedEnergy energy{stiffness_, slopes_ * fields};
    Joints joints(pose.part, pose.targets, turners, bodies);
    hold_far_turned(*responses_, farthest(pose.logs), joints, energy);
    if (!minimise(joints, {pose.part, *responses_, energy}, live_precision).is_converged)
        return std::nullopt;
    states = joints.states();
    for (std::size_t k = 0; k < turners.size(); ++k)
    {
        RigidMotion& motion = bodies.motions[at(turners[k].body)];
        motion =
            motion_of(pose.part.roles.bodies[at(turners[k].body)], states[k], motion.rotation_log);
    }
    return entries_of(joints, pose.part, *responses_);
}

void FreeFields::blend(const std::vector<BodyState>& states, Points& logs) const
{
    if (responses_ != nullptr)
        blend_logs(*responses_, states, logs);
}

}  // namespace sheetmorph
