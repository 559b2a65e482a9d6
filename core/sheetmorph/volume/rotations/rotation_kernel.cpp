// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/rotations/rotation_kernel.h"

#include "sheetmorph/base/instructions/instructions.h"
#include "sheetmorph/base/log_near.h"

#include <algorithm>

#define HWY_TARGET_INCLUDE "sheetmorph/volume/rotations/rotation_kernel.cpp"
#include <hwy/foreach_target.h>

#include "sheetmorph/base/rotations/lane_matrices.h"

HWY_BEFORE_NAMESPACE();
namespace sheetmorph::volume
{
namespace HWY_NAMESPACE
{
namespace
{

namespace hn = hwy::HWY_NAMESPACE;

// Polar factors of `width` matrices at once. The results do not depend, to the bit, on the grouping
// of the matrices.
struct LaneRotations : sheetmorph::HWY_NAMESPACE::LaneFunctions
{
    // Matrices that need more steps, or are flatter, go to polar_rotation(), which takes over at
    // any value. Measured: a stretch by a factor of ten along one direction takes 8 steps.
    static constexpr int most_steps = 8;
    static constexpr double settled = 1e-18;  // from polar_rotation(): the square of its 1e-9
    // Squared determinant over the sixth power of the Frobenius norm; chosen five times rounder
    // than nearly_flat of polar_rotation().
    static constexpr double clearly_round = 1e-6;

    using Matrices = sheetmorph::HWY_NAMESPACE::LaneMatrices;

    // One step of Newton's method, (m + m^-T) / 2, for the lanes that have not converged.
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

    // Stores the polar factors of these lanes in `matrices`; the others do not change.
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

// Arguments of turn_rings().
struct RingWork
{
    const RingBatch& batch;
    const RingSpokes* spokes;
    const double* rest;
    const double* now;
};

struct Kernel : LaneRotations
{
    struct Vectors
    {
        Lanes at[3];
    };

    static HWY_INLINE Vectors gathered(const double* points, const int* rows)
    {
        const double* row[width];
        for (int lane = 0; lane < width; ++lane)
            row[lane] = points + 3 * static_cast<long>(rows[lane]);
        return {{LaneRotations::gathered(row, 0), LaneRotations::gathered(row, 1),
                 LaneRotations::gathered(row, 2)}};
    }

    static HWY_INLINE Lanes dot(const Vectors& a, const Vectors& b)
    {
        return LaneRotations::dot({a.at[0], a.at[1], a.at[2]}, {b.at[0], b.at[1], b.at[2]});
    }

    static HWY_INLINE Vectors between(const Vectors& from, const Vectors& to)
    {
        return {{to.at[0] - from.at[0], to.at[1] - from.at[1], to.at[2] - from.at[2]}};
    }

    static HWY_INLINE Vectors scaled(Lanes factor, const Vectors& v)
    {
        return {{factor * v.at[0], factor * v.at[1], factor * v.at[2]}};
    }

    // m v
    static HWY_INLINE Vectors turned(const Matrices& m, const Vectors& v)
    {
        return {{dot({m.at[0], m.at[3], m.at[6]}, v), dot({m.at[1], m.at[4], m.at[7]}, v),
                 dot({m.at[2], m.at[5], m.at[8]}, v)}};
    }

    // to += a b^T
    static HWY_INLINE void add_outer(const Vectors& a, const Vectors& b, Matrices& to)
    {
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row)
                to.at[3 * column + row] =
                    hn::MulAdd(a.at[row], b.at[column], to.at[3 * column + row]);
    }

    static HWY_INLINE Lanes factors(const signed char* numbers)
    {
        const hn::Rebind<std::int8_t, Doubles> bytes;
        const hn::Rebind<std::int32_t, Doubles> integers;
        return hn::PromoteTo(Doubles(), hn::PromoteTo(integers, hn::LoadU(bytes, numbers)));
    }

