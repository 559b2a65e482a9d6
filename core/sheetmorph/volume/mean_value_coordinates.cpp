// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/mean_value_coordinates.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/parallel.h"
#include "sheetmorph/volume/grazed_triangle.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace sheetmorph
{

namespace
{

// Nearer to the surface than this share of the size, the linear weights of the triangle are the
// mean value weights to rounding; and the sign of the distance, so that of the weights, is noise.
constexpr double surface_share = 1e-14;

// Below this ratio of the sum to the sum of magnitudes no digit is left; only points millions of
// sizes away, or on the zero set that a strongly non-convex mesh may have outside, come here.
constexpr double lost_digits = 1e-12;

}  // namespace

MeanValueCoordinates::MeanValueCoordinates(const Points& vertices, const Triangles& triangles)
    : vertices_(vertices), mesh_(kernel_mesh(vertices, triangles))
{
    if (triangles.rows() < 4)
        throw InvalidInput("a control mesh needs at least four triangles");
    centre_ = vertices_.colwise().mean();
    size_ = (vertices_.colwise().maxCoeff() - vertices_.colwise().minCoeff()).norm();
    arms_ = vertices_.rowwise() - centre_;
    const Matrix3 spread = arms_.transpose() * arms_;
    affine_ = arms_ * spread.completeOrthogonalDecomposition().pseudoInverse();
    for (Eigen::Index v = 0; v < vertices_.rows(); ++v)
        for (int axis = 0; axis < 3; ++axis)
        {
            mesh_.centre[axis] = centre_(axis);
            mesh_.arms.push_back(arms_(v, axis));
            mesh_.affine.push_back(affine_(v, axis));
        }
}

Weights MeanValueCoordinates::weights(const Points& points) const
{
    Weights weights(points.rows(), vertices_.rows());
    const Eigen::Index blocks = (points.rows() + lanes - 1) / lanes;
    parallel_ranges(blocks, 1,
                    [&](Eigen::Index begin, Eigen::Index end)
                    {
                        KernelBlock block(mesh_);
                        for (Eigen::Index b = begin; b < end; ++b)
                            fill_block(points, b * lanes, block, weights);
                    });
    return weights;
}

void MeanValueCoordinates::fill_block(const Points& points, Eigen::Index first, KernelBlock& block,
                                      Weights& weights) const
{
    const Eigen::Index last = points.rows() - 1;
    for (int l = 0; l < lanes; ++l)
    {
        const Eigen::Index i = std::min(first + l, last);
        block.points.x[0].at[l] = points(i, 0);
        block.points.y[0].at[l] = points(i, 1);
        block.points.z[0].at[l] = points(i, 2);
    }
    run_kernel(mesh_, block);
    const auto count = static_cast<int>(std::min<Eigen::Index>(lanes, last - first + 1));
    for (int l = 0; l < count; ++l)
        for (Eigen::Index v = 0; v < weights.cols(); ++v)
            weights(first + l, v) = block.weights[static_cast<std::size_t>(v)].at[l];
    for (int l = 0; l < count; ++l)
        if (block.finished.at[l] == 0.0)
            weights.row(first + l) = lane_weights(points.row(first + l).transpose(), l, block);
}

Eigen::VectorXd MeanValueCoordinates::lane_weights(const Vector3& point, int lane,
                                                   const KernelBlock& block) const
{
    Eigen::VectorXd weights(mesh_.vertex_count());
    for (int v = 0; v < mesh_.vertex_count(); ++v)
        weights(v) = block.weights[v].at[lane];
    for (int t = 0; block.flagged.at[lane] != 0.0 && t < mesh_.triangle_count(); ++t)
    {
        if (block.flags[t].at[lane] == 0.0)
            continue;
        const int* vertex = &mesh_.triangle_vertices[3 * t];
        Matrix3 corners;
        corners << vertices_.row(vertex[0]), vertices_.row(vertex[1]), vertices_.row(vertex[2]);
        const GrazedTriangle share = grazed_triangle(corners, point, surface_share * size_);
        if (share.on_surface)
            weights.setZero();
        for (int k = 0; k < 3; ++k)
            weights(vertex[k]) += share.weights(k);
        if (share.on_surface)
            return weights;
    }
    const double sum = weights.sum();
    if (std::isfinite(sum) && std::fabs(sum) > lost_digits * weights.cwiseAbs().sum())
        weights /= sum;
    else
        weights.setConstant(1.0 / static_cast<double>(weights.size()));
    // What rounding (or the constant) leaves of the affine precision, as the smallest correction.
    weights += affine_ * (point - centre_.transpose() - arms_.transpose() * weights);
    return weights;
}

}  // namespace sheetmorph
