// SPDX-License-Identifier: LGPL-2.1-or-later
// Included once for each instruction set, as Highway's own headers are.
#if defined(SHEETMORPH_LANE_ROTATIONS) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEETMORPH_LANE_ROTATIONS
#undef SHEETMORPH_LANE_ROTATIONS
#else
#define SHEETMORPH_LANE_ROTATIONS
#endif

#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotations/lane_matrices.h"

HWY_BEFORE_NAMESPACE();
namespace sheetmorph::volume
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

//! Polar factors of `width` matrices at once. Which ones stand beside each other decides nothing,
//! to the bit.
struct LaneRotations : sheetmorph::HWY_NAMESPACE::LaneFunctions
{
    // As in polar_rotation(): what is not so soon found, or so flat, is left to it.
    static constexpr int most_steps = 8;
    static constexpr double settled = 1e-18;       // the square of a change
    static constexpr double clearly_round = 1e-6;  // squared determinant in that of the size

    using Matrices = sheetmorph::HWY_NAMESPACE::LaneMatrices;

    // One step of Newton's method, (m + m^-T) / 2, where it is not settled yet.
    static HWY_INLINE void step(Matrices& m, Mask& is_open, Mask& is_lost)
    {
        Matrices cofactors;
        Lanes size = filled(0.0);
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row)
            {
                const int c1 = (column + 1) % 3, c2 = (column + 2) % 3;
                const int r1 = (row + 1) % 3, r2 = (row + 2) % 3;
                cofactors.at[3 * column + row] = hn::MulSub(m.at[3 * c1 + r1], m.at[3 * c2 + r2],
                                                            m.at[3 * c1 + r2] * m.at[3 * c2 + r1]);
                size = hn::MulAdd(m.at[3 * column + row], m.at[3 * column + row], size);
            }
        const Lanes determinant =
            dot({m.at[0], m.at[1], m.at[2]}, {cofactors.at[0], cofactors.at[1], cofactors.at[2]});
        const Mask is_round =
            hn::And(determinant > filled(0.0),
                    determinant * determinant > filled(clearly_round) * size * size * size);
        is_lost = hn::Or(is_lost, hn::AndNot(is_round, is_open));
        const Lanes half = filled(0.5), share = half / determinant;
        Lanes change = filled(0.0);
        for (int k = 0; k < 9; ++k)
        {
            const Lanes next = hn::MulAdd(share, cofactors.at[k], half * m.at[k]);
            const Lanes moved = next - m.at[k];
            change = hn::MulAdd(moved, moved, change);
            m.at[k] = hn::IfThenElse(is_open, next, m.at[k]);
        }
        is_open = hn::AndNot(hn::Or(is_lost, change < filled(settled)), is_open);
    }

    // The polar factors of those lanes of m go to `matrices`, the others stay as they are there.
    static HWY_INLINE void store_polar(const Matrices& given, Mask asked, Matrix3* matrices,
                                       int count)
    {
        Matrices m = given;
        Mask open = asked, lost = hn::Xor(asked, asked);
        for (int k = 0; k < most_steps && any(open); ++k)
            step(m, open, lost);
        lost = hn::Or(lost, open);
        for (int k = 0; k < 9; ++k)
            m.at[k] = hn::IfThenElse(lost, given.at[k], m.at[k]);
        double is_asked[width], is_lost[width], numbers[9][width];
        store(asked, is_asked);
        store(lost, is_lost);
        m.store(numbers);
        for (int lane = 0; lane < count; ++lane)
        {
            for (int k = 0; k < 9 && is_asked[lane] != 0.0; ++k)
                matrices[lane].data()[k] = numbers[k][lane];
            if (is_lost[lane] != 0.0)
                matrices[lane] = polar_rotation(matrices[lane]);
        }
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace sheetmorph::volume
HWY_AFTER_NAMESPACE();

#endif
