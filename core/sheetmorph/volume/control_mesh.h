// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"
#include "sheetmorph/volume/oriented_box.h"

#include <Eigen/SparseCore>

#include <memory>

namespace sheetmorph::volume
{

//! The one shape of which every control mesh is an affine image: a cube after Catmull-Clark
//! subdivision and constrained smoothing (3.1), in the cube's own frame.
//! Closed, oriented outwards, encloses the cube [-1, 1]^3 and has its corners as vertices 0 to 7;
//! symmetric under every turn and mirror image of the cube. Copies share their arrays.
class ControlShape
{
public:
    //! \param levels  1 to 5 subdivisions; 3 gives 386 vertices and 768 triangles
    //! \throws InvalidInput for other levels
    explicit ControlShape(int levels = 3);

    //! The same, made once for all who ask.
    static const ControlShape& shared(int levels);

    const Points& vertices() const { return arrays_->vertices; }
    const Triangles& triangles() const { return arrays_->triangles; }
    int vertex_count() const { return static_cast<int>(vertices().rows()); }

    //! (m, m) uniform Laplacian on the subdivided quads: q_i - mean of its neighbours; no unit.
    const Eigen::SparseMatrix<double>& laplacian() const { return arrays_->laplacian; }

private:
    struct Arrays
    {
        Points vertices;
        Triangles triangles;
        Eigen::SparseMatrix<double> laplacian;
    };
    std::shared_ptr<const Arrays> arrays_;
};

//! A control mesh at rest: the shape in its box.
struct ControlMesh
{
    ControlMesh(const ControlShape& given_shape, const OrientedBox& given_box);

    ControlShape shape;
    OrientedBox box;
    Points vertices;  //!< (m, 3) mm, rows as the shape's
};

}  // namespace sheetmorph::volume
