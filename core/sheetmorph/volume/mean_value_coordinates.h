// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"
#include "sheetmorph/numerics/products/dense_products.h"
#include "sheetmorph/volume/mean_value_kernel.h"

namespace sheetmorph::volume
{

//! Mean value coordinates (2.11) to (2.14) with respect to a closed control mesh of any shape. Rows
//! sum to 1. They reproduce affine maps of the control mesh to 1e-12 of its size within 10 sizes;
//! beyond, the error grows with the cube of the distance. They are finite everywhere: inside,
//! outside, on a triangle (its linear weights), on an edge, at a vertex, in the plane of a
//! triangle.
class MeanValueCoordinates
{
public:
    //! \param vertices   (m, 3) mm
    //! \param triangles  closed and consistently oriented, inwards or outwards
    //! \throws InvalidInput if an edge is not shared by two triangles in opposite directions
    MeanValueCoordinates(const Points& vertices, const Triangles& triangles);

    //! \param points  (n, 3) mm, finite
    //! \returns       (n, m)
    numerics::Weights weights(const Points& points) const;

private:
    void fill_block(const Points& points, Eigen::Index first, KernelBlock& block,
                    numerics::Weights& weights) const;
    struct Surface  // by lane: the triangle on which the point lies, or -1, and (2.14)
    {
        int triangle[lanes] = {-1, -1, -1, -1, -1, -1, -1, -1};
        Vector3 weights[lanes];
    };
    Surface add_grazed(KernelBlock& block) const;

    Points vertices_;
    double size_;
    KernelMesh mesh_;
};

}  // namespace sheetmorph::volume
