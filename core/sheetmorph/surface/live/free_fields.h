// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/solve/feature_responses.h"

namespace sheetmorph
{

//! Free features on the basis of a response (mathematics.md, section 4): the slope of their energy
//! is linear in the numbers of the fields, so a pose needs Newton's method on their rotations
//! alone, and is exactly the minimum. Without free features it is empty.
class FreeFields
{
public:
    //! \param responses  nothing if the energy turns nothing
    //! \param weights    (n, s) of the turning handles
    FreeFields(const FeatureResponses* responses, const Eigen::MatrixXd& weights);

    //! Only bodies that turn freely, none bound to a motion, a link or a handle's place.
    static bool is_possible(const PlacementInput& part, const FeatureResponses* responses);

    //! Columns of theirs: three a feature.
    Eigen::Index count() const { return stiffness_.rows(); }

    //! What of the sheet's turn at a vertex is left to the field.
    double left(int vertex) const { return responses_ == nullptr ? 1.0 : left_(vertex); }

    //! Whether a body is one of them: then no field turns it.
    bool turns(int body) const;

    //! Takes in the next fields of the basis: what they asked for, and the answer.
    void append(const ConstrainedMinimiser::Targets& asked,
                const ConstrainedMinimiser::Solution& answer);

    //! Fields that begin with their own columns; `further` will come.
    ResponseFields fields(Eigen::Index rows, Eigen::Index further) const;

    //! A pose whose fields are known.
    struct Pose
    {
        const PlacementInput& part;
        const SurfaceTargets& targets;
        const std::vector<Vector3>& logs;  //!< of the turning handles
    };

    //! Turns the bodies to the minimum of the energy, from where the field has them.
    //! \param fields  (k, 3) numbers of the fields
    //! \param states  filled: where the turners are
    //! \returns       (count, 3) numbers of their own columns; nothing if Newton's steps do not
    //! settle
    std::optional<Eigen::MatrixXd> turn(const Pose& pose, const Eigen::MatrixXd& fields,
                                        BodyMotions& bodies, std::vector<BodyState>& states) const;

    //! Changes the field's logs (n, 3) where the turners turn the sheet.
    void blend(const std::vector<BodyState>& states, Points& logs) const;

private:
    std::vector<double> farthest(const std::vector<Vector3>& logs) const;

    const FeatureResponses* responses_;
    const Eigen::MatrixXd& weights_;
    Eigen::VectorXd left_;
    Eigen::MatrixXd spread_;  // (turners, s) how far the weights differ around each turner
    Weights stiffness_;       // (count, count)
    Eigen::MatrixXd slopes_;  // (count, fields)
};

}  // namespace sheetmorph
