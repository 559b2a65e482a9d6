// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/mean_value_kernel.h"

#include "sheetmorph/base/instructions/lane_angles.h"
#include "sheetmorph/base/instructions/widest.h"

#include <cstring>

// Fused multiply-adds where the processor has them.
#pragma GCC optimize("fp-contract=fast")
// Everything that returns Lanes is inlined: nothing depends on the calling convention of vectors.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace sheetmorph::volume
{

namespace
{

// Elevation of the point above a triangle's plane below which rounding, 2 to 3 eps / elevation of a
// weight, would show; such pairs are left to grazed_triangle(), some two in five points have one.
constexpr double grazing = 3e-4;

// Sums of weights below this share of their magnitudes, or beyond this one, have no digit left.
constexpr double lost_digits = 1e-12;
constexpr double largest_sum = 1e300;

// The kernel for processors that compute `width` doubles at once, on lanes at .. at + width - 1.
template <int width>
struct Kernel : LaneAngles<width>
{
    using Lanes = typename VectorTypes<width>::Lanes;
    using Functions = LaneFunctions<width>;
    using Bits = typename Functions::Bits;
    using Functions::any;
    using Functions::filled;
    using Functions::inverse_root;
    using Functions::reciprocal;
    using LaneAngles<width>::narrow_half_angle_ratio;
    using LaneAngles<width>::wide_half_angle_ratio;

    struct Lanes3
    {
        Lanes x, y, z;
    };

    const KernelMesh& mesh;
    KernelBlock& block;
    int at;

    SHEETMORPH_INLINE Lanes load(const LaneValues& from) const
    {
        Lanes value;
        std::memcpy(&value, from.at + at, sizeof value);
        return value;
    }

    SHEETMORPH_INLINE Lanes3 load(const LaneVectors& from, int k) const
    {
        return {load(from.x[k]), load(from.y[k]), load(from.z[k])};
    }

    SHEETMORPH_INLINE void store(const Lanes& value, LaneValues& to) const
    {
        std::memcpy(to.at + at, &value, sizeof value);
    }

    SHEETMORPH_INLINE void store(const Lanes3& value, LaneVectors& to, int k) const
    {
        store(value.x, to.x[k]);
        store(value.y, to.y[k]);
        store(value.z, to.z[k]);
    }

    SHEETMORPH_INLINE void add(const Lanes& value, LaneValues& to) const
    {
        store(load(to) + value, to);
    }

    static SHEETMORPH_INLINE Lanes dot(const Lanes3& a, const Lanes3& b)
    {
        return a.x * b.x + a.y * b.y + a.z * b.z;
    }

    SHEETMORPH_INLINE void directions_to_vertices() const
    {
        const Lanes zero = {};
        const Lanes3 point = load(block.points, 0);
        for (int v = 0; v < mesh.vertex_count(); ++v)
        {
            const double* q = &mesh.vertices[3 * v];
            const Lanes3 to = {q[0] - point.x, q[1] - point.y, q[2] - point.z};
            const Lanes inverse = inverse_root(dot(to, to));
            store({to.x * inverse, to.y * inverse, to.z * inverse}, block.unit, v);
            store(inverse, block.inverse_distance[v]);
            store(zero, block.weights[v]);
        }
    }

    // u_i x u_j as u_i x (q_j - q_i) / d_j: far points keep the digits of short edges. Once an
    // edge, so that its two triangles see the same rounding and their shares of it cancel in the
    // sum.
    SHEETMORPH_INLINE void spherical_edges() const
    {
        for (int e = 0; e < mesh.edge_count(); ++e)
        {
            const int i = mesh.edge_ends[2 * e], j = mesh.edge_ends[2 * e + 1];
            const double* v = &mesh.edge_vectors[3 * e];
            const Lanes3 a = load(block.unit, i), b = load(block.unit, j);
            const Lanes inverse = load(block.inverse_distance[j]);
            const Lanes3 cross = {(a.y * v[2] - a.z * v[1]) * inverse,
                                  (a.z * v[0] - a.x * v[2]) * inverse,
                                  (a.x * v[1] - a.y * v[0]) * inverse};
            const Lanes cosine = dot(a, b), t = 0.5 - 0.5 * cosine;
            LaneValues& ratio = block.half_angle_ratio[e];
            store(cross, block.cross, e);
            if (__builtin_expect(any(t > 0.25), 0))
                store(wide_half_angle_ratio(dot(cross, cross), cosine), ratio);
            else
                store(narrow_half_angle_ratio(t), ratio);
        }
    }

    // w_k += (c_k . m) / (d_k c_k . u_k) with c_k = u_i x u_j and m = sum theta_k c_k / (2 |c_k|);
    // the distance d_k comes last, in finish(). The signs of the c_k cancel but in m and between
    // the corners.
    SHEETMORPH_INLINE void add_triangle(int t) const
    {
        const int* vertex = &mesh.triangle_vertices[3 * t];
        const int* edge = &mesh.triangle_edges[3 * t];
        const double* sign = &mesh.edge_signs[3 * t];
        const Lanes3 a = load(block.cross, edge[0]), b = load(block.cross, edge[1]);
        const Lanes3 c = load(block.cross, edge[2]);
        const Lanes ra = sign[0] * load(block.half_angle_ratio[edge[0]]);
        const Lanes rb = sign[1] * load(block.half_angle_ratio[edge[1]]);
        const Lanes rc = sign[2] * load(block.half_angle_ratio[edge[2]]);
        const Lanes3 m = {ra * a.x + rb * b.x + rc * c.x, ra * a.y + rb * b.y + rc * c.y,
                          ra * a.z + rb * b.z + rc * c.z};
        const Lanes volume = dot(a, load(block.unit, vertex[0]));
        const Lanes aa = dot(a, a), bb = dot(b, b), cc = dot(c, c);
        const Lanes least = grazing * grazing * (aa * bb + bb * cc + cc * aa);
        const Lanes squared = volume * volume;
        Lanes inverse = reciprocal(volume);
        const auto is_clear = squared > least;
        if (__builtin_expect(any(Bits(~is_clear)), 0))
        {
            inverse = is_clear ? inverse : Lanes{};
            leave_out(t, is_clear ? filled(1.0) : Lanes{});
        }
        add(dot(a, m) * inverse, block.weights[vertex[0]]);
        add(dot(b, m) * (sign[0] * sign[1] * inverse), block.weights[vertex[1]]);
        add(dot(c, m) * (sign[0] * sign[2] * inverse), block.weights[vertex[2]]);
    }

    SHEETMORPH_INLINE void leave_out(int triangle, const Lanes& clear) const
    {
        double is_clear[width];
        std::memcpy(is_clear, &clear, sizeof clear);
        for (int l = 0; l < width; ++l)
            if (is_clear[l] == 0.0)
                block.grazed.push_back({triangle, at + l});
    }

    SHEETMORPH_INLINE void add_up() const
    {
        directions_to_vertices();
        spherical_edges();
        for (int t = 0; t < mesh.triangle_count(); ++t)
            add_triangle(t);
    }

    SHEETMORPH_INLINE void finish() const
    {
        const Lanes zero = {};
        Lanes sum = zero, magnitude = zero;
        for (int v = 0; v < mesh.vertex_count(); ++v)
        {
            const Lanes weight = load(block.weights[v]) * load(block.inverse_distance[v]);
            store(weight, block.weights[v]);
            sum += weight;
            magnitude += weight < 0.0 ? -weight : weight;
        }
        const Lanes clear = (sum < 0.0 ? -sum : sum) > lost_digits * magnitude ? filled(1.0) : zero;
        const auto is_sound = (magnitude < largest_sum ? clear : zero) > 0.0;
        const Lanes inverse = 1.0 / sum, alike = filled(1.0 / mesh.vertex_count());
        Lanes3 rest = load(block.points, 0);
        rest = {rest.x - mesh.centre[0], rest.y - mesh.centre[1], rest.z - mesh.centre[2]};
        for (int v = 0; v < mesh.vertex_count(); ++v)
        {
            const Lanes weight = is_sound ? load(block.weights[v]) * inverse : alike;
            const double* arm = &mesh.arms[3 * v];
            store(weight, block.weights[v]);
            rest = {rest.x - arm[0] * weight, rest.y - arm[1] * weight, rest.z - arm[2] * weight};
        }
        for (int v = 0; v < mesh.vertex_count(); ++v)
        {
            const double* share = &mesh.affine[3 * v];
            add(share[0] * rest.x + share[1] * rest.y + share[2] * rest.z, block.weights[v]);
        }
    }
};

}  // namespace

void add_up(const KernelMesh& mesh, KernelBlock& block)
{
    block.grazed.clear();
    run_widest(
        [&](auto width) SHEETMORPH_INLINED
        {
            for (int at = 0; at < lanes; at += width)
                Kernel<width>{{}, mesh, block, at}.add_up();
        });
}

void finish(const KernelMesh& mesh, KernelBlock& block)
{
    run_widest(
        [&](auto width) SHEETMORPH_INLINED
        {
            for (int at = 0; at < lanes; at += width)
                Kernel<width>{{}, mesh, block, at}.finish();
        });
}

}  // namespace sheetmorph::volume
