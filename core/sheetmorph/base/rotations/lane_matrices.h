// SPDX-License-Identifier: LGPL-2.1-or-later
// Included once for each instruction set, as Highway's own headers are.
#if defined(SHEETMORPH_LANE_MATRICES) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEETMORPH_LANE_MATRICES
#undef SHEETMORPH_LANE_MATRICES
#else
#define SHEETMORPH_LANE_MATRICES
#endif

#include "sheetmorph/base/instructions/lanes.h"
#include "sheetmorph/base/types.h"

HWY_BEFORE_NAMESPACE();
namespace sheetmorph
{
namespace HWY_NAMESPACE
{

//! `width` matrices side by side.
struct LaneMatrices : LaneFunctions
{
    // An implicit constructor would not be compiled for the instruction set.
    HWY_INLINE LaneMatrices() {}

    //! Lanes beyond `count` repeat the first matrix.
    static HWY_INLINE LaneMatrices loaded(const Matrix3* matrices, int count)
    {
        const double* rows[width];
        for (int lane = 0; lane < width; ++lane)
            rows[lane] = matrices[lane < count ? lane : 0].data();
        LaneMatrices m;
        for (int k = 0; k < 9; ++k)
            m.at[k] = gathered(rows, k);
        return m;
    }

    HWY_INLINE void store(double (&numbers)[9][width]) const
    {
        for (int k = 0; k < 9; ++k)
            LaneFunctions::store(at[k], numbers[k]);
    }

    Lanes at[9];  //!< column by column
};

}  // namespace HWY_NAMESPACE
}  // namespace sheetmorph
HWY_AFTER_NAMESPACE();

#endif
