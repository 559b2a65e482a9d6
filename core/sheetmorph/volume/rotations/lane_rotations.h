// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/instructions/lane_functions.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotations/lane_matrices.h"

namespace sheetmorph::volume
{

//! Polar factors of `width` matrices at once. Which ones stand beside each other decides nothing,
//! to the bit.
template <int width>
struct LaneRotations : LaneFunctions<width>
{
    using Lanes = typename VectorTypes<width>::Lanes;
    using Bits = typename VectorTypes<width>::Bits;

    // As in polar_rotation(): what is not so soon found, or so flat, is left to it.
    static constexpr int most_steps = 8;
    static constexpr double settled = 1e-18;       // the square of a change
    static constexpr double clearly_round = 1e-6;  // squared determinant in that of the size

    using Matrices = LaneMatrices<width>;

    // One step of Newton's method, (m + m^-T) / 2, where it is not settled yet.
    static SHEETMORPH_INLINE void step(Matrices& m, Bits& is_open, Bits& is_lost)
    {
        Matrices cofactors;
        Lanes size = {};
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row)
            {
                const int c1 = (column + 1) % 3, c2 = (column + 2) % 3;
                const int r1 = (row + 1) % 3, r2 = (row + 2) % 3;
                cofactors.at[3 * column + row] =
                    m.at[3 * c1 + r1] * m.at[3 * c2 + r2] - m.at[3 * c1 + r2] * m.at[3 * c2 + r1];
                size += m.at[3 * column + row] * m.at[3 * column + row];
            }
        const Lanes determinant =
            m.at[0] * cofactors.at[0] + m.at[1] * cofactors.at[1] + m.at[2] * cofactors.at[2];
        const Bits is_round =
            (determinant > 0.0) & (determinant * determinant > clearly_round * size * size * size);
        is_lost |= is_open & ~is_round;
        const Lanes share = 0.5 / determinant;
        Lanes change = {};
        for (int k = 0; k < 9; ++k)
        {
            const Lanes next = 0.5 * m.at[k] + share * cofactors.at[k];
            change += (next - m.at[k]) * (next - m.at[k]);
            m.at[k] = is_open ? next : m.at[k];
        }
        is_open &= ~is_lost & ~(change < settled);
    }

    // The polar factors of those lanes of m go to `matrices`, the others stay as they are there.
    static SHEETMORPH_INLINE void store_polar(const Matrices& given, const Bits& is_asked,
                                              Matrix3* matrices, int count)
    {
        Matrices m = given;
        Bits is_lost = {}, is_open = is_asked;
        for (int k = 0; k < most_steps && LaneFunctions<width>::any(is_open); ++k)
            step(m, is_open, is_lost);
        is_lost |= is_open;
        for (int lane = 0; lane < count; ++lane)
        {
            const Matrices& from = is_lost[lane] ? given : m;
            for (int k = 0; k < 9 && is_asked[lane]; ++k)
                matrices[lane].data()[k] = from.at[k][lane];
            if (is_lost[lane])
                matrices[lane] = polar_rotation(matrices[lane]);
        }
    }
};

}  // namespace sheetmorph::volume
