// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/surface/live/pose_numbers.h"

namespace sheetmorph::surface
{

//! (e, 3 p): the numbers of every pose, a column a coordinate.
Eigen::MatrixXd learnt_columns(const PoseNumbers& numbers, const std::vector<KnownPose>& poses);

//! How a part answers single coordinates of some poses, the bodies that the energy turns unturned.
class LearntFields
{
public:
    //! \param numbers  with the whole field
    LearntFields(const PreparedSurface& part, const PoseNumbers& numbers,
                 const std::vector<KnownPose>& poses)
        : part_(part), numbers_(numbers), poses_(poses)
    {
    }

    //! \param columns  of learnt_columns()
    //! \param slopes   filled, (c, k): of the energy of the turned bodies; no rows without any
    //! \returns        (n, k) displacements, in mm
    //! \throws Cancelled as `progress` asks
    Eigen::MatrixXd solve(const std::vector<Eigen::Index>& columns, Eigen::MatrixXd& slopes,
                          const Progress& progress) const;

private:
    struct Asked
    {
        Eigen::Index column;  // of the answer
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
