// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/rotations/rotation_batch.h"

#include "sheetmorph/base/angles.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/instructions/instructions.h"
#include "sheetmorph/base/log_near.h"

#include <algorithm>

#define HWY_TARGET_INCLUDE "sheetmorph/base/rotations/rotation_batch.cpp"
#include <hwy/foreach_target.h>

#include "sheetmorph/base/instructions/lane_angles.h"
#include "sheetmorph/base/rotations/lane_matrices.h"

HWY_BEFORE_NAMESPACE();
namespace sheetmorph
{
namespace HWY_NAMESPACE
{
namespace
{

struct Kernel : LaneAngles
{
    // From arithmetic: the number pi less the double nearest to it.
    static constexpr double pi_rest = 1.2246467991473531772e-16;
    static constexpr double tiny = 1e-280;  // from inverse_root(), which needs a larger value

    // Squared cosine of half the angle. The axis is divided by four times the cosine. From
    // rounding: a cosine of 0.1 costs less than one digit. Nearer to a half turn, log_near() is
    // more accurate.
    static constexpr double surely_told = 0.01;

    // Lanes beyond `count` repeat the first row.
    static HWY_INLINE Lanes3 loaded(const double* rows, int count)
    {
        const double* row[width];
        for (int lane = 0; lane < width; ++lane)
            row[lane] = rows + 3 * (lane < count ? lane : 0);
        return {gathered(row, 0), gathered(row, 1), gathered(row, 2)};
    }

    static HWY_INLINE Lanes rounded(Lanes value)
    {
        // 1.5 * 2^52: doubles of this size have no fraction, so the sum rounds.
        const Lanes shift = filled(6755399441055744.0);
        return (value + shift) - shift;
    }

    // sin(r) / r in z = r^2, |r| <= pi / 2.
    static HWY_INLINE Lanes sine_ratio(Lanes z)
    {
        return polynomial(z, {-1.0 / 25852016738884976640000.0, 1.0 / 51090942171709440000.0,
                              -1.0 / 121645100408832000.0, 1.0 / 355687428096000.0,
                              -1.0 / 1307674368000.0, 1.0 / 6227020800.0, -1.0 / 39916800.0,
                              1.0 / 362880.0, -1.0 / 5040.0, 1.0 / 120.0, -1.0 / 6.0, 1.0});
    }

    // cos(r), for the same argument.
    static HWY_INLINE Lanes cosine(Lanes z)
    {
        return polynomial(
            z, {1.0 / 620448401733239439360000.0, -1.0 / 1124000727777607680000.0,
                1.0 / 2432902008176640000.0, -1.0 / 6402373705728000.0, 1.0 / 20922789888000.0,
                -1.0 / 87178291200.0, 1.0 / 479001600.0, -1.0 / 3628800.0, 1.0 / 40320.0,
                -1.0 / 720.0, 1.0 / 24.0, -0.5, 1.0});
    }

    // R - 1 = 2 s^2 (v v^T - |v|^2) + 2 s c [v] with s = sin|v| / |v| and c = cos|v|. Subtracting
    // half turns from |v| changes the signs of both.
    static HWY_INLINE void turn(const Lanes3& v, double (&changes)[9][width])
    {
        const Lanes xx = v.x * v.x, yy = v.y * v.y, zz = v.z * v.z;
        const Lanes square = xx + yy + zz, inverse = inverse_root(square);
        const Lanes half = square * inverse, turns = rounded(half * filled(1.0 / pi));
        const Lanes rest =
            hn::NegMulAdd(turns, filled(pi_rest), hn::NegMulAdd(turns, filled(pi), half));
        const Lanes ratio = sine_ratio(rest * rest);
        const Lanes sine = hn::IfThenElse(turns == filled(0.0), ratio, rest * ratio * inverse);
        const Lanes twice = sine + sine, f = twice * sine, e = twice * cosine(rest * rest);
        const Lanes xy = f * v.x * v.y, xz = f * v.x * v.z, yz = f * v.y * v.z;
        const Lanes change[9] = {
            hn::Neg(f * (yy + zz)),    hn::MulAdd(e, v.z, xy),    hn::NegMulAdd(e, v.y, xz),
            hn::NegMulAdd(e, v.z, xy), hn::Neg(f * (xx + zz)),    hn::MulAdd(e, v.x, yz),
            hn::MulAdd(e, v.y, xz),    hn::NegMulAdd(e, v.x, yz), hn::Neg(f * (xx + yy))};
        for (int k = 0; k < 9; ++k)
            store(change[k], changes[k]);
    }

