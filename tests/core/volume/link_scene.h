// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/volume/local_rotations.h"
#include "sheetmorph/volume/volume_link.h"
#include "shapes.h"

#include <Eigen/Geometry>
#include <numeric>

namespace sheetmorph::volume::scene
{

//! Two sheets one above the other, linked by one control mesh around both.
struct LinkedSheets
{
    mesh::TriangleMesh source, target;
    ControlMesh control;
    LocalRotationMeter meter;
    VolumeLink link;
};

inline VertexIds all_vertices(const mesh::TriangleMesh& mesh)
{
    VertexIds ids(mesh.vertex_count());
    std::iota(ids.begin(), ids.end(), 0);
    return ids;
}

inline Points vertex_normals(const mesh::TriangleMesh& mesh)
{
    Points normals = Points::Zero(mesh.vertex_count(), 3);
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        const Eigen::RowVector3i row = mesh.triangles().row(t);
        const Vector3 a = mesh.points().row(row(0)), b = mesh.points().row(row(1));
        const Vector3 c = mesh.points().row(row(2));
        for (int k = 0; k < 3; ++k)
            normals.row(row(k)) += (b - a).cross(c - a).transpose();
    }
    return normals.rowwise().normalized();
}

inline LinkedSheets linked(const mesh::TriangleMesh& source, const mesh::TriangleMesh& target,
                           const LinkOptions& options, const Matrix3& frame = Matrix3::Identity())
{
    Points both(source.vertex_count() + target.vertex_count(), 3);
    both << source.points(), target.points();
    const ControlMesh control(ControlShape(), oriented_box(both, principal_axes(both, {}, frame)));
    const LinkSource driving{source.points(), vertex_normals(source), {}};
    return {source, target, control, LocalRotationMeter(source, all_vertices(source)),
            VolumeLink(control, driving, target.points(), options)};
}

//! The source in one frame, its local rotations near the given logs.
inline SourceState state_of(const LinkedSheets& sheets, const Points& deformed,
                            const Points& references)
{
    const LocalRotations turned = sheets.meter.measure(deformed, references);
    return {deformed, turned.matrices, mean_motion(sheets.source.points(), deformed, turned),
            Points()};
}

inline SourceState state_of(const LinkedSheets& sheets, const Points& deformed)
{
    return state_of(sheets, deformed, Points::Zero(deformed.rows(), 3));
}

inline double farthest(const Points& a, const Points& b)
{
    return (a - b).rowwise().norm().maxCoeff();
}

}  // namespace sheetmorph::volume::scene
