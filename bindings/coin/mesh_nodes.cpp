// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_nodes.h"

#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoIndexedFaceSet.h>
#include <Inventor/nodes/SoNormal.h>

#include <cmath>
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

//! Sums twice the areas of triangles as vectors, each at the normals of its corners.
//! Differences in double: far from the origin float edges would be noise.
void add_areas(const double* points, const Triangles& triangles, const Triangles& of_corner,
               float* sums)
{
    const int* const vertices = triangles.data();
    const int* const normals = of_corner.data();
    for (Eigen::Index corner = 0; corner < triangles.size(); corner += 3)
    {
        const double* const a = points + 3 * vertices[corner];
        const double* const b = points + 3 * vertices[corner + 1];
        const double* const c = points + 3 * vertices[corner + 2];
        const double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        const double v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        const auto x = static_cast<float>(u[1] * v[2] - u[2] * v[1]);
        const auto y = static_cast<float>(u[2] * v[0] - u[0] * v[2]);
        const auto z = static_cast<float>(u[0] * v[1] - u[1] * v[0]);
        for (Eigen::Index k = corner; k < corner + 3; ++k)
        {
            float* const sum = sums + 3 * normals[k];
            sum[0] += x;
            sum[1] += y;
            sum[2] += z;
        }
    }
}

//! Gives (count, 3) vectors length 1; what is zero stays zero.
void normalize(float* vectors, Eigen::Index count)
{
    for (Eigen::Index k = 0; k < 3 * count; k += 3)
    {
        float* const v = vectors + k;
        const float square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        const float scale = square > 0.0F ? 1.0F / std::sqrt(square) : 0.0F;
        v[0] *= scale;
        v[1] *= scale;
        v[2] *= scale;
    }
}

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

void MeshNodes::show(const Eigen::Ref<const Points>& points) const
{
    if (points.rows() != vertex_count_)
        throw std::invalid_argument("expected positions of " + std::to_string(vertex_count_)
                                    + " vertices, got " + std::to_string(points.rows()));
    const FieldRows coordinates(coordinates_->point, vertex_count_);
    coordinates.rows() = points.cast<float>();
    const FieldRows normals(normals_->vector, shading_.count);
    normals.rows().setZero();
    add_areas(points.data(), triangles_, shading_.of_corner, normals.rows().data());
    normalize(normals.rows().data(), shading_.count);
}

void MeshNodes::show(const Eigen::Ref<const Points>& points, const Placing& placing)
{
    if (placing.rotation.isIdentity(0.0) && placing.base.isZero(0.0))
        return show(points);
    local_.resize(points.rows(), 3);
    for (Eigen::Index k = 0; k < points.rows(); ++k)
        local_.row(k) = (points.row(k) - placing.base.transpose()) * placing.rotation;
    show(local_);
}

}  // namespace sheetmorph::coin
