// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/rotations/rotation_batch.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/instructions/lane_angles.h"
#include "sheetmorph/base/instructions/widest.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotations/lane_matrices.h"

#include <algorithm>

// Fused multiply-adds where the processor has them.
#pragma GCC optimize("fp-contract=fast")

namespace sheetmorph
{

namespace
{

template <int width>
struct Kernel : LaneAngles<width>
{
    using Lanes = typename VectorTypes<width>::Lanes;
    using Bits = typename VectorTypes<width>::Bits;
    using LaneFunctions<width>::filled;
    using LaneFunctions<width>::inverse_root;

    static constexpr double pi = 3.14159265358979323846;
    static constexpr double pi_rest = 1.2246467991473531772e-16;  // what pi leaves of it
    static constexpr double tiny = 1e-280;                        // inverse_root() asks for more

    // Squared cosine of half the angle: nearer to half a turn, log_near() tells the axis better.
    static constexpr double surely_told = 0.01;

    struct Vectors
    {
        Lanes x, y, z;
    };

    // Lanes beyond `count` are the first row again.
    static SHEETMORPH_INLINE Vectors loaded(const double* rows, int count)
    {
        Vectors found = {};
        for (int lane = 0; lane < width; ++lane)
        {
            const double* row = rows + 3 * (lane < count ? lane : 0);
            found.x[lane] = row[0];
            found.y[lane] = row[1];
            found.z[lane] = row[2];
        }
        return found;
    }

    static SHEETMORPH_INLINE Lanes rounded(const Lanes& value)
    {
        constexpr double shift = 6755399441055744.0;  // 1.5 * 2^52
        return (value + shift) - shift;
    }

    // sin(r) / r in z = r^2, |r| <= pi / 2.
    static SHEETMORPH_INLINE Lanes sine_ratio(const Lanes& z)
    {
        Lanes sum = filled(-1.0 / 25852016738884976640000.0);
        for (const double term :
             {1.0 / 51090942171709440000.0, -1.0 / 121645100408832000.0, 1.0 / 355687428096000.0,
              -1.0 / 1307674368000.0, 1.0 / 6227020800.0, -1.0 / 39916800.0, 1.0 / 362880.0,
              -1.0 / 5040.0, 1.0 / 120.0, -1.0 / 6.0, 1.0})
            sum = sum * z + term;
        return sum;
    }

    // cos(r), likewise.
    static SHEETMORPH_INLINE Lanes cosine(const Lanes& z)
    {
        Lanes sum = filled(1.0 / 620448401733239439360000.0);
        for (const double term : {-1.0 / 1124000727777607680000.0, 1.0 / 2432902008176640000.0,
                                  -1.0 / 6402373705728000.0, 1.0 / 20922789888000.0,
                                  -1.0 / 87178291200.0, 1.0 / 479001600.0, -1.0 / 3628800.0,
                                  1.0 / 40320.0, -1.0 / 720.0, 1.0 / 24.0, -0.5, 1.0})
            sum = sum * z + term;
        return sum;
    }

    // R - 1 = 2 s^2 (v v^T - |v|^2) + 2 s c [v], s = sin|v| / |v|, c = cos|v|: half turns off |v|
    // change the signs of both.
    static SHEETMORPH_INLINE void turn(const double* logs, int count, Matrix3* changes)
    {
        const Vectors v = loaded(logs, count);
        const Lanes xx = v.x * v.x, yy = v.y * v.y, zz = v.z * v.z;
        const Lanes square = xx + yy + zz, inverse = inverse_root(square);
        const Lanes half = square * inverse, turns = rounded(half * (1.0 / pi));
        const Lanes rest = (half - turns * pi) - turns * pi_rest;
        const Lanes ratio = sine_ratio(rest * rest);
        const Lanes sine = turns == 0.0 ? ratio : rest * ratio * inverse;
        const Lanes f = 2.0 * sine * sine, e = 2.0 * sine * cosine(rest * rest);
        const Lanes xy = f * v.x * v.y, xz = f * v.x * v.z, yz = f * v.y * v.z;
        const Lanes change[9] = {-f * (yy + zz), xy + e * v.z,   xz - e * v.y,
                                 xy - e * v.z,   -f * (xx + zz), yz + e * v.x,
                                 xz + e * v.y,   yz - e * v.x,   -f * (xx + yy)};
        for (int lane = 0; lane < count; ++lane)
            for (int k = 0; k < 9; ++k)
                changes[lane].data()[k] = change[k][lane];
    }

