// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"
#include "sheetmorph/volume/oriented_box.h"

#include <Eigen/SparseCore>

#include <memory>

namespace sheetmorph::volume
{

//! The shape of which every control mesh is an affine image: a cube after Catmull-Clark subdivision
//! and constrained smoothing (3.1), in the cube's own frame. It is closed, oriented outwards and
//! encloses the cube [-1, 1]^3, whose corners are its vertices 0 to 7. It has all symmetries of the
//! cube. Copies share their arrays.
class ControlShape
{
public:
    //! \param levels  1 to 5 subdivisions; 3 gives 386 vertices and 768 triangles
    //! \throws InvalidInput for other levels
    explicit ControlShape(int levels = 3);

    //! The same, computed once and shared.
    static const ControlShape& shared(int levels);

    const Points& vertices() const { return arrays_->vertices; }
    const Triangles& triangles() const { return arrays_->triangles; }
    int vertex_count() const { return static_cast<int>(vertices().rows()); }

    //! (m, m) uniform Laplacian on the subdivided quads: q_i minus the mean of its neighbours; no
    //! unit.
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
    Points vertices;  //!< (m, 3) mm, in the order of the shape
};

}  // namespace sheetmorph::volume
