// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/soup.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <numeric>
#include <utility>

namespace sheetmorph
{

namespace
{

using Point = CGAL::Simple_cartesian<double>::Point_3;

struct Listener : CGAL::Polygon_mesh_processing::Default_orientation_visitor
{
    std::vector<int>* original;

    void duplicated_vertex(std::size_t vertex, std::size_t)
    {
        original->push_back((*original)[vertex]);
    }
};

bool is_same_sense(const Eigen::RowVector3i& a, const std::array<int, 3>& b)
{
    for (int k = 0; k < 3; ++k)
        if (a(0) == b[k])
            return a(1) == b[(k + 1) % 3];
    return false;
}

}  // namespace

OrientedSoup oriented(const TriangleMesh& mesh)
{
    std::vector<Point> points;
    for (int i = 0; i < mesh.vertex_count(); ++i)
        points.emplace_back(mesh.points()(i, 0), mesh.points()(i, 1), mesh.points()(i, 2));
    std::vector<std::array<std::size_t, 3>> polygons(
        static_cast<std::size_t>(mesh.triangle_count()));
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            polygons[t][k] = static_cast<std::size_t>(mesh.triangles()(t, k));
    OrientedSoup soup;
    soup.original.resize(points.size());
    std::iota(soup.original.begin(), soup.original.end(), 0);
    Listener listener;
    listener.original = &soup.original;
    CGAL::Polygon_mesh_processing::orient_polygon_soup(points, polygons,
                                                       CGAL::parameters::visitor(listener));

    soup.triangles.resize(mesh.triangle_count(), 3);
    soup.manifold_triangles.resize(mesh.triangle_count(), 3);
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        std::array<int, 3> corners;
        for (int k = 0; k < 3; ++k)
        {
            soup.manifold_triangles(t, k) = static_cast<int>(polygons[t][k]);
            corners[k] = soup.original[polygons[t][k]];
            soup.triangles(t, k) = corners[k];
        }
        soup.turned += !is_same_sense(mesh.triangles().row(t), corners);
    }
    return soup;
}

}  // namespace sheetmorph