    static SHEETMORPH_INLINE void turn(const Points& logs, Eigen::Index begin, Eigen::Index end,
                                       Matrix3* changes)
    {
        for (Eigen::Index k = begin; k < end; k += width)
            turn(logs.data() + 3 * k, static_cast<int>(std::min<Eigen::Index>(width, end - k)),
                 changes + (k - begin));
    }

    // \returns lanes whose logs are told; the others are left to log_near()
    static SHEETMORPH_INLINE Bits tell(const Matrix3* rotations, const Vectors& reference,
                                       int count, Vectors& log)
    {
        const auto loaded_ones = LaneMatrices<width>::loaded(rotations, count);
        const auto& m = loaded_ones.at;
        const Lanes squared_cosine = 0.25 * (1.0 + m[0] + m[4] + m[8]);
        const Lanes inverse = inverse_root(squared_cosine), share = 0.25 * inverse;
        const Lanes x = share * (m[5] - m[7]), y = share * (m[6] - m[2]), z = share * (m[1] - m[3]);
        const Lanes squared_sine = x * x + y * y + z * z;
        const Lanes over_sine = inverse_root(squared_sine), none = {};
        const Lanes half =
            2.0 * LaneAngles<width>::half_angle(squared_sine * over_sine, squared_cosine * inverse);
        const Lanes along = over_sine * (x * reference.x + y * reference.y + z * reference.z);
        const Lanes turns = half > 1e-12 ? rounded((along - half) * (1.0 / pi)) : none;
        const Lanes ratio =
            (squared_sine > tiny ? half * over_sine : filled(1.0)) + turns * pi * over_sine;
        log = {x * ratio, y * ratio, z * ratio};
        const Lanes wound =
            reference.x * reference.x + reference.y * reference.y + reference.z * reference.z;
        return (squared_cosine > surely_told) & (wound < 0.25 * pi * pi);
    }

    static SHEETMORPH_INLINE void tell(const std::vector<Matrix3>& rotations,
                                       const Points& references, NearLogs& found)
    {
        const auto count = static_cast<int>(rotations.size());
        for (int first = 0; first < count; first += width)
        {
            const int some = std::min(width, count - first);
            Vectors log;
            const Bits is_told = tell(rotations.data() + first,
                                      loaded(references.data() + 3 * first, some), some, log);
            for (int lane = 0; lane < some; ++lane)
                if (is_told[lane])
                    found.logs.row(first + lane) << log.x[lane], log.y[lane], log.z[lane];
                else
                    tell_alone(rotations[at(first + lane)], references, first + lane, found);
        }
    }

    static void tell_alone(const Matrix3& rotation, const Points& references, Eigen::Index row,
                           NearLogs& found)
    {
        const Vector3 log = log_near(rotation, references.row(row).transpose());
        found.logs.row(row) = log.transpose();
        const Vector3 tilt = tilt_beyond(rotation, log);
        if (tilt.isZero(0.0))
            return;
        if (found.tilts.rows() == 0)
            found.tilts = Points::Zero(references.rows(), 3);
        found.tilts.row(row) = tilt.transpose();
    }
};

}  // namespace

void turns_from_logs(const Points& logs, Eigen::Index begin, Eigen::Index end, Matrix3* changes)
{
    run_widest([&](auto width) SHEETMORPH_INLINED
               { Kernel<width>::turn(logs, begin, end, changes); });
}

std::vector<Matrix3> rotations_from_logs(const Points& logs)
{
    std::vector<Matrix3> rotations(at(logs.rows()));
    turns_from_logs(logs, 0, logs.rows(), rotations.data());
    for (Matrix3& rotation : rotations)
        rotation.diagonal().array() += 1.0;
    return rotations;
}

NearLogs logs_near(const std::vector<Matrix3>& rotations, const Points& references)
{
    NearLogs found{Points(references.rows(), 3), Points(0, 3)};
    run_widest([&](auto width) SHEETMORPH_INLINED
               { Kernel<width>::tell(rotations, references, found); });
    return found;
}

}  // namespace sheetmorph
