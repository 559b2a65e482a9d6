// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_nodes.h"

#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoIndexedFaceSet.h>
#include <Inventor/nodes/SoNormal.h>

#include <Eigen/Geometry>
#include <stdexcept>
#include <string>

#include "node_at.h"

namespace sheetmorph::coin
{

namespace
{

Triangles checked(const Triangles& triangles, Eigen::Index vertex_count)
{
    if (triangles.size() > 0 && (triangles.minCoeff() < 0 || triangles.maxCoeff() >= vertex_count))
        throw std::invalid_argument("a triangle names a vertex that the mesh does not have");
    return triangles;
}

using FloatRows = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;

//! Writes (k, 3) values into a Coin field in one go.
class FieldRows
{
public:
    FieldRows(SoMFVec3f& field, Eigen::Index count) : field_(field)
    {
        if (field.getNum() != count)
            field.setNum(static_cast<int>(count));
        rows_ = reinterpret_cast<float*>(field.startEditing());
        count_ = count;
    }
    ~FieldRows() { field_.finishEditing(); }
    FieldRows(const FieldRows&) = delete;
    FieldRows& operator=(const FieldRows&) = delete;

    Eigen::Map<FloatRows> rows() const { return {rows_, count_, 3}; }

private:
    SoMFVec3f& field_;
    float* rows_ = nullptr;
    Eigen::Index count_ = 0;
};

}  // namespace

MeshNodes::MeshNodes(NodeAddresses nodes, const Points& points, const Triangles& triangles,
                     double crease)
    : triangles_(checked(triangles, points.rows())),
      shading_(corner_normals(points, triangles_, crease)),
      vertex_count_(points.rows()),
      coordinates_(node_at<SoCoordinate3>(nodes.coordinates)),
      normals_(node_at<SoNormal>(nodes.normals)),
      faces_(node_at<SoIndexedFaceSet>(nodes.faces))
{
    coordinates_->ref();
    normals_->ref();
    faces_->ref();
    show(points);
    set_faces();
}

MeshNodes::~MeshNodes()
{
    coordinates_->unref();
    normals_->unref();
    faces_->unref();
}

void MeshNodes::set_faces() const
{
    const auto corners = static_cast<int>(4 * triangles_.rows());
    faces_->coordIndex.setNum(corners);
    faces_->normalIndex.setNum(corners);
    auto* vertices = faces_->coordIndex.startEditing();
    auto* normals = faces_->normalIndex.startEditing();
    for (Eigen::Index t = 0; t < triangles_.rows(); ++t)
    {
        for (Eigen::Index k = 0; k < 3; ++k)
        {
            vertices[4 * t + k] = triangles_(t, k);
            normals[4 * t + k] = shading_.of_corner(t, k);
        }
        vertices[4 * t + 3] = -1;
        normals[4 * t + 3] = -1;
    }
    faces_->coordIndex.finishEditing();
    faces_->normalIndex.finishEditing();
}

void MeshNodes::show(const Points& points) const
{
    if (points.rows() != vertex_count_)
        throw std::invalid_argument("expected positions of " + std::to_string(vertex_count_)
                                    + " vertices, got " + std::to_string(points.rows()));
    // Differences in double: far from the origin float edges would be noise.
    Points sums = Points::Zero(shading_.count, 3);
    for (Eigen::Index t = 0; t < triangles_.rows(); ++t)
    {
        const Vector3 a = points.row(triangles_(t, 0));
        const Vector3 b = points.row(triangles_(t, 1));
        const Vector3 c = points.row(triangles_(t, 2));
        const Vector3 area = (b - a).cross(c - a);
        for (Eigen::Index k = 0; k < 3; ++k)
            sums.row(shading_.of_corner(t, k)) += area.transpose();
    }
    const FieldRows normals(normals_->vector, shading_.count);
    for (Eigen::Index k = 0; k < shading_.count; ++k)  // a zero sum stays zero
        normals.rows().row(k) = sums.row(k).normalized().cast<float>();
    const FieldRows coordinates(coordinates_->point, vertex_count_);
    coordinates.rows() = points.cast<float>();
}

}  // namespace sheetmorph::coin
