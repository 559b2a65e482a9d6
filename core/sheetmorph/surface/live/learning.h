// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/surface/live/pose_numbers.h"

namespace sheetmorph::surface
{

//! (e, 3 p): the reduced inputs of every pose, one column per coordinate.
Eigen::MatrixXd learnt_columns(const PoseNumbers& numbers, const std::vector<KnownPose>& poses);

//! Snapshots: displacement fields for single coordinates of the training poses, with unrotated
//! bodies where the energy determines their rotation.
class LearntFields
{
public:
    //! \param numbers  with the full field
    LearntFields(const PreparedSurface& part, const PoseNumbers& numbers,
                 const std::vector<KnownPose>& poses)
        : part_(part), numbers_(numbers), poses_(poses)
    {
    }

    //! Computes displacement fields.
    //! \param columns  indices into learnt_columns()
    //! \param slopes   filled, (c, k): slopes of the reduced energy; without rows if no body
    //!                 rotates
    //! \returns        (n, k) displacements, mm
    //! \throws Cancelled on request of `progress`
    Eigen::MatrixXd solve(const std::vector<Eigen::Index>& columns, Eigen::MatrixXd& slopes,
                          const Progress& progress) const;

private:
    struct Asked
    {
        Eigen::Index column;  // of the result
        std::size_t pose;
        Eigen::Index coordinate;
    };
    std::vector<Asked> in_order(const std::vector<Eigen::Index>& columns) const;
    struct Field
    {
        Points logs, tilts;  // (n, 3)
    };
    Field field(const KnownPose& pose) const;
    std::vector<Matrix3> turns(const Field& field) const;
    Eigen::MatrixXd offset(const KnownPose& pose, const Field& field) const;
    void ask(const std::vector<Asked>& asked, std::size_t first,
             numerics::ConstrainedMinimiser::Targets& targets) const;

    const PreparedSurface& part_;
    const PoseNumbers& numbers_;
    const std::vector<KnownPose>& poses_;
};

}  // namespace sheetmorph::surface
