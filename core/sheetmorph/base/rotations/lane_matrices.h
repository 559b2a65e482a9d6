// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/instructions/lane_functions.h"
#include "sheetmorph/base/types.h"

namespace sheetmorph
{

//! `width` matrices side by side.
template <int width>
struct LaneMatrices
{
    using Lanes = typename VectorTypes<width>::Lanes;

    // Lanes beyond `count` are those of the first matrix.
    static SHEETMORPH_INLINE LaneMatrices loaded(const Matrix3* matrices, int count)
    {
        LaneMatrices m;
        for (int k = 0; k < 9; ++k)
            for (int lane = 0; lane < width; ++lane)
                m.at[k][lane] = matrices[lane < count ? lane : 0].data()[k];
        return m;
    }

    Lanes at[9];  // as they lie in memory: column by column
};

}  // namespace sheetmorph