    // The difference between the rings and their references' rotations, for edges and normals.
    static HWY_INLINE Mask unexplained(const RingWork& work, int begin, const Matrices& reference,
                                       Matrices& sum)
    {
        const RingBatch& batch = work.batch;
        const Vectors own_rest = gathered(work.rest, batch.vertex + begin);
        const Vectors own_now = gathered(work.now, batch.vertex + begin);
        Lanes left_over = filled(0.0);
        Vectors area = {{left_over, left_over, left_over}}, before = area;
        for (int k = 0; k < batch.count; ++k)
        {
            const RingSpokes& spoke = work.spokes[k];
            const Vectors rest = between(own_rest, gathered(work.rest, spoke.other + begin));
            const Vectors now = between(own_now, gathered(work.now, spoke.other + begin));
            const Lanes triangles = factors(spoke.triangles + begin);
            const Vectors left = scaled(triangles, between(turned(reference, rest), now));
            left_over = left_over + dot(left, left);
            add_outer(left, rest, sum);
            const Lanes is_next = factors(spoke.is_next + begin);
            for (int axis = 0; axis < 3; ++axis)
            {
                const int y = (axis + 1) % 3, z = (axis + 2) % 3;
                const Lanes cross = hn::MulSub(before.at[y], now.at[z], before.at[z] * now.at[y]);
                area.at[axis] = hn::MulAdd(is_next, cross, area.at[axis]);
            }
            before = now;
        }
        const Vectors normal = {{load(batch.normal[0] + begin), load(batch.normal[1] + begin),
                                 load(batch.normal[2] + begin)}};
        add_outer(left_of_normal(batch, begin, turned(reference, normal), area), normal, sum);
        return left_over > filled(0.0);
    }

    // The difference for the normal, times its weight.
    static HWY_INLINE Vectors left_of_normal(const RingBatch& batch, int begin,
                                             const Vectors& explained, const Vectors& area)
    {
        const Lanes squares = dot(area, area), length = inverse_root(squares);
        const Lanes weight =
            hn::IfThenElseZero(squares > filled(1e-280), load(batch.normal_weight + begin));
        return scaled(weight, between(explained, scaled(length, area)));
    }

    // to += a times the symmetric inverse
    static HWY_INLINE Mask add_product(const RingBatch& batch, int begin, const Matrices& a,
                                       Matrices& to)
    {
        Lanes inverse[6];
        for (int k = 0; k < 6; ++k)
            inverse[k] = load(batch.inverse[k] + begin);
        constexpr int at[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row)
                for (int k = 0; k < 3; ++k)
                    to.at[3 * column + row] = hn::MulAdd(a.at[3 * k + row], inverse[at[k][column]],
                                                         to.at[3 * column + row]);
        return inverse[0] + inverse[1] + inverse[2] > filled(0.0);
    }
};

void turn_widest(const RingBatch& batch, const std::vector<RingSpokes>& spokes,
                 const RingPoints& points, Matrix3* references)
{
    const RingWork work{batch, spokes.data() + batch.first, points.rest.data(), points.now.data()};
    for (int begin = 0; begin < batch.rings; begin += Kernel::width)
    {
        const int count = std::min(Kernel::width, batch.rings - begin);
        auto map = Kernel::Matrices::loaded(references + begin, count);
        Kernel::Matrices sum;
        for (Kernel::Lanes& entry : sum.at)
            entry = Kernel::filled(0.0);
        const auto is_open = Kernel::unexplained(work, begin, map, sum);
        const auto is_turned = hn::And(is_open, Kernel::add_product(batch, begin, sum, map));
        Kernel::store_polar(map, is_turned, references + begin, count);
    }
}

void rotate_widest(std::vector<Matrix3>& matrices)
{
    const int size = static_cast<int>(matrices.size());
    for (int k = 0; k < size; k += Kernel::width)
    {
        const int count = std::min(Kernel::width, size - k);
        const auto given = Kernel::Matrices::loaded(matrices.data() + k, count);
        const auto all = hn::FirstN(Kernel::Doubles(), static_cast<std::size_t>(count));
        Kernel::store_polar(given, all, matrices.data() + k, count);
    }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace sheetmorph::volume
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheetmorph::volume
{

HWY_EXPORT(turn_widest);
HWY_EXPORT(rotate_widest);

void turn_rings(const RingBatch& batch, const std::vector<RingSpokes>& spokes,
                const RingPoints& points, Matrix3* references)
{
    SHEETMORPH_WIDEST(turn_widest)(batch, spokes, points, references);
}

void make_rotations(std::vector<Matrix3>& matrices)
{
    SHEETMORPH_WIDEST(rotate_widest)(matrices);
}

}  // namespace sheetmorph::volume
#endif
