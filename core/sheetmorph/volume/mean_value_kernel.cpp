// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/mean_value_kernel.h"

#include "sheetmorph/base/instructions/instructions.h"

#define HWY_TARGET_INCLUDE "sheetmorph/volume/mean_value_kernel.cpp"
#include <hwy/foreach_target.h>

#include "sheetmorph/base/instructions/lane_angles.h"

HWY_BEFORE_NAMESPACE();
namespace sheetmorph::volume
{
namespace HWY_NAMESPACE
{
namespace
{

namespace hn = hwy::HWY_NAMESPACE;

// Elevation of the point above a triangle's plane; lower pairs go to grazed_triangle(), for about
// two in five points. From rounding: 2 to 3 eps / elevation of a weight. Measured: 1e-4 left errors
// of 1.06e-11 far from the mesh without fused multiply-add; the tests allow 1e-11.
constexpr double grazing = 3e-4;

// Sum of the weights over the sum of their magnitudes. From rounding: below it, hundreds of terms
// with errors of 1e-16 leave fewer than two digits. The largest sum is from the range of doubles.
constexpr double lost_digits = 1e-12;
constexpr double largest_sum = 1e300;

// The kernel for the lanes at .. at + width - 1 of a block.
struct Kernel : sheetmorph::HWY_NAMESPACE::LaneAngles
{
    const KernelMesh& mesh;
    KernelBlock& block;
    int at;

    HWY_INLINE Lanes load(const LaneValues& from) const
    {
        return hn::Load(Doubles(), from.at + at);
    }

    HWY_INLINE Lanes3 load(const LaneVectors& from, int k) const
    {
        return {load(from.x[k]), load(from.y[k]), load(from.z[k])};
    }

    HWY_INLINE void store(Lanes value, LaneValues& to) const
    {
        hn::Store(value, Doubles(), to.at + at);
    }

    HWY_INLINE void store(const Lanes3& value, LaneVectors& to, int k) const
    {
        store(value.x, to.x[k]);
        store(value.y, to.y[k]);
        store(value.z, to.z[k]);
    }

    // to += factor * value
    HWY_INLINE void add_product(Lanes factor, Lanes value, LaneValues& to) const
    {
        store(hn::MulAdd(factor, value, load(to)), to);
    }

    HWY_INLINE void directions_to_vertices() const
    {
        const Lanes3 point = load(block.points, 0);
        for (int v = 0; v < mesh.vertex_count(); ++v)
        {
            const double* q = &mesh.vertices[3 * v];
            const Lanes3 to = {filled(q[0]) - point.x, filled(q[1]) - point.y,
                               filled(q[2]) - point.z};
            const Lanes inverse = inverse_root(dot(to, to));
            store({to.x * inverse, to.y * inverse, to.z * inverse}, block.unit, v);
            store(inverse, block.inverse_distance[v]);
            store(filled(0.0), block.weights[v]);
        }
    }

    // u_i x u_j as u_i x (q_j - q_i) / d_j, so that distant points keep the digits of short edges.
    // Computed once per edge: both triangles of the edge then have the same rounding, which cancels
    // in the sum.
    HWY_INLINE void spherical_edges() const
    {
        for (int e = 0; e < mesh.edge_count(); ++e)
        {
            const int i = mesh.edge_ends[2 * e], j = mesh.edge_ends[2 * e + 1];
            const double* edge = &mesh.edge_vectors[3 * e];
            const Lanes3 v = {filled(edge[0]), filled(edge[1]), filled(edge[2])};
            const Lanes3 a = load(block.unit, i), b = load(block.unit, j);
            const Lanes inverse = load(block.inverse_distance[j]);
            const Lanes3 cross = {hn::MulSub(a.y, v.z, a.z * v.y) * inverse,
                                  hn::MulSub(a.z, v.x, a.x * v.z) * inverse,
                                  hn::MulSub(a.x, v.y, a.y * v.x) * inverse};
            const Lanes cosine = dot(a, b), half = filled(0.5);
            const Lanes t = hn::NegMulAdd(half, cosine, half);
            LaneValues& ratio = block.half_angle_ratio[e];
            store(cross, block.cross, e);
            if (HWY_UNLIKELY(any(t > filled(0.25))))
                store(wide_half_angle_ratio(dot(cross, cross), cosine), ratio);
            else
                store(narrow_half_angle_ratio(t), ratio);
        }
    }

