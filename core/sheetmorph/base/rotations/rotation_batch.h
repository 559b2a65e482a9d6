// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph
{

//! Many rotations at once, each to rounding what rotation.h and log_near.h make of it alone. Which
//! ones stand beside each other decides nothing, to the bit.

//! rotation_from_log() of every row; exactly the identity for zeros.
//! \param logs  (k, 3) (2.6)
std::vector<Matrix3> rotations_from_logs(const Points& logs);

//! The same of some rows, less the identity.
//! \param changes  where that of row `begin` goes; one a row
void turns_from_logs(const Points& logs, Eigen::Index begin, Eigen::Index end, Matrix3* changes);

//! What logarithms tell of rotations, and what they cannot.
struct NearLogs
{
    Points logs;   //!< (k, 3) of log_near()
    Points tilts;  //!< (k, 3) of tilt_beyond(); no rows: nothing
};

//! \param references  (k, 3)
NearLogs logs_near(const std::vector<Matrix3>& rotations, const Points& references);

}  // namespace sheetmorph
