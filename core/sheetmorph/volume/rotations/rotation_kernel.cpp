// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/rotations/rotation_kernel.h"

#include "sheetmorph/base/instructions/widest.h"
#include "sheetmorph/volume/rotations/lane_rotations.h"

#include <algorithm>

// Fused multiply-adds where the processor has them.
#pragma GCC optimize("fp-contract=fast")

namespace sheetmorph::volume
{

namespace
{

//! A call of turn_rings().
struct RingWork
{
    const RingBatch& batch;
    const RingSpokes* spokes;
    const double* rest;
    const double* now;
    Matrix3* references;
};

template <int width>
struct Kernel : LaneRotations<width>
{
    using Lanes = typename VectorTypes<width>::Lanes;
    using Bits = typename VectorTypes<width>::Bits;
    using Matrices = typename LaneRotations<width>::Matrices;

    struct Vectors
    {
        Lanes at[3];
    };

    static SHEETMORPH_INLINE Lanes load(const double* from)
    {
        Lanes value;
        std::memcpy(&value, from, sizeof value);
        return value;
    }

    static SHEETMORPH_INLINE Vectors gathered(const double* points, const int* rows)
    {
        Vectors found;
        for (int lane = 0; lane < width; ++lane)
            for (int axis = 0; axis < 3; ++axis)
                found.at[axis][lane] = points[3 * static_cast<long>(rows[lane]) + axis];
        return found;
    }

    static SHEETMORPH_INLINE Vectors between(const Vectors& from, const Vectors& to)
    {
        Vectors found;
        for (int axis = 0; axis < 3; ++axis)
            found.at[axis] = to.at[axis] - from.at[axis];
        return found;
    }

    // m v
    static SHEETMORPH_INLINE Vectors turned(const Matrices& m, const Vectors& v)
    {
        Vectors found;
        for (int row = 0; row < 3; ++row)
            found.at[row] = m.at[row] * v.at[0] + m.at[3 + row] * v.at[1] + m.at[6 + row] * v.at[2];
        return found;
    }

    // to += a b^T
    static SHEETMORPH_INLINE void add_outer(const Vectors& a, const Vectors& b, Matrices& to)
    {
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row)
                to.at[3 * column + row] += a.at[row] * b.at[column];
    }

    static SHEETMORPH_INLINE Lanes factors(const signed char* numbers)
    {
        Lanes found;
        for (int lane = 0; lane < width; ++lane)
            found[lane] = numbers[lane];
        return found;
    }

    // What the references leave unexplained of the rings' edges and normals.
    static SHEETMORPH_INLINE Bits unexplained(const RingWork& work, int begin,
                                              const Matrices& reference, Matrices& sum)
    {
        const RingBatch& batch = work.batch;
        const Vectors own_rest = gathered(work.rest, batch.vertex + begin);
        const Vectors own_now = gathered(work.now, batch.vertex + begin);
        Vectors area = {}, before = {};
        Lanes left_over = {};
        for (int k = 0; k < batch.count; ++k)
        {
            const RingSpokes& spoke = work.spokes[k];
            const Vectors rest = between(own_rest, gathered(work.rest, spoke.other + begin));
            const Vectors now = between(own_now, gathered(work.now, spoke.other + begin));
            const Vectors explained = turned(reference, rest);
            const Lanes triangles = factors(spoke.triangles + begin);
            Vectors left;
            for (int axis = 0; axis < 3; ++axis)
            {
                left.at[axis] = triangles * (now.at[axis] - explained.at[axis]);
                left_over += left.at[axis] * left.at[axis];
            }
            add_outer(left, rest, sum);
            const Lanes is_next = factors(spoke.is_next + begin);
            for (int axis = 0; axis < 3; ++axis)
            {
                const int y = (axis + 1) % 3, z = (axis + 2) % 3;
                area.at[axis] += is_next * (before.at[y] * now.at[z] - before.at[z] * now.at[y]);
            }
            before = now;
        }
        Vectors normal;
        for (int axis = 0; axis < 3; ++axis)
            normal.at[axis] = load(batch.normal[axis] + begin);
        add_outer(left_of_normal(batch, begin, turned(reference, normal), area), normal, sum);
        return left_over > 0.0;
    }

    // What is unexplained of the normal, times its weight.
    static SHEETMORPH_INLINE Vectors left_of_normal(const RingBatch& batch, int begin,
                                                    const Vectors& explained, const Vectors& area)
    {
        const Lanes squares =
            area.at[0] * area.at[0] + area.at[1] * area.at[1] + area.at[2] * area.at[2];
        const Lanes zero = {}, given = load(batch.normal_weight + begin);
        const Lanes weight = squares > 1e-280 ? given : zero;
        const Lanes length = LaneFunctions<width>::inverse_root(squares);
        Vectors left;
        for (int axis = 0; axis < 3; ++axis)
            left.at[axis] = weight * (area.at[axis] * length - explained.at[axis]);
        return left;
    }

    // to += a times the symmetric inverse
    static SHEETMORPH_INLINE Bits add_product(const RingBatch& batch, int begin, const Matrices& a,
                                              Matrices& to)
    {
        Lanes inverse[6];
        for (int k = 0; k < 6; ++k)
            inverse[k] = load(batch.inverse[k] + begin);
        constexpr int at[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row)
                for (int k = 0; k < 3; ++k)
                    to.at[3 * column + row] += a.at[3 * k + row] * inverse[at[k][column]];
        return inverse[0] + inverse[1] + inverse[2] > 0.0;
    }

    static SHEETMORPH_INLINE void turn(const RingWork& work)
    {
        for (int begin = 0; begin < work.batch.rings; begin += width)
        {
            const int count = std::min(width, work.batch.rings - begin);
            Matrices map = Matrices::loaded(work.references + begin, count), sum = {};
            Bits is_turned = unexplained(work, begin, map, sum);
            is_turned &= add_product(work.batch, begin, sum, map);
            LaneRotations<width>::store_polar(map, is_turned, work.references + begin, count);
        }
    }

    static SHEETMORPH_INLINE void rotate(Matrix3* matrices, int count)
    {
        const Bits none = {};
        LaneRotations<width>::store_polar(Matrices::loaded(matrices, count), ~none, matrices,
                                          count);
    }
};

}  // namespace

void turn_rings(const RingBatch& batch, const std::vector<RingSpokes>& spokes,
                const RingPoints& points, Matrix3* references)
{
    const RingWork work{batch, spokes.data() + batch.first, points.rest.data(), points.now.data(),
                        references};
    run_widest([&](auto width) SHEETMORPH_INLINED { Kernel<width>::turn(work); });
}

void make_rotations(std::vector<Matrix3>& matrices)
{
    const int count = static_cast<int>(matrices.size());
    run_widest(
        [&](auto width) SHEETMORPH_INLINED
        {
            for (int k = 0; k < count; k += width)
                Kernel<width>::rotate(matrices.data() + k, std::min<int>(width, count - k));
        });
}

}  // namespace sheetmorph::volume
