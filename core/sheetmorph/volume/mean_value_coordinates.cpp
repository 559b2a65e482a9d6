// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/mean_value_coordinates.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/volume/grazed_triangle.h"

#include <Eigen/QR>
#include <algorithm>

namespace sheetmorph::volume
{

namespace
{

// Relative to the size. From rounding: a distance from the surface is exact to a few 1e-16 of the
// size, so below this its sign, and the sign of the weights, is noise. The linear weights of the
// triangle equal the mean value weights there.
constexpr double surface_share = 1e-14;

}  // namespace

MeanValueCoordinates::MeanValueCoordinates(const Points& vertices, const Triangles& triangles)
    : vertices_(vertices), mesh_(kernel_mesh(vertices, triangles))
{
    if (triangles.rows() < 4)
        throw InvalidInput("a control mesh needs at least four triangles");
    const Eigen::RowVector3d centre = vertices_.colwise().mean();
    size_ = (vertices_.colwise().maxCoeff() - vertices_.colwise().minCoeff()).norm();
    const Eigen::Matrix<double, Eigen::Dynamic, 3> arms = vertices_.rowwise() - centre;
    const Matrix3 spread = arms.transpose() * arms;
    const Eigen::Matrix<double, Eigen::Dynamic, 3> affine =
        arms * spread.completeOrthogonalDecomposition().pseudoInverse();
    for (Eigen::Index v = 0; v < vertices_.rows(); ++v)
        for (int axis = 0; axis < 3; ++axis)
        {
            mesh_.centre[axis] = centre(axis);
            mesh_.arms.push_back(arms(v, axis));
            mesh_.affine.push_back(affine(v, axis));
        }
}

numerics::Weights MeanValueCoordinates::weights(const Points& points) const
{
    numerics::Weights weights(points.rows(), vertices_.rows());
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
                                      numerics::Weights& weights) const
{
    const Eigen::Index last = points.rows() - 1;
    for (int l = 0; l < lanes; ++l)
    {
        const Eigen::Index i = std::min(first + l, last);
        block.points.x[0].at[l] = points(i, 0);
        block.points.y[0].at[l] = points(i, 1);
        block.points.z[0].at[l] = points(i, 2);
    }
    add_up(mesh_, block);
    const Surface surface = add_grazed(block);
    finish(mesh_, block);
    const auto count = static_cast<int>(std::min<Eigen::Index>(lanes, last - first + 1));
    for (int l = 0; l < count; ++l)
        for (Eigen::Index v = 0; v < weights.cols(); ++v)
            weights(first + l, v) = block.weights[static_cast<std::size_t>(v)].at[l];
    for (int l = 0; l < count; ++l)
        if (surface.triangle[l] >= 0)
        {
            const int* vertex = &mesh_.triangle_vertices[3 * surface.triangle[l]];
            weights.row(first + l).setZero();
            for (int k = 0; k < 3; ++k)
                weights(first + l, vertex[k]) += surface.weights[l](k);
        }
}

MeanValueCoordinates::Surface MeanValueCoordinates::add_grazed(KernelBlock& block) const
{
    Surface surface;
    for (const auto& [triangle, lane] : block.grazed)
    {
        if (surface.triangle[lane] >= 0)
            continue;
        const int* vertex = &mesh_.triangle_vertices[3 * triangle];
        const Vector3 point(block.points.x[0].at[lane], block.points.y[0].at[lane],
                            block.points.z[0].at[lane]);
        Matrix3 corners;
        corners << vertices_.row(vertex[0]), vertices_.row(vertex[1]), vertices_.row(vertex[2]);
        const GrazedTriangle share = grazed_triangle(corners, point, surface_share * size_);
        if (share.on_surface)
        {
            surface.triangle[lane] = triangle;
            surface.weights[lane] = share.weights;
            continue;
        }
        for (int k = 0; k < 3; ++k)
            block.weights[vertex[k]].at[lane] +=
                share.weights(k) / block.inverse_distance[vertex[k]].at[lane];
    }
    return surface;
}

}  // namespace sheetmorph::volume