    // w_k += (c_k . m) / (d_k c_k . u_k) with c_k = u_i x u_j and m = sum theta_k c_k / (2 |c_k|).
    // finish() divides by the distance d_k. The signs of the c_k matter only in m and between the
    // corners.
    HWY_INLINE void add_triangle(int t) const
    {
        const int* vertex = &mesh.triangle_vertices[3 * t];
        const int* edge = &mesh.triangle_edges[3 * t];
        const double* sign = &mesh.edge_signs[3 * t];
        const Lanes3 a = load(block.cross, edge[0]), b = load(block.cross, edge[1]);
        const Lanes3 c = load(block.cross, edge[2]);
        const Lanes3 ratio = {filled(sign[0]) * load(block.half_angle_ratio[edge[0]]),
                              filled(sign[1]) * load(block.half_angle_ratio[edge[1]]),
                              filled(sign[2]) * load(block.half_angle_ratio[edge[2]])};
        const Lanes3 m = {dot(ratio, {a.x, b.x, c.x}), dot(ratio, {a.y, b.y, c.y}),
                          dot(ratio, {a.z, b.z, c.z})};
        const Lanes volume = dot(a, load(block.unit, vertex[0]));
        const Lanes aa = dot(a, a), bb = dot(b, b), cc = dot(c, c);
        const Lanes least = filled(grazing * grazing) * dot({aa, bb, cc}, {bb, cc, aa});
        Lanes inverse = filled(1.0) / volume;
        const Mask is_clear = volume * volume > least;
        if (HWY_UNLIKELY(!hn::AllTrue(Doubles(), is_clear)))
        {
            inverse = hn::IfThenElseZero(is_clear, inverse);
            leave_out(t, is_clear);
        }
        add_product(dot(a, m), inverse, block.weights[vertex[0]]);
        add_product(dot(b, m), filled(sign[0] * sign[1]) * inverse, block.weights[vertex[1]]);
        add_product(dot(c, m), filled(sign[0] * sign[2]) * inverse, block.weights[vertex[2]]);
    }

    HWY_INLINE void leave_out(int triangle, Mask clear) const
    {
        double is_clear[width];
        LaneFunctions::store(clear, is_clear);
        for (int l = 0; l < width; ++l)
            if (is_clear[l] == 0.0)
                block.grazed.push_back({triangle, at + l});
    }

    HWY_INLINE void add_up() const
    {
        directions_to_vertices();
        spherical_edges();
        for (int t = 0; t < mesh.triangle_count(); ++t)
            add_triangle(t);
    }

    HWY_INLINE void finish() const
    {
        Lanes sum = filled(0.0), magnitude = sum;
        for (int v = 0; v < mesh.vertex_count(); ++v)
        {
            const Lanes weight = load(block.weights[v]) * load(block.inverse_distance[v]);
            store(weight, block.weights[v]);
            sum = sum + weight;
            magnitude = magnitude + hn::Abs(weight);
        }
        const Mask is_sound = hn::And(hn::Abs(sum) > filled(lost_digits) * magnitude,
                                      magnitude < filled(largest_sum));
        const Lanes inverse = filled(1.0) / sum, alike = filled(1.0 / mesh.vertex_count());
        const Lanes3 point = load(block.points, 0);
        Lanes3 rest = {point.x - filled(mesh.centre[0]), point.y - filled(mesh.centre[1]),
                       point.z - filled(mesh.centre[2])};
        for (int v = 0; v < mesh.vertex_count(); ++v)
        {
            const Lanes weight = hn::IfThenElse(is_sound, load(block.weights[v]) * inverse, alike);
            const double* arm = &mesh.arms[3 * v];
            store(weight, block.weights[v]);
            rest = {hn::NegMulAdd(filled(arm[0]), weight, rest.x),
                    hn::NegMulAdd(filled(arm[1]), weight, rest.y),
                    hn::NegMulAdd(filled(arm[2]), weight, rest.z)};
        }
        for (int v = 0; v < mesh.vertex_count(); ++v)
        {
            const double* share = &mesh.affine[3 * v];
            const Lanes3 shares = {filled(share[0]), filled(share[1]), filled(share[2])};
            store(load(block.weights[v]) + dot(shares, rest), block.weights[v]);
        }
    }
};

void add_up_widest(const KernelMesh& mesh, KernelBlock& block)
{
    for (int at = 0; at < lanes; at += Kernel::width)
        Kernel{{}, mesh, block, at}.add_up();
}

void finish_widest(const KernelMesh& mesh, KernelBlock& block)
{
    for (int at = 0; at < lanes; at += Kernel::width)
        Kernel{{}, mesh, block, at}.finish();
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace sheetmorph::volume
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheetmorph::volume
{

HWY_EXPORT(add_up_widest);
HWY_EXPORT(finish_widest);

void add_up(const KernelMesh& mesh, KernelBlock& block)
{
    block.grazed.clear();
    SHEETMORPH_WIDEST(add_up_widest)(mesh, block);
}

void finish(const KernelMesh& mesh, KernelBlock& block)
{
    SHEETMORPH_WIDEST(finish_widest)(mesh, block);
}

}  // namespace sheetmorph::volume
#endif
