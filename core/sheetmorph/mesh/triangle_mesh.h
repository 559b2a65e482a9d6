// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::mesh
{

//! A mesh at rest: arbitrary triangles over arbitrary points. It need not be manifold.
class TriangleMesh
{
public:
    TriangleMesh() = default;

    //! \param points     (n, 3) mm
    //! \param triangles  (m, 3) rows of `points`
    //! \throws InvalidInput naming the rows: a point not finite or too far away, an index out of
    //!                      range
    TriangleMesh(Points points, Triangles triangles);

    const Points& points() const { return points_; }
    const Triangles& triangles() const { return triangles_; }
    int vertex_count() const { return static_cast<int>(points_.rows()); }
    int triangle_count() const { return static_cast<int>(triangles_.rows()); }

    //! Diagonal of the bounding box, mm.
    double size() const;

    //! Whether all points and triangles are equal.
    bool operator==(const TriangleMesh& other) const
    {
        return points_.rows() == other.points_.rows()
               && triangles_.rows() == other.triangles_.rows() && points_ == other.points_
               && triangles_ == other.triangles_;
    }

private:
    Points points_;
    Triangles triangles_;
};

//! Tolerance up to which these points count as exact, mm: 1e-12 * size + 8 * eps * max|coordinate|.
double exactness(const Points& points, double size);

}  // namespace sheetmorph::mesh