    static HWY_INLINE void turn(const Points& logs, Eigen::Index begin, Eigen::Index end,
                                Matrix3* changes)
    {
        for (Eigen::Index k = begin; k < end; k += width)
        {
            const int count = static_cast<int>(std::min<Eigen::Index>(width, end - k));
            double change[9][width];
            turn(loaded(logs.data() + 3 * k, count), change);
            for (int lane = 0; lane < count; ++lane)
                for (int i = 0; i < 9; ++i)
                    changes[k - begin + lane].data()[i] = change[i][lane];
        }
    }

    // \returns lanes with a valid log; log_near() computes the others
    static HWY_INLINE Mask tell(const LaneMatrices& rotations, const Lanes3& reference,
                                double (&logs)[3][width])
    {
        const auto& m = rotations.at;
        const Lanes squared_cosine = filled(0.25) * (filled(1.0) + m[0] + m[4] + m[8]);
        const Lanes inverse = inverse_root(squared_cosine), share = filled(0.25) * inverse;
        const Lanes3 axis = {share * (m[5] - m[7]), share * (m[6] - m[2]), share * (m[1] - m[3])};
        const Lanes squared_sine = dot(axis, axis), over_sine = inverse_root(squared_sine);
        const Lanes angle = half_angle(squared_sine * over_sine, squared_cosine * inverse);
        const Lanes half = angle + angle, along = over_sine * dot(axis, reference);
        const Lanes turns =
            hn::IfThenElseZero(half > filled(1e-12), rounded((along - half) * filled(1.0 / pi)));
        const Lanes narrow =
            hn::IfThenElse(squared_sine > filled(tiny), half * over_sine, filled(1.0));
        const Lanes ratio = hn::MulAdd(turns * filled(pi), over_sine, narrow);
        store(axis.x * ratio, logs[0]);
        store(axis.y * ratio, logs[1]);
        store(axis.z * ratio, logs[2]);
        return hn::And(squared_cosine > filled(surely_told),
                       dot(reference, reference) < filled(0.25 * pi * pi));
    }

    static HWY_INLINE void tell(const std::vector<Matrix3>& rotations, const Points& references,
                                NearLogs& found)
    {
        const auto count = static_cast<int>(rotations.size());
        for (int first = 0; first < count; first += width)
        {
            const int some = std::min(width, count - first);
            double is_told[width], logs[3][width];
            store(tell(LaneMatrices::loaded(rotations.data() + first, some),
                       loaded(references.data() + 3 * first, some), logs),
                  is_told);
            for (int lane = 0; lane < some; ++lane)
                if (is_told[lane] != 0.0)
                    found.logs.row(first + lane) << logs[0][lane], logs[1][lane], logs[2][lane];
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

void turn_widest(const Points& logs, Eigen::Index begin, Eigen::Index end, Matrix3* changes)
{
    Kernel::turn(logs, begin, end, changes);
}

void tell_widest(const std::vector<Matrix3>& rotations, const Points& references, NearLogs& found)
{
    Kernel::tell(rotations, references, found);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace sheetmorph
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheetmorph
{

HWY_EXPORT(turn_widest);
HWY_EXPORT(tell_widest);

void turns_from_logs(const Points& logs, Eigen::Index begin, Eigen::Index end, Matrix3* changes)
{
    SHEETMORPH_WIDEST(turn_widest)(logs, begin, end, changes);
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
    SHEETMORPH_WIDEST(tell_widest)(rotations, references, found);
    return found;
}

}  // namespace sheetmorph
#endif
