// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "shapes/draw.h"
#include "shapes/sheets.h"

namespace sheetmorph::shapes
{

//! Points and triangles that grow: what files bring besides a sound sheet.
class GrowingMesh
{
public:
    explicit GrowingMesh(const mesh::TriangleMesh& mesh)
    {
        for (int i = 0; i < mesh.vertex_count(); ++i)
            points_.push_back(mesh.points().row(i));
        for (int t = 0; t < mesh.triangle_count(); ++t)
            triangles_.push_back(mesh.triangles().row(t));
    }

    //! A node of no triangle.
    void add_node(Draw& draw)
    {
        points_.push_back(points_[at_random(points_, draw)]
                          + Eigen::RowVector3d(draw.within(8.0).transpose()));
    }

    //! A triangle that lies in one edge, over a vertex of its own or over one of its corners twice.
    void add_flat_triangle(Draw& draw)
    {
        const Eigen::RowVector3i along = triangles_[at_random(triangles_, draw)];
        int middle = along(0);
        if (draw.happens(0.6))
        {
            middle = static_cast<int>(points_.size());
            points_.push_back(0.5 * (point(along(0)) + point(along(1))));
        }
        const auto place = draw.happens(0.5) ? triangles_.begin() : triangles_.end();
        triangles_.insert(place, Eigen::RowVector3i(along(0), middle, along(1)));
    }

    //! A component of its own over the left end, which is held or driven there.
    void add_island(Draw& draw)
    {
        const mesh::TriangleMesh island = grid(2, 3, 12.0, 18.0);
        const auto first = static_cast<int>(points_.size());
        const Eigen::RowVector3d corner(0.0, draw.number(2.0, 40.0), draw.number(4.0, 9.0));
        for (int i = 0; i < island.vertex_count(); ++i)
            points_.push_back(corner + island.points().row(i));
        for (int t = 0; t < island.triangle_count(); ++t)
            triangles_.push_back((island.triangles().row(t).array() + first).matrix());
    }

    mesh::TriangleMesh mesh() const
    {
        Points points(static_cast<Eigen::Index>(points_.size()), 3);
        for (std::size_t i = 0; i < points_.size(); ++i)
            points.row(static_cast<Eigen::Index>(i)) = points_[i];
        Triangles triangles(static_cast<Eigen::Index>(triangles_.size()), 3);
        for (std::size_t t = 0; t < triangles_.size(); ++t)
            triangles.row(static_cast<Eigen::Index>(t)) = triangles_[t];
        return mesh::TriangleMesh(std::move(points), std::move(triangles));
    }

private:
    template <typename Rows>
    static std::size_t at_random(const Rows& rows, Draw& draw)
    {
        return static_cast<std::size_t>(draw.whole(static_cast<int>(rows.size())));
    }

    const Eigen::RowVector3d& point(int i) const { return points_[static_cast<std::size_t>(i)]; }

    std::vector<Eigen::RowVector3d> points_;
    std::vector<Eigen::RowVector3i> triangles_;
};

}  // namespace sheetmorph::shapes
