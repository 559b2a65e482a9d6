// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/links/control_box.h"

#include "sheetmorph/base/index.h"

#include <Eigen/Geometry>

namespace sheetmorph::assembly
{

namespace
{

// Size of the box of a single point, which has no extent, relative to the assembly. Chosen: a bolt
// with its washer, 20 mm in an assembly of 1 m.
constexpr double single_point_share = 0.02;

// Shortest direction that determines an axis, relative to the assembly. From files with seven
// digits: coordinates are exact to 1e-7 of it.
constexpr double shortest_direction = 1e-6;

Points all_points(const Assembly& assembly)
{
    Eigen::Index count = 0;
    for (const Part& part : assembly.parts)
        count += part.mesh.points().rows();
    Points all(count, 3);
    Eigen::Index row = 0;
    for (const Part& part : assembly.parts)
    {
        all.middleRows(row, part.mesh.points().rows()) = part.mesh.points();
        row += part.mesh.points().rows();
    }
    return all;
}

Vector3 centroid(const Points& points)
{
    return points.colwise().mean().transpose();
}

// Directions from the centre of the assembly to landmarks that distinguish its sides.
std::vector<Vector3> landmark_directions(const Assembly& assembly, const Vector3& centre)
{
    std::vector<Vector3> directions;
    const auto towards = [&](int part, const VertexIds& vertices)
    {
        directions.push_back(centroid(rows_of(assembly.parts[at(part)].mesh.points(), vertices))
                             - centre);
    };
    for (const PartHandle& handle : assembly.handles)
        towards(handle.part, handle.vertices);
    for (const PartRegion& region : assembly.fixed)
        towards(region.part, region.vertices);
    directions.push_back(centroid(assembly.parts[at(assembly.primary)].mesh.points()) - centre);
    for (const Contact& contact : assembly.contacts)
        towards(contact.a.part, contact.a.vertices);
    return directions;
}

// Two different directions make a frame. Without them, the axes of the world are used.
Matrix3 landmark_axes(const Assembly& assembly, const Vector3& centre, double size)
{
    Matrix3 axes = Matrix3::Identity();
    bool has_first = false;
    for (const Vector3& direction : landmark_directions(assembly, centre))
    {
        const Vector3 across =
            has_first ? Vector3(direction - direction.dot(axes.col(0)) * axes.col(0)) : direction;
        if (across.norm() <= shortest_direction * size)
            continue;
        if (!has_first)
        {
            axes.col(0) = across.normalized();
            has_first = true;
            continue;
        }
        axes.col(1) = across.normalized();
        axes.col(2) = axes.col(0).cross(axes.col(1));
        return axes;
    }
    return Matrix3::Identity();
}

}  // namespace

Points rows_of(const Points& points, const VertexIds& ids)
{
    Points rows(static_cast<Eigen::Index>(ids.size()), 3);
    for (std::size_t k = 0; k < ids.size(); ++k)
        rows.row(static_cast<Eigen::Index>(k)) = points.row(ids[k]);
    return rows;
}

Points stacked(const Points& a, const Points& b)
{
    Points all(a.rows() + b.rows(), 3);
    all << a, b;
    return all;
}

ControlBoxes::ControlBoxes(const Assembly& assembly) : everything_(all_points(assembly))
{
    if (everything_.rows() == 0)
        return;
    const double size =
        (everything_.colwise().maxCoeff() - everything_.colwise().minCoeff()).norm();
    const Matrix3 landmarks = landmark_axes(assembly, centroid(everything_), size);
    axes_ = volume::principal_axes(everything_, {}, landmarks);
    for (const Part& part : assembly.parts)
        part_axes_.push_back(part.mesh.vertex_count() == 0
                                 ? axes_
                                 : volume::principal_axes(part.mesh.points(), {}, axes_));
    options_.single_point_size = single_point_share * size;
}

volume::OrientedBox ControlBoxes::around_everything() const
{
    return volume::oriented_box(everything_, axes_, options_);
}

volume::OrientedBox ControlBoxes::around(const Points& points, int part) const
{
    return volume::oriented_box(points, volume::principal_axes(points, {}, part_axes_[at(part)]),
                                options_);
}

std::vector<char> inside(const volume::OrientedBox& box, const Points& points)
{
    std::vector<char> is_inside(static_cast<std::size_t>(points.rows()));
    for (Eigen::Index row = 0; row < points.rows(); ++row)
    {
        const Vector3 local = box.axes.transpose() * (points.row(row).transpose() - box.centre);
        is_inside[static_cast<std::size_t>(row)] =
            (local.cwiseAbs() - box.half_extents).maxCoeff() <= 0.0;
    }
    return is_inside;
}

}  // namespace sheetmorph::assembly
