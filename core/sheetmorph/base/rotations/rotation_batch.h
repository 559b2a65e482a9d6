// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph
{

//! Functions of rotation.h and log_near.h for many rotations at once, with the same results up to
//! rounding. The results do not depend, to the bit, on the grouping of the rotations.

//! rotation_from_log() of every row; exactly the identity for zeros.
//! \param logs  (k, 3) (2.6)
std::vector<Matrix3> rotations_from_logs(const Points& logs);

//! rotation_from_log() minus the identity, for some rows.
//! \param changes  (end - begin) output
void turns_from_logs(const Points& logs, Eigen::Index begin, Eigen::Index end, Matrix3* changes);

//! Logarithms of rotations, and the parts that they miss.
struct NearLogs
{
    Points logs;   //!< (k, 3) of log_near()
    Points tilts;  //!< (k, 3) of tilt_beyond(); no rows if all are zero
};

//! \param references  (k, 3)
NearLogs logs_near(const std::vector<Matrix3>& rotations, const Points& references);

}  // namespace sheetmorph
